// gluray-bench-mesh: writes an isosurface as a PLY file, from a NIfTI volume or from the Wavelet.
#include "bench/data/isosurface.h"
#include "bench/data/nifti.h"
#include "bench/data/wavelet.h"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <exception>
#include <mutex>

namespace {

using namespace gluray::bench;

/// Shows progress on stderr: a changing percentage on a terminal, one line a step elsewhere.
class Steps {
 public:
  explicit Steps(const char* what) : what_(what), terminal_(isatty(STDERR_FILENO) != 0) {
    std::fprintf(stderr, terminal_ ? "%s ..." : "%s\n", what);
  }
  ~Steps() {
    if (terminal_) std::fprintf(stderr, "\r%s: done\n", what_);
  }
  void show(double done) {
    if (!terminal_) return;
    const int percent = int(100 * done);
    if (percent > shown_.exchange(percent)) std::fprintf(stderr, "\r%s: %3d %%", what_, percent);
  }

 private:
  const char* what_;
  bool terminal_;
  std::atomic<int> shown_{-1};
};

struct Options {
  std::string volume, out;
  double isovalue = 0;
  int refine = 1, smooth = 0, halfExtent = 100, surfaces = 3;
};

Volume headVolume(const Options& options) {
  Volume volume = [&] {
    Steps steps("reading the volume");
    return readNifti(options.volume);
  }();
  if (options.refine > 1) {
    Steps steps("refining the volume");
    volume = refined(volume, options.refine);
  }
  if (options.smooth > 0) {
    Steps steps("smoothing the volume");
    volume = smoothed(volume, options.smooth);
  }
  return volume;
}

TriangleMesh makeMesh(const Options& options) {
  Volume volume;
  std::vector<float> isovalues{float(options.isovalue)};
  if (options.volume.empty()) {
    volume = wavelet(options.halfExtent);
    const auto [low, high] = volume.range();
    isovalues = evenIsovalues(low, high, options.surfaces);
  } else {
    volume = headVolume(options);
  }
  Steps steps("meshing");
  return isosurfaces(volume, isovalues, [&](double done) { steps.show(done); });
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Writes an isosurface as a binary PLY file.");
  auto* volume = app.add_option("--volume", options.volume, "NIfTI-1 volume; without one, the Wavelet");
  app.add_option("--isovalue", options.isovalue, "value of the surface in the volume")->needs(volume);
  app.add_option("--refine", options.refine, "refine the volume so many times")->check(CLI::Range(1, 8));
  app.add_option("--smooth", options.smooth, "smoothing passes over the volume")->check(CLI::Range(0, 100));
  app.add_option("--surfaces", options.surfaces, "surfaces of the Wavelet")
      ->check(CLI::Range(1, 1000))
      ->excludes(volume);
  app.add_option("--half-extent", options.halfExtent, "the Wavelet has 2n + 1 points a side")
      ->check(CLI::Range(1, 500));
  app.add_option("--out", options.out, "PLY file to write")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    const TriangleMesh mesh = makeMesh(options);
    if (mesh.triangleCount() == 0) throw std::runtime_error("the volume has no such surface");
    Steps steps("writing");
    writePly(mesh, options.out);
    std::printf("%s: %zu triangles, %zu vertices\n", options.out.c_str(), mesh.triangleCount(),
                mesh.positions.size());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "\ngluray-bench-mesh: %s\n", error.what());
    return 1;
  }
  return 0;
}
