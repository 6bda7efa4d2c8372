// gluray-bench-client: a small fixed-function OpenGL program of the kind the frame benchmark measures. It
// knows nothing of GLuRay: it draws isosurfaces of the Wavelet with plain OpenGL 1.5 and prints what it
// measured as a line of JSON.
#include "bench/client/paths.h"
#include "bench/client/scene.h"
#include "bench/client/window.h"
#include "bench/data/bumpy_spheres.h"
#include "bench/data/isosurface.h"
#include "bench/data/mesh_file.h"
#include "bench/data/orbit.h"
#include "bench/data/png.h"
#include "bench/data/report.h"
#include "bench/data/wavelet.h"

#include <CLI/CLI.hpp>
#include <GL/gl.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <memory>
#include <stdexcept>
#include <thread>

namespace {

using namespace gluray::bench;
using Seconds = std::chrono::duration<double>;
using Clock = std::chrono::steady_clock;

struct Options {
  double millionTriangles = 1;
  std::string path = "list", dump, mesh;
  int spheres = 0;  // nested, in place of the isosurfaces
  int frames = 20, orbitFrames = 0;
  double settleSeconds = 0, warmSeconds = 0, seconds = 0, distance = kDistance;
  double stepDegrees = 0;  // 0: once around
  bool orbit = false;
  double computeMs = -1, waitMs = -1;  // own work before each frame; negative: none, and frames are finished
};

TriangleMesh makeMesh(const Options& options) {
  if (!options.mesh.empty()) return readMesh(options.mesh);
  const double millionTriangles = options.millionTriangles;
  if (millionTriangles <= 0) return {};
  if (options.spheres > 0) return bumpySpheres(options.spheres, 1e6 * millionTriangles);
  const Volume volume = wavelet();
  const auto [low, high] = volume.range();
  return isosurfaces(volume, evenIsovalues(low, high, waveletSurfaces(millionTriangles)));
}

/// The isosurfaces, some millions of triangles at a time.
MeshPieces makePieces(const Options& options) {
  const auto volume = std::make_shared<const Volume>(wavelet());
  const auto [low, high] = volume->range();
  const std::vector<float> all = evenIsovalues(low, high, waveletSurfaces(options.millionTriangles));
  const auto forEach = [volume, all](const std::function<void(const TriangleMesh&)>& take) {
    constexpr size_t kSurfaces = 14;  // 4 million triangles
    for (size_t first = 0; first < all.size(); first += kSurfaces) {
      const auto end = all.begin() + ptrdiff_t(std::min(first + kSurfaces, all.size()));
      take(isosurfaces(*volume, {all.begin() + ptrdiff_t(first), end}));
    }
  };
  return {sizeOfIsosurfaces(*volume, all), forEach};
}

void setState(double distance) {
  setScene(distance);
  const float diffuse[] = {kDiffuse[0], kDiffuse[1], kDiffuse[2], 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, diffuse);
}

void drawFrame(DrawPath& path, int frame, int frames, double distance) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glLoadMatrixd(eyeFromWorld(orbitPose(frame, frames, distance)).data());
  path.draw();
}

/// CPU time, of CLOCK_THREAD_CPUTIME_ID or CLOCK_PROCESS_CPUTIME_ID.
double cpuSeconds(clockid_t of) {
  timespec now{};
  clock_gettime(of, &now);
  return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

/// The work of an ordinary program: computes, or waits for something, between frames; then draws and swaps.
void workBetweenFrames(const Options& options) {
  if (options.waitMs > 0)
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(options.waitMs));
  if (options.computeMs <= 0) return;
  const auto cpuMs = [] { return 1e3 * cpuSeconds(CLOCK_THREAD_CPUTIME_ID); };
  for (const double end = cpuMs() + options.computeMs; cpuMs() < end;) {}
}

/// Ten frames a second for a while, as of a program that hardly moves; not measured. Consecutive frames
/// differ, so that structures built in the background are put into use.
void settle(DrawPath& path, Window& window, const Options& options, double seconds) {
  const Clock::time_point start = Clock::now();
  for (int i = 0; Seconds(Clock::now() - start).count() < seconds; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    drawFrame(path, i, options.orbitFrames, options.distance);
    window.swapAndFinish();
  }
}

/// Frames of the whole orbit; 0: the camera stands still.
int framesOfOrbit(const Options& options) {
  if (!options.orbit) return 0;
  return options.stepDegrees > 0 ? int(std::lround(360 / options.stepDegrees)) : options.frames;
}

/// The number of frames that take about so many seconds, at least two and at most as many as requested; draws
/// one frame to find out.
int framesWithin(DrawPath& path, Window& window, const Options& options) {
  if (options.seconds <= 0) return options.frames;
  const Clock::time_point start = Clock::now();
  drawFrame(path, 1, std::max(options.frames, 2), options.distance);
  window.swapAndFinish();
  const double one = Seconds(Clock::now() - start).count();
  return std::min(options.frames, std::max(2, int(std::lround(options.seconds / std::max(one, 1e-4)))));
}

