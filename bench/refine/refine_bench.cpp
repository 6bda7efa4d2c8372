// gluray-bench-refine: noise and time of images at rest, on the Wavelet's isosurfaces and other scenes.
// One line a figure.
#include "bench/data/image_error.h"
#include "bench/data/orbit.h"
#include "bench/data/report.h"
#include "bench/refine/scenes.h"
#include "bench/refine/until_goal.h"
#include "bench/render/settings.h"
#include "frame/refinement/oidn_library.h"
#include "frame/refinement/refiner.h"
#include "frame/tracing/renderer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace gluray;

struct Options {
  double millionTriangles = 1;
  int threads = 2, samples = 4, reference = 1024, spp = 1, size = bench::kImageSize;
  std::string scene = "wavelet", light = "occlusion";
  bool denoisers = false, layers = false, untilGoal = false;
  bench::Goal goal;
};

void figure(const std::string& name, double value, const char* unit) {
  std::printf("%-28s %10.3f %s\n", name.c_str(), value, unit);
  std::fflush(stdout);
}

double wallSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Seconds that all threads of the process have computed.
double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// dB, of the pixels that hit something.
double psnr(const Image& image, const Image& reference) {
  std::vector<uint8_t> hits(reference.depth.size());
  for (size_t i = 0; i < hits.size(); ++i) hits[i] = reference.depth[i] != Image::kMiss;
  return bench::psnr(image.color, reference.color, hits);
}

/// Refines images of one scene.
class Bench {
 public:
  /// `clock` gives the seconds of the results.
  Bench(const scene::Snapshot& snapshot, double (*seconds)()) : clock_(seconds), snapshot_(snapshot) {
    Image image;
    scene::TraceCost cost;
    std::string error;
    if (!renderer_.render(snapshot, image, cost, error)) throw std::runtime_error(error);
  }
  struct Result {
    Image image;
    double seconds = 0, showSeconds = 0;
    uint32_t passes = 0;
    uint64_t tiles = 0;
  };
  /// `passes`: 0: until it is finished.
  Result refined(const Settings& settings, uint32_t passes) {
    scene::Snapshot s = snapshot_;
    s.settings = settings;
    frame::Refinement refinement;
    frame::Refiner refiner(s, refinement);
    Result result;
    const frame::Trace trace = [&](const auto& snapshot, Image& image, auto& cost, std::string& error) {
      return renderer_.render(snapshot, image, cost, error);
    };
    scene::TraceCost cost;
    std::string error;
    const double start = clock_();
    while (passes ? refinement.passes() < passes : !refiner.finished())
      if (!refiner.pass(trace, 0, cost, error)) throw std::runtime_error(error);
    result.seconds = clock_() - start;
    const double shown = clock_();
    refiner.show(result.image);
    result.showSeconds = clock_() - shown;
    result.passes = refinement.passes(), result.tiles = refinement.tracedTiles();
    return result;
  }

 private:
  double (*clock_)();
  scene::Snapshot snapshot_;
  frame::Renderer renderer_;
};

void compareSmoothing(Bench& bench, const Settings& settings, const Image& truth) {
  Settings smooth = settings;
  smooth.denoise = Denoise::filter;
  for (const uint32_t passes : {1u, 4u, 16u}) {
    const Bench::Result plain = bench.refined(settings, passes), filtered = bench.refined(smooth, passes);
    const std::string n = std::to_string(passes);
    figure("passes_" + n + "_psnr", psnr(plain.image, truth), "dB");
    figure("passes_" + n + "_smooth_psnr", psnr(filtered.image, truth), "dB");
    if (passes != 4) continue;
    figure("pass_ms", 1e3 * plain.seconds / passes, "ms");
    figure("guides_share", (filtered.seconds - plain.seconds) / (plain.seconds / passes), "of a pass");
    figure("smooth_share", (filtered.showSeconds - plain.showSeconds) / (plain.seconds / passes),
           "of a pass");
  }
}

void compareAdaptive(Bench& bench, Settings settings, const Image& truth) {
  for (const bool adaptive : {false, true}) {
    settings.refine.adaptive = adaptive;
    const Bench::Result result = bench.refined(settings, 0);
    const std::string name = adaptive ? "adaptive_" : "all_";
    figure(name + "psnr", psnr(result.image, truth), "dB");
    figure(name + "passes", result.passes, "passes");
    figure(name + "tiles", static_cast<double>(result.tiles) * 1e-3, "thousand");
    figure(name + "s", result.seconds, "s");
  }
}

/// Makes all surfaces translucent, in layers over an empty background.
void makeLayers(scene::Snapshot& snapshot) {
  for (scene::Instance& instance : snapshot.instances)
    for (scene::MaterialPair& pair : instance.materials) pair.front.diffuse.a = pair.back.diffuse.a = 0.4f;
  auto layers = std::make_shared<scene::Layers>();
  const size_t width = static_cast<size_t>(snapshot.region.width);
  layers->opaqueDepth.assign(width * static_cast<size_t>(snapshot.region.height), -1.0f);
  snapshot.layers = layers;
}

