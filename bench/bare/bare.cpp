// gluray-bench-bare: Embree alone on the frame benchmark's meshes and views, with Lambert shading
// and nothing else: the yardstick for everything GLuRay adds.
#include "bench/bare/scene.h"
#include "bench/data/isosurface.h"
#include "bench/data/png.h"
#include "bench/data/report.h"
#include "bench/data/wavelet.h"

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <chrono>
#include <cstdio>
#include <exception>

namespace {

using namespace gluray::bench;
using Seconds = std::chrono::duration<double>;
using Clock = std::chrono::steady_clock;

struct Options {
  double millionTriangles = 1;
  std::string quality = "full", dump;
  int frames = 20, threads = 0;
  bool orbit = false;
};

void run(const Options& options) {
  const int threads = options.threads > 0 ? options.threads : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, size_t(threads));
  const TriangleMesh mesh = [&] {
    const Volume volume = wavelet();
    const auto [low, high] = volume.range();
    return isosurfaces(volume, evenIsovalues(low, high, waveletSurfaces(options.millionTriangles)));
  }();
  Measurement m{.program = "bare",
                .path = options.quality,
                .renderer = {},
                .triangles = mesh.triangleCount(),
                .frameSeconds = {}};
  m.renderer = "Embree " RTC_VERSION_STRING ", " + std::to_string(threads) + " threads";

  const Clock::time_point start = Clock::now();
  const BareScene scene(mesh, options.quality, threads);
  m.buildSeconds = Seconds(Clock::now() - start).count();
  std::vector<uint8_t> pixels(size_t(kImageSize) * kImageSize * 4);
  const int orbitFrames = options.orbit ? options.frames : 0;
  scene.render(orbitPose(0, orbitFrames), pixels);
  Clock::time_point last = Clock::now();
  m.firstImageSeconds = Seconds(last - start).count();
  for (int frame = 1; frame <= options.frames; ++frame) {
    scene.render(orbitPose(options.orbit ? frame : 0, orbitFrames), pixels);
    const Clock::time_point now = Clock::now();
    m.frameSeconds.push_back(Seconds(now - last).count());
    last = now;
  }
  const ResidentBytes resident = residentBytes();
  if (!options.dump.empty()) {
    scene.render(orbitPose(0, 0), pixels);
    writePng(imageFromGl(kImageSize, kImageSize, pixels), options.dump);
  }
  std::printf("%s\n", jsonLine(m, resident).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Traces isosurfaces of the Wavelet with Embree alone and prints its frame times as JSON.");
  app.add_option("--triangles", options.millionTriangles, "millions of triangles, about")
      ->check(CLI::Range(0.1, 256.0));
  app.add_option("--bvh", options.quality, "fast, full or compact")
      ->check(CLI::IsMember(std::vector<std::string>{"fast", "full", "compact"}));
  app.add_option("--threads", options.threads, "0: one a core")->check(CLI::Range(0, 1024));
  app.add_option("--frames", options.frames, "frames to measure after the first")
      ->check(CLI::Range(0, 1000000));
  app.add_flag("--orbit", options.orbit, "the camera goes once around in these frames; else it stands still");
  app.add_option("--dump", options.dump, "write the first view as PNG");
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-bare: %s\n", error.what());
    return 1;
  }
  return 0;
}
