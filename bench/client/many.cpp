// gluray-bench-many: programs of many small things, by plain OpenGL 1.1: thousands of meshes, a hundred
// thousand places of one mesh, lists that live for one frame. Prints frame times as a line of JSON.
#include "bench/client/scene.h"
#include "bench/client/window.h"
#include "bench/data/orbit.h"
#include "bench/data/report.h"

#include <CLI/CLI.hpp>
#include <GL/gl.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace {

using namespace gluray::bench;
using Seconds = std::chrono::duration<double>;
using Clock = std::chrono::steady_clock;

struct Options {
  std::string kind = "meshes";
  int count = 0, frames = 20;
  double settleSeconds = 0;
};

/// A ball of 2 * side * (side - 1) triangles about the origin, with waves by `phase`, between glBegin and
/// glEnd.
void sendBall(int side, double phase, double radius) {
  const auto vertex = [&](int row, int column) {
    const double theta = M_PI * row / side, phi = 2 * M_PI * column / side;
    const double x = std::sin(theta) * std::cos(phi), y = std::sin(theta) * std::sin(phi),
                 z = std::cos(theta);
    const double r = radius * (1 + 0.1 * std::sin(5 * theta + phase) * std::cos(3 * phi));
    glNormal3d(x, y, z);
    glVertex3d(r * x, r * y, r * z);
  };
  glBegin(GL_TRIANGLES);
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      if (row > 0) vertex(row, column), vertex(row + 1, column), vertex(row, column + 1);
      if (row + 1 < side) vertex(row, column + 1), vertex(row + 1, column), vertex(row + 1, column + 1);
    }
  glEnd();
}

/// Place `i` of `count` in a cube of 200.
void translateTo(int i, int count) {
  const int side = int(std::ceil(std::cbrt(double(count))));
  const double step = 200.0 / side;
  glTranslated(step * (i % side + 0.5) - 100, step * (i / side % side + 0.5) - 100,
               step * (i / side / side + 0.5) - 100);
}

double radiusOf(int count) { return 80.0 / std::ceil(std::cbrt(double(count))); }

void callAt(GLuint list, int i, int count) {
  glPushMatrix();
  translateTo(i, count);
  glCallList(list);
  glPopMatrix();
}

void compileBall(GLuint list, int side, double phase, int count) {
  glNewList(list, GL_COMPILE);
  sendBall(side, phase, radiusOf(count));
  glEndList();
}

/// Draws frame `frame`.
using Draw = std::function<void(int frame)>;

constexpr int kThousand = 23, kEighty = 7;  // rows of balls of 1,012 and 84 triangles

struct Kind {
  int count, side;  // number of objects, and rows of each
  std::function<Draw(int count)> prepare;
};

/// Lists of different meshes, each in its place.
Draw meshes(int count) {
  const GLuint first = glGenLists(count);
  for (int i = 0; i < count; ++i) compileBall(first + GLuint(i), kThousand, 0.01 * i, count);
  return [=](int) {
    for (int i = 0; i < count; ++i) callAt(first + GLuint(i), i, count);
  };
}

/// One list in many places.
Draw instances(int count) {
  const GLuint list = glGenLists(1);
  compileBall(list, kEighty, 0, count);
  return [=](int) {
    for (int i = 0; i < count; ++i) callAt(list, i, count);
  };
}

/// Lists made for one frame and deleted after it, all different from those of the frame before.
Draw oneFrameLists(int count) {
  return [=](int frame) {
    const GLuint first = glGenLists(count);
    for (int i = 0; i < count; ++i) {
      compileBall(first + GLuint(i), kThousand, 0.01 * i + 0.1 * frame, count);
      callAt(first + GLuint(i), i, count);
    }
    glDeleteLists(first, count);
  };
}

Kind kindOf(const std::string& name) {
  if (name == "meshes") return {10'000, kThousand, meshes};
  if (name == "instances") return {100'000, kEighty, instances};
  return {100, kThousand, oneFrameLists};
}

void run(const Options& options) {
  const Kind kind = kindOf(options.kind);
  const int count = options.count > 0 ? options.count : kind.count;
  Window window(kImageSize);
  Measurement m{.program = "many",
                .path = options.kind,
                .renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER)),
                .triangles = size_t(count) * 2 * size_t(kind.side) * size_t(kind.side - 1),
                .frameSeconds = {}};
  setScene(kDistance);
  window.swapAndFinish();
  m.ownBytes = residentBytes().now;
  const Clock::time_point start = Clock::now();
  const Draw draw = kind.prepare(count);
  const auto frame = [&](int number) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadMatrixd(eyeFromWorld(orbitPose(number, 360, kDistance)).data());
    draw(number);
    window.swapAndFinish();
  };
  frame(0);
  Clock::time_point last = Clock::now();
  m.firstImageSeconds = Seconds(last - start).count();
  for (int i = 1; Seconds(Clock::now() - last).count() < options.settleSeconds; ++i) frame(-i);
  last = Clock::now();
  for (int i = 1; i <= options.frames; ++i) {
    frame(i);
    const Clock::time_point now = Clock::now();
    m.frameSeconds.push_back(Seconds(now - last).count());
    last = now;
  }
  if (const GLenum error = glGetError()) throw std::runtime_error("OpenGL error " + std::to_string(error));
  std::printf("%s\n", jsonLine(m, residentBytes()).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Draws many small things with fixed-function OpenGL and prints its frame times as JSON.");
  app.add_option("--kind", options.kind, "what is many")
      ->check(CLI::IsMember({"meshes", "instances", "lists"}));
  app.add_option("--count", options.count, "how many; 0: 10,000 meshes, 100,000 instances, 100 lists")
      ->check(CLI::Range(0, 1'000'000));
  app.add_option("--frames", options.frames, "frames to measure after the first")
      ->check(CLI::Range(0, 100000));
  app.add_option("--settle", options.settleSeconds, "seconds of drawing before frames are measured");
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-many: %s\n", error.what());
    return 1;
  }
  return 0;
}
