// Refines the pictures that a window shows while the program draws nothing, and shows them there, on a thread
// of its own (adr/0046). Called on the GL thread, one per context. The thread starts with the first frame and
// ends after a second without one.
#pragma once
#include "base/background_job.h"
#include "frame/refinement/idle_picture.h"
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

  /// What all of the process have done, for reports.
  struct Counts {
    std::atomic<uint64_t> frames{0}, refused{0};  // refined; not: the window does not show what was written
    std::atomic<uint64_t> passes{0}, shown{0};    // pictures put into windows
    std::atomic<uint64_t> framePasses{0};         // of the last refined frame
    std::atomic<uint64_t> finished{0};            // frames whose noise is as small as it is to be
    std::atomic<double> noise{0};                 // of the last refined frame, estimated; 0: none was
  };
  static Counts& counts();

  /// `quiet`: for so long the program must do nothing until work begins; longer if its frames take longer.
  IdleRefiner(Tracer tracer, Clock::duration quiet);
  ~IdleRefiner();
  IdleRefiner(const IdleRefiner&) = delete;
  IdleRefiner& operator=(const IdleRefiner&) = delete;

  /// A frame was shown: refines its pictures if nothing happens. Stops work on the frame before. Without a
  /// window the frame is only kept; null: there is none.
  void start(std::unique_ptr<IdleFrame> frame) noexcept;
  /// Stops, and waits until the thread touches neither renderer nor window: for one tile of a picture.
  void stop() noexcept;
  /// The frame of the last start(); null: none. Only its size may be asked for before stop().
  IdleFrame* frame() noexcept { return frame_.get(); }
  /// Goes on with that frame after stop(), if its window still shows what it was left with.
  void resume() noexcept;
  /// Hands over the passes over the picture of this id; null: there are none. Call after stop().
  std::unique_ptr<Refinement> takePasses(uint64_t id) noexcept;

 private:
  enum class State { empty, waiting, working };
  void begin(Clock::time_point due);
  void run(const std::atomic<bool>& cancelled);
  void workOnce(std::unique_lock<std::mutex>& lock, const std::atomic<bool>& cancelled);
  void refine(IdleFrame& frame, const Trace& trace, const std::function<bool()>& ends);

  Tracer tracer_;
  Clock::duration quiet_;
  std::atomic<bool> stop_{false};
  std::mutex mutex_;  // guards the members below
  std::condition_variable changed_;
  State state_ = State::empty;
  bool ended_ = true;                    // the thread takes no more frames
  Clock::time_point due_{}, started_{};  // the latter: the GL thread's
  std::unique_ptr<IdleFrame> frame_;     // the thread's while state_ is working
  BackgroundJob thread_;                 // last member: the thread ends before the others are destroyed
};

}  // namespace gluray::frame
