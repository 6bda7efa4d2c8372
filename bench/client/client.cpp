// gluray-bench-client: a small fixed-function OpenGL program of the kind the frame benchmark measures. It
// knows nothing of GLuRay: it draws isosurfaces of the Wavelet with plain OpenGL 1.5 and prints what it
// measured as a line of JSON.
#include "bench/client/paths.h"
#include "bench/client/window.h"
#include "bench/data/isosurface.h"
#include "bench/data/orbit.h"
#include "bench/data/png.h"
#include "bench/data/report.h"
#include "bench/data/wavelet.h"

#include <CLI/CLI.hpp>
#include <GL/gl.h>
#include <malloc.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <thread>

namespace {

using namespace gluray::bench;
using Seconds = std::chrono::duration<double>;
using Clock = std::chrono::steady_clock;

struct Options {
  double millionTriangles = 1;
  std::string path = "list", dump;
  int frames = 20, orbitFrames = 0;
  double settleSeconds = 0;
  bool orbit = false;
};

TriangleMesh makeMesh(double millionTriangles) {
  if (millionTriangles <= 0) return {};
  const Volume volume = wavelet();
  const auto [low, high] = volume.range();
  return isosurfaces(volume, evenIsovalues(low, high, waveletSurfaces(millionTriangles)));
}

void setState() {
  glClearColor(kBackground[0], kBackground[1], kBackground[2], 1);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  const float diffuse[] = {kDiffuse[0], kDiffuse[1], kDiffuse[2], 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, diffuse);
  const float towardsViewer[] = {0, 0, 1, 0};
  glLightfv(GL_LIGHT0, GL_POSITION, towardsViewer);
  glMatrixMode(GL_PROJECTION);
  const double half = kNear * std::tan(kViewAngle / 2 * M_PI / 180);
  glFrustum(-half, half, -half, half, kNear, kFar);
  glMatrixMode(GL_MODELVIEW);
}

void drawFrame(DrawPath& path, int frame, int frames) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glLoadMatrixd(eyeFromWorld(orbitPose(frame, frames)).data());
  path.draw();
}

/// Ten frames a second for a while, as a program that hardly moves; not measured.
void settle(DrawPath& path, Window& window, const Options& options) {
  const Clock::time_point start = Clock::now();
  while (Seconds(Clock::now() - start).count() < options.settleSeconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    drawFrame(path, 0, options.orbitFrames);
    window.swapAndFinish();
  }
}

/// Draws the first view once more and writes the back buffer.
void dump(DrawPath& path, const std::string& file) {
  drawFrame(path, 0, 0);
  std::vector<uint8_t> pixels(size_t(kImageSize) * kImageSize * 4);
  glReadPixels(0, 0, kImageSize, kImageSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  writePng(pictureFromGl(kImageSize, kImageSize, pixels), file);
}

void run(const Options& options) {
  TriangleMesh mesh = makeMesh(options.millionTriangles);
  Measurement m{.program = "client",
                .path = options.path,
                .renderer = {},
                .triangles = mesh.triangleCount(),
                .frameSeconds = {}};
  Window window(kImageSize);
  m.renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  setState();
  window.swapAndFinish();

  const Clock::time_point start = Clock::now();
  const std::unique_ptr<DrawPath> path = makePath(options.path, std::move(mesh));
  drawFrame(*path, 0, options.orbitFrames);
  window.swapAndFinish();
  Clock::time_point last = Clock::now();
  m.firstImageSeconds = Seconds(last - start).count();

  for (int frame = 1; frame <= options.frames; ++frame) {
    drawFrame(*path, options.orbit ? frame : 0, options.orbitFrames);
    window.swapAndFinish();
    const Clock::time_point now = Clock::now();
    m.frameSeconds.push_back(Seconds(now - last).count());
    last = now;
  }
  settle(*path, window, options);
  malloc_trim(0);
  const ResidentBytes resident = residentBytes();
  if (!options.dump.empty()) dump(*path, options.dump);
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
  app.add_option("--frames", options.frames, "frames to measure after the first")
      ->check(CLI::Range(0, 1000000));
  app.add_option("--settle", options.settleSeconds, "seconds of idle drawing before memory is read")
      ->check(CLI::Range(0.0, 1000.0));
  app.add_flag("--orbit", options.orbit, "the camera goes once around in these frames; else it stands still");
  app.add_option("--dump", options.dump, "write the first view as PNG");
  CLI11_PARSE(app, argc, argv);
  options.orbitFrames = options.orbit ? options.frames : 0;
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-client: %s\n", error.what());
    return 1;
  }
  return 0;
}
