// Traces one picture in a thread of its own while the program goes on: frame lag. The thread starts with the
// first picture and ends after a while without any. GL thread, one per context; overdue pictures are shown by
// that thread.
#pragma once
#include "base/background_job.h"
#include "frame/tracer.h"

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

  /// What is done with a picture that nobody has taken at some time: `show` is called, once.
  struct Late {
    Clock::time_point due{};
    std::function<void(const Image&)> show;  // must not throw; empty: nothing
  };

  explicit TraceAhead(Trace trace);
  ~TraceAhead();
  TraceAhead(const TraceAhead&) = delete;
  TraceAhead& operator=(const TraceAhead&) = delete;

  /// Begins; misses get that colour. Nothing may be under way. False where there is no thread to be had.
  bool start(scene::SnapshotPtr snapshot, uint32_t missColor, Late late);
  /// Whether it traces, or has traced, this very snapshot, and nobody has taken the picture.
  bool has(const scene::Snapshot& snapshot) const { return snapshot_.get() == &snapshot; }
  /// Waits for the picture and exchanges it for `image`. False, with one line, where it failed.
  bool take(Image& image, scene::TraceCost& cost, std::string& error);
  /// Nobody wants the picture. Waits for it all the same.
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
  scene::SnapshotPtr snapshot_;  // of the GL thread, which keeps it alive
  std::mutex mutex_;             // of what follows
  std::condition_variable changed_;
  State state_ = State::empty;
  bool ended_ = true;  // the thread takes no more pictures
  bool showing_ = false;
  const scene::Snapshot* traced_ = nullptr;
  Late late_;
  // While state_ is tracing, or it is shown, the thread's alone; else the GL thread's.
  Image image_;
  scene::TraceCost cost_;
  std::string error_;
  BackgroundJob thread_;  // the last: it ends before the rest goes
};

}  // namespace gluray::frame