/// The mean of 1, 4, 16, 64 passes as each denoiser shows it, and what passes and denoisers take.
void compareDenoisers(Bench& bench, const Settings& settings, const Image& truth) {
  const std::map<std::string, Denoise> kinds{
      {"plain", Denoise::off}, {"filter", Denoise::filter}, {"oidn", Denoise::oidn}};
  std::string why;
  const bool found = frame::oidnLibrary(why) != nullptr;
  if (!found) std::fprintf(stderr, "without Open Image Denoise: %s\n", why.c_str());
  for (const uint32_t passes : {1u, 4u, 16u, 64u})
    for (const auto& [name, kind] : kinds) {
      if (kind == Denoise::oidn && !found) continue;
      Settings with = settings;
      with.denoise = kind;
      const Bench::Result result = bench.refined(with, passes);
      figure("passes_" + std::to_string(passes) + "_" + name + "_psnr", psnr(result.image, truth), "dB");
      if (passes != 16) continue;
      figure(name + "_passes_s", result.seconds / passes, "CPU seconds a pass");
      figure(name + "_show_s", result.showSeconds, "CPU seconds");
    }
}

/// Settings of each light.
const std::map<std::string, std::vector<std::string>> kLights{
    {"occlusion", {"ao=on"}},
    {"shadows", {"ao=on", "shadows=on", "shadows.size=6", "lights=program+key"}},
    {"paths", {"integrator=path"}},
    {"sky", {"integrator=path", "environment=gradient", "environment.strength=0.8", "shadows.size=6"}}};

void run(const Options& options) {
  bench::RefineScene scene = bench::refineScene(options.scene, options.millionTriangles, options.size);
  Settings& settings = scene.snapshot.settings;
  settings.bvh = BvhQuality::full, settings.threads = options.threads;
  for (const std::string& assignment : kLights.at(options.light)) bench::set(settings, assignment);
  settings.ao.samples = settings.shadows.samples = settings.path.samples = options.samples;
  settings.spp = options.spp;
  if (options.layers) makeLayers(scene.snapshot);
  Bench bench(scene.snapshot, options.denoisers ? cpuSeconds : wallSeconds);
  figure("triangles", static_cast<double>(scene.mesh->triangleCount()) * 1e-6, "million");
  Settings many = settings;
  many.refine.adaptive = false;
  const auto refined = [&] {
    return bench.refined(many, static_cast<uint32_t>(std::max(options.reference / options.samples, 1))).image;
  };
  const Image truth = bench::keptImage(options.goal.keep, scene.snapshot, refined);
  if (options.untilGoal) return bench::printUntilGoal(scene.snapshot, truth, options.goal);
  if (options.denoisers) return compareDenoisers(bench, many, truth);
  compareSmoothing(bench, many, truth);
  if (options.spp <= 1 && !options.layers) compareAdaptive(bench, settings, truth);
}

std::vector<std::string> namesOf(const auto& map) {
  std::vector<std::string> names;
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Noise and time of images at rest.");
  app.add_option("--triangles", options.millionTriangles, "millions of triangles, about")
      ->check(CLI::Range(0.1, 256.0));
  app.add_option("--threads", options.threads, "0: one a core")->check(CLI::Range(0, 1024));
  app.add_option("--samples", options.samples, "rays or paths a pixel in each pass")
      ->check(CLI::Range(1, 64));
  app.add_option("--reference", options.reference, "samples of the image to compare with")
      ->check(CLI::Range(1, 65536));
  app.add_option("--spp", options.spp, "samples of a pixel, which share its rays")
      ->check(CLI::Range(1, 1024));
  app.add_flag("--layers", options.layers, "translucent surfaces in layers");
  app.add_option("--size", options.size, "pixels in the middle of the image, both ways")
      ->check(CLI::Range(16, bench::kImageSize));
  app.add_option("--scene", options.scene)->check(CLI::IsMember(bench::refineSceneNames()));
  app.add_option("--light", options.light)->check(CLI::IsMember(namesOf(kLights)));
  app.add_flag("--denoisers", options.denoisers, "compare denoisers");
  const auto* const goal = app.add_option("--goal", options.goal.psnr,
                                          "dB: how many frames of the local look it takes until then");
  app.add_option("--rounds", options.goal.rounds, "with --goal: rounds in turn with the local look")
      ->check(CLI::Range(1, 1000));
  app.add_option("--passes", options.goal.passes, "with --goal: and no more")->check(CLI::Range(1, 100000));
  app.add_option("--denoise", options.goal.denoise, "with --goal")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Denoise>{
          {"off", Denoise::off}, {"filter", Denoise::filter}, {"oidn", Denoise::oidn}}));
  app.add_option("--keep", options.goal.keep, "the file that keeps the image to compare with");
  CLI11_PARSE(app, argc, argv);
  options.untilGoal = goal->count() > 0;
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-refine: %s\n", error.what());
    return 1;
  }
  return 0;
}
