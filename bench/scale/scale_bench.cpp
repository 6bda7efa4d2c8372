// gluray-bench-scale: ambient occlusion across the ranks of a sort-last program. The ranks are threads of
// this process, whose images one worker traces; each holds a slab of the Wavelet's isosurfaces. One line a
// figure.
#include "bench/data/report.h"
#include "bench/scale/all_queries.h"
#include "bench/scale/composed_error.h"
#include "bench/scale/counting_ranks.h"
#include "bench/scale/cpu_seconds.h"
#include "bench/scale/parts.h"
#include "bench/scale/views.h"
#include "cluster/program/remote_tracer.h"
#include "cluster/program/worker_place.h"
#include "cluster/worker/worker.h"
#include "control/listening_place.h"
#include "frame/tracing/renderer.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <future>
#include <thread>

namespace {

using namespace gluray;

constexpr double kNearDistance = 60;  // of a camera within the data; world units
constexpr int kAnimated = 8;          // frames of an animation before those that count

struct Options {
  double millions = 1;
  int ranks = 4, frames = 5, samples = 4, threads = 2;
  bool depthFirst = true;
};

/// The worker, on a thread of its own.
class Job {
 public:
  Job(const std::string& directory, int threads)
      : place_(cluster::workerPlace("scale", 0), "gluray-bench-scale") {
    bool taken = false;
    std::string why = place_.lockPlace(directory, taken);
    auto listening = std::make_shared<control::Descriptor>(why.empty() ? place_.listenHere(why) : -1);
    if (!why.empty()) throw std::runtime_error(why);
    thread_ = std::thread([this, listening, threads] {
      cluster::Worker(ranks_, threads, SIZE_MAX, std::move(*listening), [](const std::string& line) {
        if (line.find("rank ") != std::string::npos) std::fprintf(stderr, "%s\n", line.c_str());
      }).run(stop_);
    });
  }
  ~Job() {
    stop_ = true;
    thread_.join();
  }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  bench::Traffic take() { return ranks_.take(); }

