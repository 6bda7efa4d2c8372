// Refines the images in a window on a thread of its own while the program is idle (adr/0046). Called on the
// GL thread, one per context. The thread starts with the first frame and ends after a second without one.
#pragma once
#include "base/background_job.h"
#include "frame/idle/idle_image.h"
#include "frame/tracing/tracer.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace gluray::frame {

class IdleRefiner {
 public:
  using Clock = std::chrono::steady_clock;

  /// Totals of the process, for reports.
  struct Counts {
    std::atomic<uint64_t> frames{0},
        refused{0};  // refined; refused because the window does not show the written images
    std::atomic<uint64_t> passes{0}, shown{0};  // images put into windows
    std::atomic<uint64_t> framePasses{0};       // of the last refined frame
    std::atomic<uint64_t> finished{0};          // frames that have reached their target noise
    std::atomic<double> noise{0};               // estimated noise of the last refined frame; 0: none
  };
  static Counts& counts();

  /// `quiet`: idle time of the program before refinement begins; longer if its frames take longer.
  IdleRefiner(Tracer tracer, Clock::duration quiet);
  ~IdleRefiner();
  IdleRefiner(const IdleRefiner&) = delete;
  IdleRefiner& operator=(const IdleRefiner&) = delete;

  /// Reports a shown frame, to be refined while the program is idle. Stops work on the previous frame.
  /// Without a window the frame is only stored; null: no frame.
  void start(std::unique_ptr<IdleFrame> frame) noexcept;
  /// Stops, and waits until the thread uses neither renderer nor window: at most the time of one tile.
  void stop() noexcept;
  /// Whether the last window that was looked at did not show its images unchanged. Any thread.
  bool refused() const noexcept { return refused_; }
  /// Whether no frame is left to refine: it has its target noise, its window was changed, or there is none.
  /// Any thread.
  bool isResting() noexcept;
  /// The frame of the last start(); null: none. Before stop(), only its size may be read.
  IdleFrame* frame() noexcept { return frame_.get(); }
  /// Continues with that frame after stop(), if its window has not changed.
  void resume() noexcept;
  /// Hands over the refinement of the image with this id; null: none. Call after stop().
  std::unique_ptr<Refinement> takePasses(uint64_t id) noexcept;

 private:
  enum class State { empty, waiting, working };
  void begin(Clock::time_point due);
  void run(const std::atomic<bool>& cancelled);
  void workOnce(std::unique_lock<std::mutex>& lock, const std::atomic<bool>& cancelled);
  void refine(IdleFrame& frame, const Trace& trace, const std::function<bool()>& ends);

  Tracer tracer_;
  Clock::duration quiet_;
  std::atomic<bool> stop_{false}, refused_{false};
  std::mutex mutex_;  // guards the members below
  std::condition_variable changed_;
  State state_ = State::empty;
  bool ended_ = true;                    // the thread takes no more frames
  Clock::time_point due_{}, started_{};  // started_: used by the GL thread only
  std::unique_ptr<IdleFrame> frame_;     // owned by the thread while state_ is working
  BackgroundJob thread_;                 // last member: the thread ends before the others are destroyed
};

}  // namespace gluray::frame
