// A job of workers in this process, and programs that it traces for, for tests.
#pragma once
#include "cluster/program/remote_tracer.h"
#include "cluster/testing/thread_ranks.h"
#include "cluster/worker/worker.h"
#include "control/listening_place.h"
#include "frame/testing/lit_scene.h"
#include "frame/tracing/renderer.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace gluray::cluster::test {

/// A runtime directory of its own.
class RuntimeFolder {
 public:
  RuntimeFolder()
      : folder_(std::filesystem::path(testing::TempDir()) / ("gluray-cluster-" + std::to_string(getpid()))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~RuntimeFolder() { std::filesystem::remove_all(folder_); }
  RuntimeFolder(const RuntimeFolder&) = delete;
  RuntimeFolder& operator=(const RuntimeFolder&) = delete;
  std::string directory() const { return folder_ / "run"; }

 private:
  std::filesystem::path folder_;
};

class WorkerJob {
 public:
  /// Of so many ranks, whose sockets are in `directory`.
  /// `memory`: as a worker's.
  WorkerJob(std::string directory, int ranks, std::string name = "job", size_t memory = SIZE_MAX)
      : job_(std::make_shared<ThreadJob>(ranks)),
        directory_(std::move(directory)),
        name_(std::move(name)),
        memory_(memory) {
    for (int rank = 0; rank < ranks; ++rank) ranks_.emplace_back(job_, rank);
    for (ThreadRanks& rank : ranks_) start(rank);
  }
  ~WorkerJob() { end(); }
  WorkerJob(const WorkerJob&) = delete;
  WorkerJob& operator=(const WorkerJob&) = delete;

  void end() {
    stop_ = true;
    for (std::thread& thread : threads_) thread.join();
    threads_.clear(), places_.clear();
  }
  ThreadRanks& rank(int number) { return *std::next(ranks_.begin(), number); }
  uint64_t sentBytes() const { return job_->sentBytes; }
  /// Messages that the rank has not received yet.
  size_t waiting(int rank) {
    const std::lock_guard lock(job_->mutex);
    return job_->inboxes[static_cast<size_t>(rank)].size();
  }
  std::string said() {
    const std::lock_guard lock(mutex_);
    return said_;
  }

 private:
  void start(ThreadRanks& rank) {
    control::ListeningPlace& place = places_.emplace_back(workerPlace(name_, rank.rank()), "worker");
    bool taken = false;
    EXPECT_EQ(place.lockPlace(directory_, taken), "");
    std::string why;
    auto listening = std::make_shared<control::Descriptor>(place.listenHere(why));
    EXPECT_EQ(why, "");
    threads_.emplace_back([this, &rank, listening] {
      // Another number of threads for each: ranks of one process with the same would share an arena.
      Worker worker(rank, 1 + rank.rank(), memory_, std::move(*listening), [this](const std::string& line) {
        const std::lock_guard lock(mutex_);
        said_ += line + "\n";
      });
      worker.run(stop_);
    });
  }

  std::shared_ptr<ThreadJob> job_;
  std::string directory_, name_;
  const size_t memory_;
  std::list<ThreadRanks> ranks_;
  std::list<control::ListeningPlace> places_;
  std::atomic<bool> stop_{false};
  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::string said_;
};

/// A program's side.
struct Program {
  explicit Program(const std::string& directory, MpiPlace place = {}, const std::string& job = "job")
      : tracer(
            directory, job, std::move(place),
            [this](const scene::Snapshot& s, Image& image, scene::TraceCost& cost, std::string& error,
                   const std::function<bool()>& stop) {
              ++tracedHere;
              return stop ? renderer.renderBehind(s, image, cost, error, stop)
                          : renderer.render(s, image, cost, error);
            },
            [this](const std::string& line) { said += line + "\n"; }) {}

  Image image(const scene::Snapshot& snapshot, uint32_t missColor = 0) {
    Image image;
    image.missColor = missColor;
    std::string error;
    EXPECT_TRUE(tracer.trace(snapshot, image, cost, error, nullptr)) << error;
    if (completes && tracer.isGathered(snapshot)) {
      scene::TraceCost more;
      EXPECT_TRUE(tracer.traceComplete(snapshot, complete, more, error)) << error;
    }
    if (shows && !cost.elsewhere) tracer.shown(snapshot, image, finishes);
    return image;
  }

  frame::Renderer renderer;
  int tracedHere = 0;
  std::string said;
  scene::TraceCost cost;
  bool shows = true, finishes = true;  // each image, which is the last pass
  bool completes = false;              // makes a complete image before the other ranks get theirs
  Image complete;
  RemoteTracer tracer;
};

/// Without light that falls on surfaces.
inline scene::Snapshot plainScene(int size = 150) {
  scene::Snapshot s = frame::test::litScene(frame::test::Hides::some, size);
  s.settings.ao.enabled = false;
  return s;
}

/// As this process traces it.
inline Image expectedImage(const scene::Snapshot& snapshot, uint32_t missColor = 0) {
  frame::Renderer renderer;
  Image image;
  image.missColor = missColor;
  scene::TraceCost cost;
  std::string error;
  EXPECT_TRUE(renderer.render(snapshot, image, cost, error)) << error;
  return image;
}

inline void expectSame(const Image& a, const Image& b) {
  EXPECT_TRUE(a.x == b.x && a.y == b.y && shapeOf(a) == shapeOf(b));
  EXPECT_TRUE(a.color == b.color);
  EXPECT_TRUE(a.wideColor == b.wideColor);
  EXPECT_TRUE(a.depth == b.depth);
  EXPECT_TRUE(a.transmittance == b.transmittance);
  EXPECT_TRUE(a.centerDepth == b.centerDepth);
  EXPECT_TRUE(a.layers.open == b.layers.open && a.layers.before == b.layers.before);
}

}  // namespace gluray::cluster::test
