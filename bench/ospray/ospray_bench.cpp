// gluray-bench-ospray: frame::Renderer and OSPRay in turn in one process, on the same mesh, views and light:
// seconds a frame, and the error of each against its own image of many samples.
#include "bench/data/image_error.h"
#include "bench/data/isosurface.h"
#include "bench/data/orbit.h"
#include "bench/data/report.h"
#include "bench/data/wavelet.h"
#include "bench/ospray/ospray_scene.h"
#include "bench/ospray/our_scene.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>

namespace {

using namespace gluray;
using Clock = std::chrono::steady_clock;
using Pixels = std::vector<uint32_t>;

struct Options {
  double millionTriangles = 1;
  int frames = 20, threads = 0, reference = 256;
  double decibels = 0;  // 0: frames of an animation; otherwise images at rest
  bench::OsprayScene::Options ospray;
  std::vector<std::string> settings;
};

double seconds(const std::function<void()>& work) {
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The light of OurScene, world space: the way it shines.
std::array<double, 3> lightOf(const bench::CameraPose& pose) {
  std::array<double, 3> way{};
  for (size_t axis = 0; axis < 3; ++axis)
    way[axis] = -(0.45 * pose.right[axis] + 0.6 * pose.up[axis] + 0.66 * pose.backward[axis]);
  return way;
}

bench::TriangleMesh meshOf(const Options& options) {
  const bench::Volume volume = bench::wavelet();
  const auto [low, high] = volume.range();
  return bench::isosurfaces(
      volume, bench::evenIsovalues(low, high, bench::waveletSurfaces(options.millionTriangles)));
}

/// The mean of green where `hits` is not 0, of 255: tells whether both images are as bright.
double brightness(const Pixels& pixels, const std::vector<uint8_t>& hits) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < pixels.size(); ++i)
    if (hits[i]) sum += pixels[i] >> 8 & 255, ++count;
  return sum / count;
}

void printBrightness(const Pixels& ours, const Pixels& theirs, const std::vector<uint8_t>& hits) {
  std::printf("\"gluray_green\": %.1f, \"ospray_green\": %.1f, ", brightness(ours, hits),
              brightness(theirs, hits));
}

/// Frames of an animation in turn, and the error of the last one.
void compareFrames(const Options& options, bench::OurScene& ours, bench::OsprayScene& theirs) {
  std::vector<double> ourSeconds, theirSeconds;
  Image image;
  for (int frame = 0; frame <= options.frames; ++frame) {
    const bench::CameraPose pose = bench::orbitPose(frame, 360);
    theirs.shine(lightOf(pose));
    const double a = seconds([&] { ours.frame(pose, image); });
    const double b = seconds([&] { theirs.render(pose, false); });
    if (frame > 0) ourSeconds.push_back(a), theirSeconds.push_back(b);
  }
  const bench::CameraPose last = bench::orbitPose(options.frames, 360);
  const Pixels theirImage = theirs.pixels();
  for (int n = 0; n < options.reference; ++n) theirs.render(last, n > 0), ours.pass(last, n > 0);
  const std::vector<uint8_t> hits = ours.hits();
  printBrightness(ours.pixels(), theirs.pixels(), hits);
  std::printf("\"gluray_s\": %.5f, \"gluray_db\": %.2f, \"ospray_s\": %.5f, \"ospray_db\": %.2f",
              bench::median(ourSeconds), bench::psnr(image.color, ours.pixels(), hits),
              bench::median(theirSeconds), bench::psnr(theirImage, theirs.pixels(), hits));
}

struct Reached {
  double seconds = 0;
  int passes = 0;
};

/// Passes, and their time, until the image is as near to its reference as `decibels` say.
template <class Pass, class Show>
Reached reach(double decibels, const Pixels& reference, const std::vector<uint8_t>& hits, Pass&& pass,
              Show&& show) {
  constexpr int kMax = 4096;
  Reached reached;
  do reached.seconds += seconds([&] { pass(reached.passes > 0); });
  while (++reached.passes < kMax && bench::psnr(show(), reference, hits) < decibels);
  return reached;
}

/// The time of each, in turn, until its image at rest has little noise.
void compareRest(const Options& options, bench::OurScene& ours, bench::OsprayScene& theirs) {
  const bench::CameraPose pose = bench::orbitPose(0, 360);
  theirs.shine(lightOf(pose));
  const auto ourPass = [&](bool more) { ours.pass(pose, more); };
  const auto theirPass = [&](bool more) { theirs.render(pose, more); };
  for (int n = 0; n < options.reference; ++n) ourPass(n > 0), theirPass(n > 0);
  const Pixels ourReference = ours.pixels(), theirReference = theirs.pixels();
  const std::vector<uint8_t> hits = ours.hits();
  printBrightness(ourReference, theirReference, hits);
  std::vector<double> ourSeconds, theirSeconds;
  int ourPasses = 0, theirPasses = 0;
  for (int round = 0; round < 3; ++round) {
    const Reached a = reach(options.decibels, ourReference, hits, ourPass, [&] { return ours.pixels(); });
    const Reached b =
        reach(options.decibels, theirReference, hits, theirPass, [&] { return theirs.pixels(); });
    ourSeconds.push_back(a.seconds), theirSeconds.push_back(b.seconds);
    ourPasses = a.passes, theirPasses = b.passes;
  }
  std::printf("\"gluray_s\": %.4f, \"gluray_passes\": %d, \"ospray_s\": %.4f, \"ospray_passes\": %d",
              bench::median(ourSeconds), ourPasses, bench::median(theirSeconds), theirPasses);
}

void run(const Options& options) {
  const bench::TriangleMesh mesh = meshOf(options);
  bench::OsprayScene theirs(mesh, options.ospray);
  bench::OurScene ours(mesh, options.threads, options.settings);
  std::printf("{\"triangles\": %zu, ", mesh.triangleCount());
  if (options.decibels > 0)
    compareRest(options, ours, theirs);
  else
    compareFrames(options, ours, theirs);
  std::printf("}\n");
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Times GLuRay's renderer and OSPRay in turn on isosurfaces of the Wavelet; prints JSON.");
  app.add_option("--triangles", options.millionTriangles, "millions of triangles, about")
      ->check(CLI::Range(0.1, 256.0));
  app.add_option("--frames", options.frames, "frames to measure, a degree of the orbit apart")
      ->check(CLI::Range(1, 100000));
  app.add_option("--threads", options.threads, "0: one a core")->check(CLI::Range(0, 1024));
  app.add_option("--reference", options.reference, "passes of the reference images")
      ->check(CLI::Range(1, 100000));
  app.add_option("--until", options.decibels,
                 "dB: time images at rest until they are so near to the reference")
      ->check(CLI::Range(1.0, 60.0));
  app.add_option("--renderer", options.ospray.renderer, "OSPRay's: scivis or pathtracer")
      ->check(CLI::IsMember(std::vector<std::string>{"scivis", "pathtracer"}));
  app.add_option("--ao", options.ospray.occlusionSamples, "occlusion samples of scivis")
      ->check(CLI::Range(0, 4096));
  app.add_option("--ao-distance", options.ospray.occlusionDistance, "their length, world units");
  app.add_option("--set", options.settings, "a setting of GLuRay, NAME=VALUE");
  CLI11_PARSE(app, argc, argv);
  options.ospray.threads = options.threads;
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-ospray: %s\n", error.what());
    return 1;
  }
  return 0;
}
