#include "bench/refine/until_goal.h"

#include "bench/data/image_error.h"
#include "bench/data/report.h"
#include "frame/refinement/refiner.h"
#include "frame/tracing/renderer.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace gluray::bench {
namespace {

/// CPU time of all threads, and time.
struct Spent {
  double cpu = 0, wall = 0;
};

Spent spentBy(const auto& work) {
  using Clock = std::chrono::steady_clock;
  const std::clock_t cpu = std::clock();
  const auto start = Clock::now();
  work();
  const std::chrono::duration<double> wall = Clock::now() - start;
  return {static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC, wall.count()};
}

Spent operator+(const Spent& a, const Spent& b) { return {a.cpu + b.cpu, a.wall + b.wall}; }

class Rest {
 public:
  Rest(const scene::Snapshot& snapshot, const Image& reference) : snapshot_(snapshot), reference_(reference) {
    for (const float depth : reference.depth) hits_.push_back(depth != Image::kMiss);
    local();  // builds the structures
  }

  struct Refined {
    Spent spent;
    std::vector<double> psnr;  // after each pass that was looked at
    uint32_t passes = 0;
  };
  /// Passes until the goal, whose error is looked at between them, or as many as `passes` says.
  Refined refined(const Goal& goal, uint32_t passes) {
    scene::Snapshot s = snapshot_;
    s.settings.denoise = goal.denoise, s.settings.refine.adaptive = false;
    frame::Refinement refinement;
    frame::Refiner refiner(s, refinement);
    Refined out;
    Image image;
    while (out.passes < (passes ? passes : static_cast<uint32_t>(goal.passes))) {
      out.spent = out.spent + spentBy([&] { pass(refiner); });
      ++out.passes;
      if (passes) continue;
      refiner.show(image), out.psnr.push_back(errorOf(image));
      if (out.psnr.back() >= goal.psnr) break;
    }
    out.spent = out.spent + spentBy([&] { refiner.show(image); });
    return out;
  }

  Spent local() {
    scene::Snapshot s = snapshot_;
    s.settings = {};
    s.settings.bvh = snapshot_.settings.bvh, s.settings.threads = snapshot_.settings.threads;
    return spentBy([&] {
      Image image;
      trace(s, image);
    });
  }

 private:
  void trace(const scene::Snapshot& s, Image& image) {
    scene::TraceCost cost;
    std::string error;
    if (!renderer_.render(s, image, cost, error)) throw std::runtime_error(error);
  }

  void pass(frame::Refiner& refiner) {
    const frame::Trace traceOne = [&](const auto& snapshot, Image& image, auto& cost, std::string& error) {
      return renderer_.render(snapshot, image, cost, error);
    };
    scene::TraceCost cost;
    std::string error;
    if (!refiner.pass(traceOne, 0, cost, error)) throw std::runtime_error(error);
  }

  double errorOf(const Image& image) const { return psnr(image.color, reference_.color, hits_); }

  scene::Snapshot snapshot_;
  const Image& reference_;
  std::vector<uint8_t> hits_;
  frame::Renderer renderer_;
};

void print(const std::string& name, double value, const char* unit) {
  std::printf("%-28s %10.3f %s\n", name.c_str(), value, unit);
  std::fflush(stdout);
}

}  // namespace

Image keptImage(const std::string& keep, const scene::Snapshot& s, const std::function<Image()>& make) {
  Image image;
  image.resize(s.region.width, s.region.height, 1, Plane::color | Plane::depth);
  const auto colors = static_cast<std::streamsize>(4 * image.color.size());
  const auto depths = static_cast<std::streamsize>(4 * image.depth.size());
  if (!keep.empty() && std::filesystem::exists(keep)) {
    std::ifstream file(keep, std::ios::binary);
    file.read(reinterpret_cast<char*>(image.color.data()), colors);
    file.read(reinterpret_cast<char*>(image.depth.data()), depths);
    if (!file || file.peek() != std::ifstream::traits_type::eof())
      throw std::runtime_error(keep + " is of another size");
    return image;
  }
  image = make();
  if (keep.empty()) return image;
  std::ofstream file(keep, std::ios::binary);
  file.write(reinterpret_cast<const char*>(image.color.data()), colors);
  file.write(reinterpret_cast<const char*>(image.depth.data()), depths);
  if (!file) throw std::runtime_error("cannot write " + keep);
  return image;
}

void printUntilGoal(const scene::Snapshot& snapshot, const Image& reference, const Goal& goal) {
  Rest rest(snapshot, reference);
  const Rest::Refined found = rest.refined(goal, 0);
  const bool reached = found.psnr.back() >= goal.psnr;
  for (size_t i = 0; i < found.psnr.size(); ++i)
    print("passes_" + std::to_string(i + 1) + "_psnr", found.psnr[i], "dB");
  print("goal_passes", found.passes, "passes");
  print("goal_reached", reached, "1: yes");
  if (!reached) return;
  std::vector<double> cpu, wall, local;
  for (int round = 0; round < goal.rounds; ++round) {
    const Spent before = rest.local(), refined = rest.refined(goal, found.passes).spent,
                sum = before + rest.local();
    cpu.push_back(2 * refined.cpu / sum.cpu), wall.push_back(2 * refined.wall / sum.wall);
    local.push_back(1e3 * sum.cpu / 2);
  }
  print("goal_local_cpu_ms", median(local), "ms");
  print("goal_local_frames", median(cpu), "local frames of CPU time");
  print("goal_local_frames_wall", median(wall), "local frames of time");
}

}  // namespace gluray::bench
