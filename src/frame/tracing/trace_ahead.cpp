#include "frame/tracing/trace_ahead.h"

#include "base/timeline.h"

#include <utility>

namespace gluray::frame {
namespace {

using namespace std::chrono_literals;
constexpr auto kNapAhead = 20ms;         // longest time until the thread notices that the process exits
constexpr auto kPatienceAhead = 1000ms;  // time without images after which the thread ends

}  // namespace

TraceAhead::TraceAhead(Trace trace) : trace_(std::move(trace)) {}

TraceAhead::~TraceAhead() { thread_.stop(); }

bool TraceAhead::start(scene::SnapshotPtr snapshot, uint32_t missColor, Late late) {
  std::unique_lock lock(mutex_);
  image_.missColor = missColor;
  late_ = std::move(late);
  traced_ = snapshot.get();
  state_ = State::waiting;
  const bool runs = !ended_;
  lock.unlock();
  changed_.notify_all();
  if (!runs && !startThread()) {
    lock.lock();
    return state_ = State::empty, false;
  }
  snapshot_ = std::move(snapshot);
  return true;
}

bool TraceAhead::startThread() {
  thread_.stop();
  ended_ = false;
  if (thread_.start([this](const std::atomic<bool>& cancelled) { run(cancelled); },
                    BackgroundJob::Priority::usual))
    return true;
  ended_ = true;
  return false;
}

void TraceAhead::run(const std::atomic<bool>& cancelled) {
  timeline::nameThread("traces ahead");
  std::unique_lock lock(mutex_);
  auto idleSince = Clock::now();
  while (!cancelled) {
    const auto now = Clock::now(), due = wakes();
    if (state_ == State::waiting)
      traceOne(lock), idleSince = Clock::now();
    else if (now >= due)
      showLate(lock);
    else if (due == Clock::time_point::max() && now - idleSince > kPatienceAhead)
      break;
    else
      changed_.wait_until(lock, std::min(due, now + kNapAhead));
  }
  ended_ = true;
  changed_.notify_all();
}

/// When this thread has to show the image; the maximum: never.
TraceAhead::Clock::time_point TraceAhead::wakes() const {
  return state_ == State::done && late_.show ? late_.due : Clock::time_point::max();
}

void TraceAhead::traceOne(std::unique_lock<std::mutex>& lock) {
  state_ = State::tracing;
  lock.unlock();
  // Nobody else accesses the image and its cost meanwhile.
  error_.clear();
  const bool done = trace_(*traced_, image_, cost_, error_);
  lock.lock();
  state_ = done ? State::done : State::failed;
  changed_.notify_all();
}

void TraceAhead::showLate(std::unique_lock<std::mutex>& lock) {
  const timeline::Span span("show late");
  const auto show = std::exchange(late_.show, nullptr);
  showing_ = true;
  lock.unlock();
  show(image_);
  lock.lock();
  showing_ = false;
  changed_.notify_all();
}

bool TraceAhead::wait() {
  std::unique_lock lock(mutex_);
  late_.show = nullptr;
  const auto settled = [&] {
    const bool started = state_ == State::tracing || showing_ || !ended_;
    return !started || ((state_ == State::done || state_ == State::failed) && !showing_);
  };
  changed_.wait(lock, settled);
  snapshot_.reset();
  return state_ != State::waiting;
}

bool TraceAhead::takeImage(Image& image, scene::TraceCost& cost, std::string& error) {
  const scene::SnapshotPtr snapshot = snapshot_;
  const bool ran = wait();
  std::unique_lock lock(mutex_);
  if (!ran) {  // the process exits, and the thread has ended without tracing
    state_ = State::empty;
    lock.unlock();
    return trace_(*snapshot, image, cost, error);
  }
  cost = cost_;
  const bool done = std::exchange(state_, State::empty) == State::done;
  if (done)
    std::swap(image, image_);
  else
    error = error_;
  return done;
}

void TraceAhead::drop() noexcept {
  if (!snapshot_) return;
  wait();
  const std::lock_guard lock(mutex_);
  state_ = State::empty;
}

}  // namespace gluray::frame
