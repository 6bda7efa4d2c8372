// gluray-bench-refine: noise and time of images at rest, on the Wavelet's isosurfaces at 1024x1024. One
// line a figure.
#include "bench/data/image_error.h"
#include "bench/data/isosurface.h"
#include "bench/data/orbit.h"
#include "bench/data/report.h"
#include "bench/data/wavelet.h"
#include "bench/render/wavelet_snapshot.h"
#include "frame/refinement/refiner.h"
#include "frame/tracing/renderer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace gluray;

struct Options {
  double millionTriangles = 1;
  int threads = 2, samples = 4, reference = 1024, spp = 1;
  bool paths = false, layers = false;
};

void figure(const std::string& name, double value, const char* unit) {
  std::printf("%-28s %10.3f %s\n", name.c_str(), value, unit);
  std::fflush(stdout);
}

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// dB, of the pixels that hit something.
double psnr(const Image& image, const Image& reference) {
  std::vector<uint8_t> hits(reference.depth.size());
  for (size_t i = 0; i < hits.size(); ++i) hits[i] = reference.depth[i] != Image::kMiss;
  return bench::psnr(image.color, reference.color, hits);
}

/// Refines images of one scene.
class Bench {
 public:
  explicit Bench(const scene::Snapshot& snapshot) : snapshot_(snapshot) {
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
    const auto start = std::chrono::steady_clock::now();
    while (passes ? refinement.passes() < passes : !refiner.finished())
      if (!refiner.pass(trace, 0, cost, error)) throw std::runtime_error(error);
    result.seconds = secondsSince(start);
    const auto shown = std::chrono::steady_clock::now();
    refiner.show(result.image);
    result.showSeconds = secondsSince(shown);
    result.passes = refinement.passes(), result.tiles = refinement.tracedTiles();
    return result;
  }

 private:
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

void run(const Options& options) {
  const bench::Volume volume = bench::wavelet();
  const auto [low, high] = volume.range();
  const bench::TriangleMesh mesh = bench::isosurfaces(
      volume, bench::evenIsovalues(low, high, bench::waveletSurfaces(options.millionTriangles)));
  scene::Snapshot snapshot = bench::waveletSnapshot(mesh);
  bench::lookFrom(snapshot, bench::orbitPose(0, 360));
  Settings& settings = snapshot.settings;
  settings.bvh = BvhQuality::full, settings.threads = options.threads;
  settings.ao.enabled = !options.paths;
  if (options.paths) settings.integrator = LightIntegrator::path;
  settings.ao.samples = settings.path.samples = options.samples;
  settings.spp = options.spp;
  if (options.layers) makeLayers(snapshot);
  Bench bench(snapshot);
  figure("triangles", static_cast<double>(mesh.triangleCount()) * 1e-6, "million");
  Settings many = settings;
  many.refine.adaptive = false;
  const Image truth =
      bench.refined(many, static_cast<uint32_t>(std::max(options.reference / options.samples, 1))).image;
  compareSmoothing(bench, many, truth);
  if (options.spp <= 1 && !options.layers) compareAdaptive(bench, settings, truth);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Noise and time of images at rest, on isosurfaces of the Wavelet.");
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
  app.add_flag("--paths", options.paths, "trace paths instead of ambient occlusion");
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-refine: %s\n", error.what());
    return 1;
  }
  return 0;
}
