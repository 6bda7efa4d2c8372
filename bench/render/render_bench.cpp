// gluray-bench-render: frame::Renderer and the bare Embree loop on the same mesh and views, in turn in
// one process: the cost of shading, depth and image on top of the rays, without OpenGL and windows.
#include "bench/bare/scene.h"
#include "bench/data/isosurface.h"
#include "bench/data/orbit.h"
#include "bench/data/png.h"
#include "bench/data/report.h"
#include "bench/data/wavelet.h"
#include "bench/render/wavelet_snapshot.h"
#include "frame/tracing/renderer.h"

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <chrono>
#include <cstdio>
#include <exception>

namespace {

using namespace gluray;
using Clock = std::chrono::steady_clock;

struct Options {
  double millionTriangles = 1;
  std::string quality = "full", shading = "pixel", dump;
  int frames = 20, threads = 0;
  bool noBare = false, instances = false;
};

// The bare loop's image, with the given options.
scene::Snapshot snapshotOf(const Options& options, const bench::TriangleMesh& mesh) {
  scene::Snapshot s = bench::waveletSnapshot(mesh);
  s.settings.threads = options.threads;
  s.settings.bvh = options.quality == "fast"      ? BvhQuality::fast
                   : options.quality == "compact" ? BvhQuality::compact
                   : options.quality == "least"   ? BvhQuality::least
                                                  : BvhQuality::full;
  s.settings.shading = options.shading == "vertex" ? ShadingRate::vertex : ShadingRate::pixel;
  if (options.instances) s.instances[0].worldFromObject[3] = {1e-3f, 0, 0, 1};
  return s;
}

double seconds(Clock::time_point since) {
  return std::chrono::duration<double>(Clock::now() - since).count();
}

void run(const Options& options) {
  const int threads = options.threads > 0 ? options.threads : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(threads));
  const bench::Volume volume = bench::wavelet();
  const auto [low, high] = volume.range();
  const bench::TriangleMesh mesh = bench::isosurfaces(
      volume, bench::evenIsovalues(low, high, bench::waveletSurfaces(options.millionTriangles)));
  std::unique_ptr<bench::BareScene> bare;
  if (!options.noBare) bare = std::make_unique<bench::BareScene>(mesh, options.quality, threads);

  frame::Renderer renderer;
  scene::Snapshot snapshot = snapshotOf(options, mesh);
  std::vector<uint8_t> pixels(size_t{bench::kImageSize} * bench::kImageSize * 4);
  Image image;
  scene::TraceCost statistics;
  std::string error;
  std::vector<double> bareSeconds, ourSeconds;
  double build = 0;
  for (int frame = 0; frame <= options.frames; ++frame) {
    const bench::CameraPose pose = bench::orbitPose(frame, options.frames);
    Clock::time_point start = Clock::now();
    if (bare) bare->render(pose, pixels);
    if (frame > 0) bareSeconds.push_back(seconds(start));
    bench::lookFrom(snapshot, pose);
    start = Clock::now();
    if (!renderer.render(snapshot, image, statistics, error)) throw std::runtime_error(error);
    if (frame > 0)
      ourSeconds.push_back(seconds(start));
    else
      build = statistics.buildSeconds;
  }
  const double a = bench::median(bareSeconds), b = bench::median(ourSeconds);
  std::printf(
      "%.2fM triangles, build %.2f s, %.1f bytes/triangle: bare %.2f ms, renderer %.2f ms, %.1f %% of bare "
      "fps\n",
      static_cast<double>(mesh.triangleCount()) / 1e6, build,
      static_cast<double>(statistics.bvhBytes) / static_cast<double>(mesh.triangleCount()), a * 1e3, b * 1e3,
      a / b * 100);
  if (!options.dump.empty()) {
    for (size_t i = 0; i < image.color.size(); ++i) {
      for (size_t c = 0; c < 4; ++c) pixels[4 * i + c] = static_cast<uint8_t>(image.color[i] >> (8 * c));
    }
    bench::writePng(bench::imageFromGl(bench::kImageSize, bench::kImageSize, pixels), options.dump);
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Times the renderer and the bare Embree loop on isosurfaces of the Wavelet.");
  app.add_option("--triangles", options.millionTriangles, "millions of triangles, about")
      ->check(CLI::Range(0.1, 256.0));
  app.add_option("--bvh", options.quality, "fast, full, compact or least")
      ->check(CLI::IsMember(std::vector<std::string>{"fast", "full", "compact", "least"}));
  app.add_option("--shading", options.shading, "pixel or vertex")
      ->check(CLI::IsMember(std::vector<std::string>{"pixel", "vertex"}));
  app.add_option("--threads", options.threads, "0: one a core")->check(CLI::Range(0, 1024));
  app.add_option("--frames", options.frames, "frames to measure")->check(CLI::Range(1, 1000000));
  app.add_flag("--no-bare", options.noBare, "leave the bare loop out");
  app.add_flag("--instances", options.instances, "place the mesh through an instance transform");
  app.add_option("--dump", options.dump, "write the last view as PNG");
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-render: %s\n", error.what());
    return 1;
  }
  return 0;
}
