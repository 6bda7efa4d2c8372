// gluray-bench-objects: a program of many objects, each one a draw of its own by a shader program, with a
// model matrix and a colour as uniforms, or all of them the instances of one draw. Prints frame times as a
// line of JSON.
#include "bench/client/balls.h"
#include "bench/client/window.h"
#include "bench/data/orbit.h"
#include "bench/data/report.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace gluray::bench;
using Seconds = std::chrono::duration<double>;
using Clock = std::chrono::steady_clock;
using Matrix = std::array<float, 16>;  // column by column

struct Options {
  std::string order = "random";
  int count = 4000, side = 23, frames = 20;
  double radius = 12;           // of the objects, in a ball of radius 150
  double distance = kDistance;  // of the viewer from its middle
  double step = 1.5;            // degrees a frame
  double settleSeconds = 0;
  bool instanced = false, tellsAll = false;
};

constexpr double kReach = 150;

struct Object {
  std::array<double, 3> center;
  int mesh;
  std::array<float, 3> paint;
};

std::vector<Object> makeObjects(int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Object> all;
  while (int(all.size()) < count) {
    const std::array<double, 3> p{number(random), number(random), number(random)};
    if (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] > 1) continue;
    const auto channel = [&] { return float(0.6 + 0.4 * number(random)); };
    all.push_back({{kReach * p[0], kReach * p[1], kReach * p[2]},
                   int(all.size()) % Balls::kMeshes,
                   {channel(), channel(), channel()}});
  }
  return all;
}

/// Clip space from world space: eyeFromWorld under the frustum of the benchmark's window.
Matrix clipFromWorld(const CameraPose& pose, double distance) {
  const std::array<double, 16> view = eyeFromWorld(pose);
  const double f = 1 / std::tan(kViewAngle * M_PI / 360);
  const double reach = kReach + 40, near = std::max(distance - reach, 1.0), far = distance + reach;
  const double a = (far + near) / (near - far), b = 2 * far * near / (near - far);
  Matrix m{};
  for (size_t c = 0; c < 4; ++c) {
    const double *from = &view[4 * c], last = c == 3 ? 1 : 0;
    m[4 * c] = float(f * from[0]), m[4 * c + 1] = float(f * from[1]);
    m[4 * c + 2] = float(a * from[2] + b * last), m[4 * c + 3] = float(-from[2]);
  }
  return m;
}

class Scene {
 public:
  explicit Scene(const Options& options)
      : options_(options),
        balls_(options.side),
        program_(makeBallProgram(options.instanced)),
        objects_(makeObjects(options.count)) {
    glUseProgram(program_);
    glEnable(GL_DEPTH_TEST);
    glClearColor(kBackground[0], kBackground[1], kBackground[2], 1);
  }
  size_t triangles() const { return objects_.size() * size_t(balls_.triangles()); }

  void draw(int frame) {
    const CameraPose pose = orbitPose(frame, int(std::lround(360 / options_.step)), options_.distance);
    sort(pose);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUniformMatrix4fv(place("clipFromWorld"), 1, GL_FALSE, clipFromWorld(pose, options_.distance).data());
    glUniform3f(place("viewer"), float(pose.eye[0]), float(pose.eye[1]), float(pose.eye[2]));
    options_.instanced ? drawInstances() : drawOneByOne();
  }

 private:
  void drawInstances() {
    places_.clear();
    for (const Object& o : objects_) places_.push_back({centerOf(o), float(options_.radius), o.paint});
    balls_.drawInstances(places_);
  }
  void drawOneByOne() {
    const GLint matrix = place("worldFromObject"), paint = place("paint");
    const auto size = float(options_.radius);
    for (const Object& o : objects_) {
      const std::array<float, 3> center = centerOf(o);
      const Matrix m{size, 0, 0, 0, 0, size, 0, 0, 0, 0, size, 0, center[0], center[1], center[2], 1};
      glUniformMatrix4fv(matrix, 1, GL_FALSE, m.data());
      glUniform3fv(paint, 1, o.paint.data());
      balls_.draw(o.mesh);
    }
  }

  static std::array<float, 3> centerOf(const Object& o) {
    return {float(o.center[0]), float(o.center[1]), float(o.center[2])};
  }
  GLint place(const char* name) const { return glGetUniformLocation(program_, name); }
  void sort(const CameraPose& pose) {
    if (options_.order == "random") return;
    const double sign = options_.order == "front" ? 1 : -1;
    const auto nearness = [&](const Object& o) {
      const auto &b = pose.backward, &c = o.center;
      return -sign * (b[0] * c[0] + b[1] * c[1] + b[2] * c[2]);
    };
    std::ranges::sort(objects_, {}, nearness);
  }

  const Options options_;
  Balls balls_;
  GLuint program_;
  std::vector<Object> objects_;
  std::vector<BallPlace> places_;  // reused by each frame
};

void run(const Options& options) {
  Window window(kImageSize);
  Scene scene(options);
  Measurement m{.program = "objects",
                .path = options.order,
                .renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER)),
                .triangles = scene.triangles(),
                .frameSeconds = {}};
  m.ownBytes = residentBytes().now;
  const Clock::time_point start = Clock::now();
  std::vector<double> all;
  const auto frame = [&] {
    const Clock::time_point began = Clock::now();
    scene.draw(int(all.size()));
    window.swapAndFinish();
    all.push_back(Seconds(Clock::now() - began).count());
    return all.back();
  };
  m.firstImageSeconds = frame();
  do frame();
  while (Seconds(Clock::now() - start).count() < options.settleSeconds);
  for (int i = 0; i < options.frames; ++i) m.frameSeconds.push_back(frame());
  if (options.tellsAll) m.allSeconds = std::move(all);
  if (const GLenum error = glGetError()) throw std::runtime_error("OpenGL error " + std::to_string(error));
  std::printf("%s\n", jsonLine(m, residentBytes()).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Draws many objects by a shader program and prints its frame times as JSON.");
  app.add_option("--order", options.order, "of the draws")->check(CLI::IsMember({"random", "front", "back"}));
  app.add_option("--count", options.count, "objects")->check(CLI::Range(1, 1'000'000));
  app.add_option("--rows", options.side, "of the balls, of 2 * rows * (rows - 1) triangles")
      ->check(CLI::Range(3, 200));
  app.add_option("--radius", options.radius, "of the balls, which fill a ball of radius 150")
      ->check(CLI::Range(0.1, 150.0));
  app.add_option("--distance", options.distance, "of the viewer from the middle of that ball")
      ->check(CLI::Range(1.0, 1e4));
  app.add_option("--step", options.step, "degrees that the camera turns in a frame")
      ->check(CLI::Range(0.01, 90.0));
  app.add_option("--frames", options.frames, "frames to measure")->check(CLI::Range(0, 100000));
  app.add_option("--settle", options.settleSeconds, "seconds of drawing before frames are measured");
  app.add_flag("--instanced", options.instanced,
               "draws all balls, of one mesh, as the instances of one draw");
  app.add_flag("--all", options.tellsAll, "prints the times of all frames, those that settle included");
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-objects: %s\n", error.what());
    return 1;
  }
  return 0;
}