 private:
  control::ListeningPlace place_;
  bench::CountingRanks ranks_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

/// A rank of the program.
struct Rank {
  Rank(const std::string& directory, int rank, int ranks, const bench::TriangleMesh& mesh)
      : snapshot(bench::waveletSnapshot(mesh)),
        tracer(
            directory, "scale", {0, "scale", rank, ranks},
            [](const auto&, Image&, auto&, std::string& error, const auto&) {
              error = "the worker is gone";
              return false;
            },
            [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); }) {}
  scene::Snapshot snapshot;
  cluster::RemoteTracer tracer;
  Image image;
};

/// Of some work: time, and CPU time of this process.
struct Spent {
  double ms = 0, cpuMs = 0;
};
Spent spentOn(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  const double cpu = bench::processCpuSeconds();
  work();
  return {std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count(),
          1000 * (bench::processCpuSeconds() - cpu)};
}

void traceAll(std::list<Rank>& ranks) {
  std::vector<std::future<bool>> all;
  for (Rank& rank : ranks)
    all.push_back(std::async(std::launch::async, [&rank] {
      scene::TraceCost cost;
      std::string error;
      if (rank.tracer.trace(rank.snapshot, rank.image, cost, error, nullptr)) {
        if (!cost.elsewhere) rank.tracer.shown(rank.snapshot, rank.image, true);
        return true;
      }
      std::fprintf(stderr, "gluray-bench-scale: %s\n", error.c_str());
      return false;
    }));
  for (auto& one : all)
    if (!one.get()) throw std::runtime_error("a rank has no image");
}

/// Pixels of the ranks' images, composed by depth, that differ from those of one process.
int differing(const std::list<Rank>& ranks, const Image& one) {
  int count = 0;
  for (size_t i = 0; i < one.depth.size(); ++i) {
    const Rank* front = &ranks.front();
    for (const Rank& rank : ranks)
      if (rank.image.depth[i] < front->image.depth[i]) front = &rank;
    count += front->image.color[i] != one.color[i];
  }
  return count;
}

/// Queries of all occlusion rays: of this view, and of one from so near that all pixels show surfaces.
void printAllQueries(frame::Renderer& renderer, scene::Snapshot whole) {
  const auto print = [&](const std::string& view) {
    const bench::AllQueries all = bench::allQueries(renderer, whole);
    std::printf("%s_rays_before_culling_mega %.4f\n", view.c_str(), static_cast<double>(all.rays) / 1e6);
    std::printf("%s_mb_before_culling %.3f\n", view.c_str(), static_cast<double>(all.bytes) / 1e6);
    std::printf("%s_pixels_hit_mega %.4f\n", view.c_str(), static_cast<double>(all.pixels) / 1e6);
  };
  print("orbit");
  bench::lookFrom(whole, bench::orbitPose(0, 360, kNearDistance));
  whole.instances[0].lightingFromObject = glm::mat4(whole.instances[0].eyeFromObject);
  const double nearest = 0.1, farthest = 600, f = whole.camera.clipFromEye[1][1];
  whole.camera.clipFromEye =
      glm::dmat4(f, 0, 0, 0, 0, f, 0, 0, 0, 0, -(farthest + nearest) / (farthest - nearest), -1, 0, 0,
                 -2 * farthest * nearest / (farthest - nearest), 0);
  print("near");
}

struct Figures {
  std::vector<double> local, light, localCpu, oneLocalCpu, oneLocal, oneLight, lightCpu, oneLightCpu,
      queryBytes, answerBytes, depthBytes, rays, allRays, messages, wrong, gathered, gatheredCpu,
      gatheredWrong;
};

/// How occlusion comes to the ranks of the program.
enum class Light { none, asked, gathered };

void keep(Light light, const Options& options, const Spent& together, const Spent& one,
          const bench::Traffic& traffic, const std::list<Rank>& ranks, const Image& image, Figures& f) {
  const bool isLit = light != Light::none;
  if (light == Light::gathered) {
    f.gathered.push_back(together.ms), f.gatheredCpu.push_back(together.cpuMs);
    f.gatheredWrong.push_back(differing(ranks, image));
    return;
  }
  (isLit ? f.light : f.local).push_back(together.ms), (isLit ? f.oneLight : f.oneLocal).push_back(one.ms);
  if (!isLit) return f.localCpu.push_back(together.cpuMs), f.oneLocalCpu.push_back(one.cpuMs);
  f.lightCpu.push_back(together.cpuMs), f.oneLightCpu.push_back(one.cpuMs);
  double hits = 0;
  for (const Rank& rank : ranks)
    for (const float depth : rank.image.depth) hits += depth != Image::kMiss;
  f.queryBytes.push_back(traffic.queryBytes / 1e6), f.answerBytes.push_back(traffic.answerBytes / 1e6);
  f.depthBytes.push_back(traffic.depthBytes / 1e6);
  f.rays.push_back(traffic.rays / 1e6), f.allRays.push_back(hits * options.samples / 1e6);
  f.messages.push_back(traffic.messages), f.wrong.push_back(differing(ranks, image));
}

/// One round: a local frame and two with occlusion, by all ranks and by one process.
void round(const Options& options, int number, Job& job, std::list<Rank>& ranks, frame::Renderer& renderer,
           scene::Snapshot& whole, Figures& f) {
  for (const Light light : {Light::none, Light::asked, Light::gathered}) {
    const int frame = 3 * number + static_cast<int>(light) + 4;
    const int samples = light == Light::none ? 0 : options.samples;
    for (Rank& rank : ranks) {
      bench::show(rank.snapshot, frame, samples, options.threads);
      rank.snapshot.number = static_cast<uint64_t>(frame);
      rank.snapshot.settings.gather = light == Light::gathered;
      rank.snapshot.settings.depthFirst = options.depthFirst;
    }
    bench::show(whole, frame, samples, options.threads);
    job.take();
    const Spent together = spentOn([&] { traceAll(ranks); });
    const bench::Traffic traffic = job.take();
    Image image;
    scene::TraceCost cost;
    std::string error;
    const Spent one = spentOn([&] { renderer.render(whole, image, cost, error); });
    if (number >= 0) keep(light, options, together, one, traffic, ranks, image, f);
  }
}

void print(const Figures& f) {
  const auto print = [](const char* name, const std::vector<double>& values) {
    std::printf("%s %.3f\n", name, bench::median(values));
  };
  print("local_ms", f.local), print("occlusion_ms", f.light);
  print("one_process_local_ms", f.oneLocal), print("one_process_occlusion_ms", f.oneLight);
  print("local_cpu_ms", f.localCpu), print("one_process_local_cpu_ms", f.oneLocalCpu);
  print("occlusion_cpu_ms", f.lightCpu), print("one_process_occlusion_cpu_ms", f.oneLightCpu);
  print("occlusion_megarays", f.allRays), print("queries_megarays", f.rays);
  print("queries_mb", f.queryBytes), print("answers_mb", f.answerBytes), print("depths_mb", f.depthBytes),
      print("messages", f.messages);
  print("differing_pixels", f.wrong);
  print("gathered_occlusion_ms", f.gathered), print("gathered_occlusion_cpu_ms", f.gatheredCpu);
  print("gathered_differing_pixels", f.gatheredWrong);
}

/// Frames of an animation after each other, by all ranks and by one process; the last one's noise.
void animate(const Options& options, std::list<Rank>& ranks, frame::Renderer& renderer,
             scene::Snapshot& whole) {
  std::vector<double> together, togetherCpu, one, oneCpu;
  Image image;
  scene::TraceCost cost;
  std::string error;
  const auto show = [&](scene::Snapshot& s, int frame) {
    bench::show(s, frame, options.samples, options.threads);
    s.lightSampling.mode = scene::LightSampling::Mode::moving;
    s.settings.fps = 1000;  // never reached: from the second frame on a quarter of the pixels traces a ray
    s.settings.gather = false, s.settings.depthFirst = options.depthFirst;
  };
  const int first = 3 * options.frames + 10;
  for (int frame = first; frame < first + kAnimated + options.frames; ++frame) {
    for (Rank& rank : ranks) show(rank.snapshot, frame);
    show(whole, frame);
    const Spent all = spentOn([&] { traceAll(ranks); });
    const Spent alone = spentOn([&] { renderer.render(whole, image, cost, error); });
    if (frame < first + kAnimated) continue;
    together.push_back(all.ms), togetherCpu.push_back(all.cpuMs);
    one.push_back(alone.ms), oneCpu.push_back(alone.cpuMs);
  }
  std::list<const Image*> parts;
  for (const Rank& rank : ranks) parts.push_back(&rank.image);
  const Image moving = image;
  whole.lightSampling.mode = scene::LightSampling::Mode::full;
  whole.settings.ao.samples = 64;
  renderer.render(whole, image, cost, error);
  const auto print = [](const char* name, double value) { std::printf("%s %.3f\n", name, value); };
  print("moving_occlusion_ms", bench::median(together)),
      print("moving_occlusion_cpu_ms", bench::median(togetherCpu));
  print("one_process_moving_occlusion_ms", bench::median(one));
  print("one_process_moving_occlusion_cpu_ms", bench::median(oneCpu));
  print("moving_error", bench::errorOf(parts, image)),
      print("one_process_moving_error", bench::errorOf({&moving}, image));
}

void run(const Options& options) {
  const std::string directory =
      (std::filesystem::temp_directory_path() / ("gluray-scale-" + std::to_string(getpid()))).string();
  const bench::TriangleMesh mesh = bench::waveletMesh(options.millions);
  const std::vector<bench::TriangleMesh> parts = bench::slabs(mesh, options.ranks);
  Job job(directory, options.threads);
  std::list<Rank> ranks;
  for (int rank = 0; rank < options.ranks; ++rank)
    ranks.emplace_back(directory, rank, options.ranks, parts[static_cast<size_t>(rank)]);
  frame::Renderer renderer;
  scene::Snapshot whole = bench::waveletSnapshot(mesh);
  Figures figures;
  for (int number = -1; number < options.frames; ++number)  // the first builds structures
    round(options, number, job, ranks, renderer, whole, figures);
  print(figures);
  animate(options, ranks, renderer, whole);
  std::filesystem::remove_all(directory);
  if (options.ranks == 1) printAllQueries(renderer, whole);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Ambient occlusion across the ranks of a sort-last program");
  Options options;
  app.add_option("--triangles", options.millions, "million triangles")->check(CLI::Range(0.1, 256.0));
  app.add_option("--ranks", options.ranks)->check(CLI::Range(1, 64));
  app.add_option("--frames", options.frames)->check(CLI::Range(1, 1000));
  app.add_option("--samples", options.samples, "rays a pixel")->check(CLI::Range(1, 1024));
  app.add_option("--threads", options.threads, "of each rank")->check(CLI::Range(1, 1024));
  app.add_flag("!--light-all", options.depthFirst, "ranks light what others hide");
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-scale: %s\n", error.what());
    return 1;
  }
}
