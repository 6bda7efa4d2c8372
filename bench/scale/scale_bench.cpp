// gluray-bench-scale: ambient occlusion across the ranks of a sort-last program. The ranks are threads of
// this process, whose pictures one worker traces; each holds a slab of the Wavelet's isosurfaces. One line a
// figure.
#include "bench/data/isosurface.h"
#include "bench/data/orbit.h"
#include "bench/data/report.h"
#include "bench/data/wavelet.h"
#include "bench/render/wavelet_snapshot.h"
#include "bench/scale/parts.h"
#include "control/listening_place.h"
#include "dist/messages/peer_messages.h"
#include "dist/peers/query_stream.h"
#include "dist/program/remote_tracer.h"
#include "dist/program/worker_place.h"
#include "dist/ranks/alone.h"
#include "dist/worker/worker.h"
#include "frame/renderer.h"

#include <CLI/CLI.hpp>

#include <bit>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <future>
#include <thread>

namespace {

using namespace gluray;

struct Options {
  double millions = 1;
  int ranks = 4, frames = 5, samples = 4, threads = 2;
};

/// What the ranks have sent each other.
struct Traffic {
  double queryBytes = 0, answerBytes = 0, rays = 0, messages = 0;
};

/// A job of one process that counts what its programs ask each other.
class CountingRanks final : public dist::Ranks {
 public:
  int rank() const override { return alone_.rank(); }
  int size() const override { return alone_.size(); }
  int rankHere() const override { return alone_.rankHere(); }
  int sizeHere() const override { return alone_.sizeHere(); }
  std::string implementation() const override { return alone_.implementation(); }
  void send(int to, std::vector<std::byte> message) override {
    count(message);
    alone_.send(to, std::move(message));
  }
  std::optional<dist::RankMessage> receive() override { return alone_.receive(); }
  void broadcast(int root, std::span<std::byte> bytes, std::function<void()> done) override {
    alone_.broadcast(root, bytes, std::move(done));
  }
  void progress() override { alone_.progress(); }
  bool busy() const override { return alone_.busy(); }
  Traffic take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(traffic_, {});
  }

 private:
  void count(const std::vector<std::byte>& message) {
    dist::ByteReader in(message);
    const auto type = in.get<uint16_t>();
    if (type != dist::OcclusionQueries::kType && type != dist::OcclusionReplies::kType) return;
    const auto bytes = static_cast<double>(message.size());
    const std::lock_guard lock(mutex_);
    ++traffic_.messages;
    if (type == dist::OcclusionReplies::kType) {
      traffic_.answerBytes += bytes;
      return;
    }
    traffic_.queryBytes += bytes;
    const auto queries = dist::decoded<dist::OcclusionQueries>(in.take(in.left()));
    dist::QueryReader reader(queries.rays);
    for (dist::QueryPacket packet; reader.next(packet);) traffic_.rays += std::popcount(packet.lanes);
  }

  dist::Alone alone_;
  std::mutex mutex_;
  Traffic traffic_;
};

/// The worker, on a thread of its own.
class Job {
 public:
  Job(const std::string& directory, int threads)
      : place_(dist::workerPlace("scale", 0), "gluray-bench-scale") {
    bool taken = false;
    std::string why = place_.take(directory, taken);
    auto listening = std::make_shared<control::Descriptor>(why.empty() ? place_.listenHere(why) : -1);
    if (!why.empty()) throw std::runtime_error(why);
    thread_ = std::thread([this, listening, threads] {
      dist::Worker(ranks_, threads, std::move(*listening), [](const std::string& line) {
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
  Traffic take() { return ranks_.take(); }

 private:
  control::ListeningPlace place_;
  CountingRanks ranks_;
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
  dist::RemoteTracer tracer;
  Image image;
};

void show(scene::Snapshot& s, const Options& options, bool light, int frame) {
  bench::lookFrom(s, bench::orbitPose(frame, 360));
  s.instances[0].lightingFromObject = glm::mat4(s.instances[0].eyeFromObject);
  s.frame = static_cast<uint64_t>(frame);
  s.settings.bvh = BvhQuality::full;
  s.settings.threads = options.threads;
  s.settings.ao.enabled = light, s.settings.ao.samples = options.samples;
}

double secondsOf(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void traceAll(std::list<Rank>& ranks) {
  std::vector<std::future<bool>> all;
  for (Rank& rank : ranks)
    all.push_back(std::async(std::launch::async, [&rank] {
      scene::TraceCost cost;
      std::string error;
      if (rank.tracer.trace(rank.snapshot, rank.image, cost, error, nullptr)) return true;
      std::fprintf(stderr, "gluray-bench-scale: %s\n", error.c_str());
      return false;
    }));
  for (auto& one : all)
    if (!one.get()) throw std::runtime_error("a rank has no picture");
}

/// Pixels of the ranks' pictures, composed by depth, that differ from those of one process.
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

void run(const Options& options) {
  const std::string directory =
      (std::filesystem::temp_directory_path() / ("gluray-scale-" + std::to_string(getpid()))).string();
  const bench::Volume volume = bench::wavelet();
  const auto [low, high] = volume.range();
  const bench::TriangleMesh mesh =
      isosurfaces(volume, bench::evenIsovalues(low, high, bench::waveletSurfaces(options.millions)));
  const std::vector<bench::TriangleMesh> parts = bench::slabs(mesh, options.ranks);
  Job job(directory, options.threads);
  std::list<Rank> ranks;
  for (int rank = 0; rank < options.ranks; ++rank)
    ranks.emplace_back(directory, rank, options.ranks, parts[static_cast<size_t>(rank)]);
  frame::Renderer renderer;
  scene::Snapshot whole = bench::waveletSnapshot(mesh);
  std::vector<double> local, light, oneLocal, oneLight, queryBytes, answerBytes, rays, allRays, messages,
      wrong;
  int frame = 0;
  for (int round = -1; round < options.frames; ++round)  // the first builds structures
    for (const bool isLit : {false, true}) {
      ++frame;
      for (Rank& rank : ranks) show(rank.snapshot, options, isLit, frame);
      show(whole, options, isLit, frame);
      job.take();
      const double together = secondsOf([&] { traceAll(ranks); });
      const Traffic traffic = job.take();
      Image image;
      scene::TraceCost cost;
      std::string error;
      const double one = secondsOf([&] { renderer.render(whole, image, cost, error); });
      if (round < 0) continue;
      (isLit ? light : local).push_back(1000 * together), (isLit ? oneLight : oneLocal).push_back(1000 * one);
      if (!isLit) continue;
      double hits = 0;
      for (const Rank& rank : ranks)
        for (const float depth : rank.image.depth) hits += depth != Image::kMiss;
      queryBytes.push_back(traffic.queryBytes / 1e6), answerBytes.push_back(traffic.answerBytes / 1e6);
      rays.push_back(traffic.rays / 1e6), allRays.push_back(hits * options.samples / 1e6);
      messages.push_back(traffic.messages), wrong.push_back(differing(ranks, image));
    }
  std::filesystem::remove_all(directory);
  const auto print = [](const char* name, const std::vector<double>& values) {
    std::printf("%s %.3f\n", name, bench::median(values));
  };
  print("local_ms", local), print("occlusion_ms", light);
  print("one_process_local_ms", oneLocal), print("one_process_occlusion_ms", oneLight);
  print("occlusion_megarays", allRays), print("queries_megarays", rays);
  print("queries_mb", queryBytes), print("answers_mb", answerBytes), print("messages", messages);
  print("differing_pixels", wrong);
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
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-scale: %s\n", error.what());
    return 1;
  }
}