/// Draws the first view once more and writes the back buffer.
void dump(DrawPath& path, const std::string& file, double distance) {
  drawFrame(path, 0, 0, distance);
  std::vector<uint8_t> pixels(size_t(kImageSize) * kImageSize * 4);
  glReadPixels(0, 0, kImageSize, kImageSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  writePng(imageFromGl(kImageSize, kImageSize, pixels), file);
}

void run(Options options) {
  const bool inPieces = takesPieces(options.path);
  if (inPieces && options.spheres > 0)
    throw std::runtime_error("--spheres: the path '" + options.path + "' draws isosurfaces only");
  TriangleMesh mesh = inPieces ? TriangleMesh{} : makeMesh(options);
  const MeshPieces pieces = inPieces ? makePieces(options) : MeshPieces{};
  Measurement m{.program = "client",
                .path = options.path,
                .renderer = {},
                .triangles = mesh.triangleCount() + pieces.size.triangles,
                .frameSeconds = {}};
  Window window(kImageSize);
  m.renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  setState(options.distance);
  window.swapAndFinish();
  malloc_trim(0);
  m.ownBytes = residentBytes().now;
  forgetHighest();

  const Clock::time_point start = Clock::now();
  const std::unique_ptr<DrawPath> path =
      inPieces ? makePath(options.path, pieces) : makePath(options.path, std::move(mesh));
  drawFrame(*path, 0, options.orbitFrames, options.distance);
  window.swapAndFinish();
  Clock::time_point last = Clock::now();
  m.firstImageSeconds = Seconds(last - start).count();

  settle(*path, window, options, options.warmSeconds);
  options.frames = framesWithin(*path, window, options);
  options.orbitFrames = framesOfOrbit(options);
  const bool works = options.computeMs >= 0 || options.waitMs >= 0;
  const double cpuBefore = cpuSeconds(CLOCK_PROCESS_CPUTIME_ID);
  last = Clock::now();
  for (int frame = 1; frame <= options.frames; ++frame) {
    workBetweenFrames(options);
    drawFrame(*path, options.orbit ? frame : 0, options.orbitFrames, options.distance);
    if (works && frame < options.frames)
      window.swap();
    else
      window.swapAndFinish();
    const Clock::time_point now = Clock::now();
    m.frameSeconds.push_back(Seconds(now - last).count());
    last = now;
  }
  m.cpuSeconds = (cpuSeconds(CLOCK_PROCESS_CPUTIME_ID) - cpuBefore) / std::max(options.frames, 1);
  settle(*path, window, options, options.settleSeconds);
  malloc_trim(0);
  const ResidentBytes resident = residentBytes();
  if (!options.dump.empty()) dump(*path, options.dump, options.distance);
  if (const GLenum error = glGetError()) throw std::runtime_error("OpenGL error " + std::to_string(error));
  std::printf("%s\n", jsonLine(m, resident).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app(
      "Draws isosurfaces of the Wavelet with fixed-function OpenGL and prints its frame times as JSON.");
  app.add_option("--triangles", options.millionTriangles, "millions of triangles, about; 0: an empty scene")
      ->check(CLI::Range(0.0, 256.0));
  app.add_option("--path", options.path, "how the mesh reaches OpenGL")->check(CLI::IsMember(pathNames()));
  app.add_option("--mesh", options.mesh, "draw the mesh of this file (gluray-bench-paper-data writes some)");
  app.add_option("--spheres", options.spheres, "draw so many nested spheres with bumps instead")
      ->check(CLI::Range(1, 1000));
  app.add_option("--distance", options.distance, "of the camera from the middle; the data reach to 173.3")
      ->check(CLI::Range(1.0, 10000.0));
  app.add_option("--frames", options.frames, "frames to measure after the first")
      ->check(CLI::Range(0, 1000000));
  app.add_option("--seconds", options.seconds, "measure no more frames than take so long, but two")
      ->check(CLI::Range(0.0, 10000.0));
  app.add_option("--warm", options.warmSeconds, "seconds of idle drawing before frames are measured")
      ->check(CLI::Range(0.0, 1000.0));
  app.add_option("--settle", options.settleSeconds, "seconds of idle drawing before memory is read")
      ->check(CLI::Range(0.0, 1000.0));
  app.add_flag("--orbit", options.orbit,
               "the camera goes around, once in these frames; else it stands still");
  app.add_option("--step", options.stepDegrees, "degrees between the frames of the orbit")
      ->check(CLI::Range(0.01, 180.0));
  app.add_option("--compute", options.computeMs,
                 "milliseconds of processor time of its own before each frame")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--wait", options.waitMs, "milliseconds of waiting before each frame")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--dump", options.dump, "write the first view as PNG");
  CLI11_PARSE(app, argc, argv);
  options.orbitFrames = framesOfOrbit(options);
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-client: %s\n", error.what());
    return 1;
  }
  return 0;
}
