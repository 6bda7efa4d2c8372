// Frame lag: traces one image on a thread of its own while the program continues. The thread starts with
// the first image and ends after a second without one. Called on the GL thread, one per context; the
// tracing thread shows overdue images.
#pragma once
#include "base/background_job.h"
#include "frame/tracing/tracer.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>

namespace gluray::frame {

class TraceAhead {
 public:
  using Clock = std::chrono::steady_clock;

  /// Deadline of an image: if nobody has taken it by `due`, `show` is called once.
  struct Late {
    Clock::time_point due{};
    std::function<void(const Image&)> show;  // must not throw; empty: nothing
  };

  explicit TraceAhead(Trace trace);
  ~TraceAhead();
  TraceAhead(const TraceAhead&) = delete;
  TraceAhead& operator=(const TraceAhead&) = delete;

  /// Starts tracing, with misses in `missColor`. No image may be pending. False if no thread can start.
  bool start(scene::SnapshotPtr snapshot, uint32_t missColor, Late late);
  /// Whether the pending or finished image is of this very snapshot object.
  bool has(const scene::Snapshot& snapshot) const { return snapshot_.get() == &snapshot; }
  /// Waits for the image and swaps it into `image`. False, with one line in `error`, if tracing failed.
  bool takeImage(Image& image, scene::TraceCost& cost, std::string& error);
  /// Discards the image, after waiting for it.
  void drop() noexcept;

 private:
  enum class State { empty, waiting, tracing, done, failed };
  void run(const std::atomic<bool>& cancelled);
  void traceOne(std::unique_lock<std::mutex>& lock);
  void showLate(std::unique_lock<std::mutex>& lock);
  Clock::time_point wakes() const;
  bool startThread();
  bool wait();

  Trace trace_;
  scene::SnapshotPtr snapshot_;  // used by the GL thread only; keeps the snapshot alive
  std::mutex mutex_;             // guards the members below
  std::condition_variable changed_;
  State state_ = State::empty;
  bool ended_ = true;  // the thread takes no more images
  bool showing_ = false;
  const scene::Snapshot* traced_ = nullptr;
  Late late_;
  // Owned by the tracing thread while state_ is tracing or showing_; otherwise by the GL thread.
  Image image_;
  scene::TraceCost cost_;
  std::string error_;
  BackgroundJob thread_;  // last member: the thread ends before the others are destroyed
};

}  // namespace gluray::frame
