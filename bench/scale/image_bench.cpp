// gluray-bench-image: a program whose images jobs of gluray-worker trace, in turn; their ranks are
// processes of this machine. One line a figure, named JOB.FIGURE.
#include "base/hash.h"
#include "bench/data/report.h"
#include "bench/scale/cpu_seconds.h"
#include "bench/scale/views.h"
#include "cluster/program/remote_tracer.h"
#include "control/runtime_directory.h"
#include "frame/tracing/renderer.h"

#include <CLI/CLI.hpp>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <list>
#include <numeric>
#include <sstream>
#include <thread>
#include <utility>

namespace {

using namespace gluray;

struct Options {
  double millions = 1;
  int frames = 15, samples = 0;
  bool withoutLocal = false, drops = false, moves = false, isSmall = false;
  std::vector<std::string> jobs;
};

/// What a job's ranks did for the frames.
struct Figures {
  std::vector<double> frame, head, protocol, tracing, busiest, balance;  // ms but for balance
  std::vector<double> ofRanks;                                           // tracing, sums over the frames
  double first = 0;                                                      // ms until the first image
  double handedOver = 0;  // ms until the ranks had the geometry; 0: with the first image
};

/// A job: "NAME:PROCESS,PROCESS,...", its head first.
struct Job {
  explicit Job(const std::string& text, const bench::TriangleMesh& mesh)
      : name(text.substr(0, text.find(':'))),
        snapshot(bench::waveletSnapshot(mesh)),
        tracer(
            control::runtimeDirectory(), name, {},
            [](const auto&, Image&, auto&, std::string& error, const auto&) {
              error = "no worker answers";
              return false;
            },
            [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); }) {
    std::istringstream numbers(text.substr(text.find(':') + 1));
    for (std::string number; std::getline(numbers, number, ',');) processes.push_back(std::stoi(number));
    figures.ofRanks.resize(processes.size());
  }
  std::string name;
  std::vector<pid_t> processes;
  scene::Snapshot snapshot;
  cluster::RemoteTracer tracer;
  Image image;
  Figures figures;
};

std::vector<bench::CpuSeconds> cpuOf(const Job& job) {
  std::vector<bench::CpuSeconds> all;
  for (const pid_t process : job.processes) all.push_back(bench::cpuSecondsOf(process));
  return all;
}

/// The view of that frame, and its light.
void show(scene::Snapshot& s, int frame, const Options& options) {
  bench::show(s, frame, options.samples, 0);
  if (!options.moves) return;
  s.lightSampling.mode = scene::LightSampling::Mode::moving;
  s.settings.fps = 1000;  // never reached: from the second frame on a quarter of the pixels traces a ray
}

void trace(Job& job, int frame, const Options& options, bool counts) {
  show(job.snapshot, frame, options);
  scene::TraceCost cost;
  std::string error;
  const std::vector<bench::CpuSeconds> before = cpuOf(job);
  const auto start = std::chrono::steady_clock::now();
  if (!job.tracer.trace(job.snapshot, job.image, cost, error, nullptr))
    throw std::runtime_error(job.name + ": " + error);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double head = bench::cpuSecondsOf(job.processes[0]).main - before[0].main;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));  // other ranks notice the end of the image
  const std::vector<bench::CpuSeconds> after = cpuOf(job);
  if (job.figures.first == 0) job.figures.first = 1000 * seconds;
  if (!counts) return;
  std::vector<double> tracing;
  for (size_t rank = 0; rank < after.size(); ++rank) {
    tracing.push_back(1000 * (after[rank].others - before[rank].others));
    job.figures.ofRanks[rank] += tracing.back();
  }
  const double sum = std::accumulate(tracing.begin(), tracing.end(), 0.0), most = std::ranges::max(tracing);
  Figures& f = job.figures;
  f.frame.push_back(1000 * seconds), f.head.push_back(1000 * cost.traceSeconds);
  f.protocol.push_back(1000 * head), f.tracing.push_back(sum), f.busiest.push_back(most);
  f.balance.push_back(most * static_cast<double>(tracing.size()) / sum);
}

int differing(const Image& a, const Image& b) {
  int count = 0;
  for (size_t i = 0; i < b.color.size(); ++i) count += a.color[i] != b.color[i] || a.depth[i] != b.depth[i];
  return count;
}

/// Of the image; exact as a double.
double checksum(const Image& image) {
  const Hash128 color = hashBytes(image.color.data(), image.color.size() * sizeof image.color[0]);
  const Hash128 both = hashBytes(image.depth.data(), image.depth.size() * sizeof image.depth[0], color);
  return static_cast<double>(both.low >> 12);
}

