// gluray-bench-ospray: frame::Renderer and OSPRay in turn in one process, on the same mesh, views and light:
// seconds a frame, and the error of each against its own picture of many samples.
#include "bench/data/isosurface.h"
#include "bench/data/orbit.h"
#include "bench/data/picture_error.h"
#include "bench/data/report.h"
#include "bench/data/wavelet.h"
#include "bench/ospray/ospray_scene.h"
#include "bench/render/settings.h"
#include "bench/render/wavelet_snapshot.h"
#include "frame/renderer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
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
  bench::OsprayScene::Options ospray;
  std::vector<std::string> settings;
};

double seconds(const std::function<void()>& work) {
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Our renderer on the benchmark's snapshot.
class Ours {
 public:
  Ours(const Options& options, const bench::TriangleMesh& mesh) : snapshot_(bench::waveletSnapshot(mesh)) {
    snapshot_.settings.threads = options.threads;
    snapshot_.settings.bvh = BvhQuality::full;
    for (const std::string& setting : options.settings) bench::set(snapshot_.settings, setting);
    // Towards the light, in eye space: above the viewer's right shoulder.
    snapshot_.shadings[0].lights[0].position = {0.45f, 0.6f, 0.66f, 0};
  }
  void render(const bench::CameraPose& pose, Image& image) {
    bench::lookFrom(snapshot_, pose);
    ++snapshot_.frame;
    std::string error;
    scene::TraceCost cost;
    if (!renderer_.render(snapshot_, image, cost, error)) throw std::runtime_error(error);
  }
  /// The mean of many passes.
  Pixels reference(const bench::CameraPose& pose, int passes) {
    const scene::LightSampling was = snapshot_.lightSampling;
    snapshot_.lightSampling = {};
    snapshot_.wideColors = true;
    std::vector<double> sum;
    Image image;
    for (int pass = 0; pass < passes; ++pass) {
      snapshot_.lightSampling.pass = static_cast<uint32_t>(pass);
      render(pose, image);
      sum.resize(image.wideColor.size());
      for (size_t i = 0; i < sum.size(); ++i) sum[i] += image.wideColor[i];
    }
    Pixels pixels(sum.size() / 4);
    for (size_t i = 0; i < pixels.size(); ++i)
      for (unsigned c = 0; c < 4; ++c)
        pixels[i] |= static_cast<uint32_t>(std::lround(255 * std::clamp(sum[4 * i + c] / passes, 0.0, 1.0)))
                     << (8 * c);
    snapshot_.wideColors = false;
    snapshot_.lightSampling = was;
    return pixels;
  }

 private:
  scene::Snapshot snapshot_;
  frame::Renderer renderer_;
};

/// The light of Ours, world space: the way it shines.
std::array<double, 3> lightOf(const bench::CameraPose& pose) {
  std::array<double, 3> way{};
  for (size_t axis = 0; axis < 3; ++axis)
    way[axis] = -(0.45 * pose.right[axis] + 0.6 * pose.up[axis] + 0.66 * pose.backward[axis]);
  return way;
}

void run(const Options& options) {
  const bench::Volume volume = bench::wavelet();
  const auto [low, high] = volume.range();
  const bench::TriangleMesh mesh = bench::isosurfaces(
      volume, bench::evenIsovalues(low, high, bench::waveletSurfaces(options.millionTriangles)));
  bench::OsprayScene theirs(mesh, options.ospray);
  Ours ours(options, mesh);
  std::vector<double> ourSeconds, theirSeconds;
  Image image;
  for (int frame = 0; frame <= options.frames; ++frame) {
    const bench::CameraPose pose = bench::orbitPose(frame, 360);
    theirs.shine(lightOf(pose));
    const double a = seconds([&] { ours.render(pose, image); });
    const double b = seconds([&] { theirs.render(pose, false); });
    if (frame > 0) ourSeconds.push_back(a), theirSeconds.push_back(b);
  }
  const bench::CameraPose last = bench::orbitPose(options.frames, 360);
  std::vector<uint8_t> hit(image.depth.size());
  for (size_t i = 0; i < hit.size(); ++i) hit[i] = image.depth[i] != Image::kMiss;
  const Pixels theirPicture = theirs.pixels();
  for (int n = 0; n < options.reference; ++n) theirs.render(last, n > 0);
  const double theirError = bench::psnr(theirPicture, theirs.pixels(), hit);
  const double ourError = bench::psnr(image.color, ours.reference(last, options.reference), hit);
  std::printf(
      "{\"triangles\": %zu, \"gluray_s\": %.5f, \"gluray_db\": %.2f, \"ospray_s\": %.5f, "
      "\"ospray_db\": %.2f}\n",
      mesh.triangleCount(), bench::median(ourSeconds), ourError, bench::median(theirSeconds), theirError);
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
  app.add_option("--reference", options.reference, "passes of the reference pictures")
      ->check(CLI::Range(1, 100000));
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
