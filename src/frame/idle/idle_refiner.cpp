#include "frame/idle/idle_refiner.h"

#include "base/never_destroyed.h"
#include "base/timeline.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <thread>
#include <utility>

namespace gluray::frame {
namespace {

using namespace std::chrono_literals;
constexpr auto kNap = 20ms;         // longest time until the thread notices that the process exits
constexpr auto kFollowing = 2s;     // frames that come sooner belong to an animation
constexpr auto kPatience = 1000ms;  // time without frames after which the thread ends

}  // namespace

IdleRefiner::Counts& IdleRefiner::counts() {
  static NeverDestroyed<Counts> counts;
  return *counts;
}

IdleRefiner::IdleRefiner(Tracer tracer, Clock::duration quiet) : tracer_(std::move(tracer)), quiet_(quiet) {}

IdleRefiner::~IdleRefiner() {
  stop_ = true;
  thread_.stop();
}

void IdleRefiner::start(std::unique_ptr<IdleFrame> frame) noexcept {
  stop();
  frame_ = std::move(frame);  // state_ is empty: the thread leaves it alone
  if (!frame_) return;
  try {
    const auto now = Clock::now(), before = std::exchange(started_, now);
    const bool follow = now - before < kFollowing;
    if (frame_->hasWindow()) begin(now + (follow ? std::max(quiet_, (now - before) * 3 / 2) : quiet_));
  } catch (const std::exception&) {}  // out of memory: the image keeps its noise
}

void IdleRefiner::resume() noexcept {
  try {
    if (frame_ && frame_->hasWindow()) begin(Clock::now() + quiet_);
  } catch (const std::exception&) {}
}

/// The thread, which is started if it has ended, works on frame_ when it is `due`.
void IdleRefiner::begin(Clock::time_point due) {
  std::unique_lock lock(mutex_);
  due_ = due;
  stop_ = false;
  state_ = State::waiting;
  const bool runs = !ended_;
  lock.unlock();
  changed_.notify_all();
  if (runs) return;
  thread_.stop();
  ended_ = false;
  if (!thread_.start([this](const std::atomic<bool>& cancelled) { run(cancelled); },
                     BackgroundJob::Priority::usual))
    ended_ = true, state_ = State::empty;
}

void IdleRefiner::stop() noexcept {
  stop_ = true;
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return state_ != State::working; });
  state_ = State::empty;
}

bool IdleRefiner::isResting() noexcept {
  const std::lock_guard lock(mutex_);
  return state_ == State::empty;
}

std::unique_ptr<Refinement> IdleRefiner::takePasses(uint64_t id) noexcept {
  const std::lock_guard lock(mutex_);
  return frame_ ? frame_->takePasses(id) : nullptr;
}

void IdleRefiner::run(const std::atomic<bool>& cancelled) {
  timeline::nameThread("refines");
  std::unique_lock lock(mutex_);
  auto idleSince = Clock::now();
  while (!cancelled) {
    const auto now = Clock::now();
    if (state_ == State::waiting && now >= due_) {
      workOnce(lock, cancelled);
      idleSince = Clock::now();
    } else if (state_ == State::empty && now - idleSince > kPatience) {
      break;
    } else {
      changed_.wait_until(lock, state_ == State::waiting ? std::min(due_, now + kNap) : now + kNap);
    }
  }
  ended_ = true;
  if (state_ == State::working) state_ = State::empty;
  changed_.notify_all();
}

void IdleRefiner::refine(IdleFrame& frame, const Trace& trace, const std::function<bool()>& ends) {
  const bool again = frame.looked();
  if (!frame.readWindow()) {
    if (!again) ++counts().refused, refused_ = true;
    return;
  }
  if (!again) ++counts().frames, counts().framePasses = 0;
  auto step = IdleFrame::Step::more;
  IdleFrame::Done done;
  bool any = false;
  while (step == IdleFrame::Step::more && !ends()) {
    step = frame.step(tracer_, trace, done);
    counts().passes += done.traced, counts().framePasses += done.traced;
    counts().shown += done.shown;
    any = any || done.traced;
    if (std::isfinite(frame.noise())) counts().noise = frame.noise();
  }
  refused_ = frame.refused();
  if (again && !any) return;
  if (step == IdleFrame::Step::done && !frame.refused()) ++counts().finished;
  if (frame.refused()) ++counts().refused;
}

/// Refines the frame until it is finished or the GL thread stops it.
void IdleRefiner::workOnce(std::unique_lock<std::mutex>& lock, const std::atomic<bool>& cancelled) {
  state_ = State::working;
  IdleFrame& frame = *frame_;
  lock.unlock();
  const timeline::Span span("refine");
  const auto ends = [&] { return stop_ || cancelled; };
  // Another thread's image may interrupt a pass: then it is traced again.
  const Trace trace = [&](const scene::Snapshot& s, Image& image, scene::TraceCost& cost,
                          std::string& error) {
    while (!ends()) {
      if (tracer_.behind(s, image, cost, error, ends)) return true;
      if (!error.empty()) return false;
      std::this_thread::sleep_for(1ms);
    }
    return false;
  };
  try {
    refine(frame, trace, ends);
  } catch (const std::exception&) {}  // out of memory: the image keeps its noise
  lock.lock();
  state_ = State::empty;
  changed_.notify_all();
}

}  // namespace gluray::frame