void print(const Job& job) {
  const auto say = [&](const char* name, double value) {
    std::printf("%s.%s %.3f\n", job.name.c_str(), name, value);
  };
  const Figures& f = job.figures;
  say("frame_ms", bench::median(f.frame)), say("head_ms", bench::median(f.head));
  say("head_protocol_cpu_ms", bench::median(f.protocol)), say("tracing_cpu_ms", bench::median(f.tracing));
  say("busiest_rank_cpu_ms", bench::median(f.busiest)), say("max_over_mean", bench::median(f.balance));
  const double sum = std::accumulate(f.ofRanks.begin(), f.ofRanks.end(), 0.0);
  say("max_over_mean_all_frames", std::ranges::max(f.ofRanks) * static_cast<double>(f.ofRanks.size()) / sum);
  if (f.handedOver > 0) say("handed_over_ms", f.handedOver);
  say("first_ms", f.first), say("checksum", checksum(job.image));
}

void printDifference(const Job& job, const Image& local) {
  std::printf("%s.differing_pixels %d\n", job.name.c_str(), differing(job.image, local));
}

/// The image without workers.
Image localImage(const bench::TriangleMesh& mesh, int frame, const Options& options) {
  frame::Renderer renderer;
  scene::Snapshot snapshot = bench::waveletSnapshot(mesh);
  show(snapshot, frame, options);
  if (options.isSmall) snapshot.settings.bvh = BvhQuality::least;
  Image image;
  scene::TraceCost cost;
  std::string error;
  if (!renderer.render(snapshot, image, cost, error)) throw std::runtime_error(error);
  std::printf("local.checksum %.0f\n", checksum(image));
  return image;
}

/// Gives the memory of whole pages of the array back; they read as zeros.
template <class T>
void drop(bench::LargeArray<T>& array) {
  const auto page = static_cast<uintptr_t>(sysconf(_SC_PAGESIZE));
  const uintptr_t first = (reinterpret_cast<uintptr_t>(array.data()) + page - 1) / page * page;
  const uintptr_t end = reinterpret_cast<uintptr_t>(array.data() + array.size()) / page * page;
  if (first < end) madvise(reinterpret_cast<void*>(first), end - first, MADV_DONTNEED);
}

/// The jobs get the geometry with an image that looks past it; afterwards nobody reads the program's own
/// copy.
void handOver(std::list<Job>& jobs, bench::TriangleMesh& mesh, const Options& options) {
  for (Job& job : jobs) {
    const glm::dmat4 lens = job.snapshot.camera.clipFromEye;
    job.snapshot.camera.clipFromEye[2] = -lens[2];  // backwards
    trace(job, 0, options, false);
    job.snapshot.camera.clipFromEye = lens;
    job.figures.handedOver = std::exchange(job.figures.first, 0);
  }
  drop(mesh.positions), drop(mesh.normals), drop(mesh.indices);
}

void run(const Options& options) {
  bench::TriangleMesh mesh = bench::waveletMesh(options.millions);
  std::list<Job> jobs;
  for (const std::string& text : options.jobs) jobs.emplace_back(text, mesh);
  if (options.drops) handOver(jobs, mesh, options);
  constexpr int kWarmUp = 3;  // structures, and costs of tiles
  int frame = 0;
  for (int round = -kWarmUp; round < options.frames; ++round) {
    ++frame;
    for (Job& job : jobs) trace(job, frame, options, round >= 0);
    jobs.reverse();  // none is always the first
  }
  for (const Job& job : jobs) print(job);
  if (options.withoutLocal) return;
  const Image local = localImage(mesh, frame, options);
  for (const Job& job : jobs) printDifference(job, local);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Frames by jobs of workers in turn: times, CPU time of their ranks, balance");
  Options options;
  app.add_option("jobs", options.jobs,
                 "NAME:PROCESS,PROCESS,...: a job and its ranks' processes, head first");
  app.add_option("--triangles", options.millions, "million triangles")->check(CLI::Range(0.1, 256.0));
  app.add_option("--frames", options.frames)->check(CLI::Range(1, 1000));
  app.add_option("--samples", options.samples, "rays of ambient occlusion a pixel; 0: none")
      ->check(CLI::Range(0, 1024));
  CLI::Option* const withoutLocal =
      app.add_flag("--without-local", options.withoutLocal, "do not compare with an image of this process");
  app.add_flag("--small", options.isSmall, "trace this process's image in the smallest structure");
  app.add_flag("--moving", options.moves,
               "frames of animations: a ray for four pixels, smoothed with what is known of earlier frames")
      ->needs(withoutLocal);
  app.add_flag("--drop", options.drops, "keep no copy of the geometry, which the jobs have")
      ->needs(withoutLocal);
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-image: %s\n", error.what());
    return 1;
  }
}
