#include "gl/welding/weld_behind.h"

#include "base/background_job.h"
#include "base/timeline.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace gluray::gl {

struct WeldBehind::State {
  struct Piece {
    GrowingArray<float> vertices;
    uint32_t count = 0;
  };

  Run run;  // used by the thread alone until `over`
  uint32_t stride = 0;
  pid_t process = getpid();

  std::mutex mutex;
  std::condition_variable arrived, welded;
  std::array<Piece, kPieces> ring;  // `waiting` pieces from `first`, which is being welded
  uint32_t first = 0, waiting = 0;
  bool complete = false;  // no more pieces come
  bool over = false;      // the thread no longer accesses this object
  BackgroundJob job;      // last member: the thread ends before the others are destroyed

  Piece& next() { return ring[(first + waiting) % kPieces]; }

  /// Makes room for `more` vertices. Throws std::bad_alloc, with nothing changed.
  void reserve(uint32_t more) {
    const size_t floats = size_t{run.kept + more} * stride;
    if (floats > run.vertices.capacity())
      run.vertices.reserve(std::max(floats, size_t{run.kept} * 2 * stride));
  }

  void weldFirst() {
    const Piece& piece = ring[first];
    reserve(piece.count);
    run.kept = run.welder.weld(run.vertices.data(), stride, run.kept, piece.vertices.data(), piece.count,
                               run.indices);
  }

  void popFirst() { first = (first + 1) % kPieces, --waiting; }

  void weldAll(const std::atomic<bool>& cancelled) {
    constexpr std::chrono::milliseconds kNap(20);  // interval at which `cancelled` is checked
    std::unique_lock lock(mutex);
    while (!cancelled) {
      if (waiting == 0) {
        if (complete) return;
        arrived.wait_for(lock, kNap);
        continue;
      }
      lock.unlock();
      {
        const timeline::Span span("weld", ring[first].count, true);
        weldFirst();
      }
      lock.lock();
      popFirst();
      welded.notify_one();
    }
  }

  void work(const std::atomic<bool>& cancelled) {
    timeline::nameThread("welds");
    try {
      weldAll(cancelled);
    } catch (...) {  // no memory: finish() welds the remaining pieces
    }
    const std::lock_guard lock(mutex);
    over = true;
    welded.notify_one();
  }

  /// A forked child has no such thread, and the lock may stay held for ever.
  void checkProcess() const {
    if (process != getpid()) throw std::runtime_error("the process was forked between glBegin and glEnd");
  }
};

WeldBehind::WeldBehind() = default;
WeldBehind::~WeldBehind() { drop(); }

bool WeldBehind::start(Run& run, uint32_t stride, uint32_t pieceVertices,
                       GrowingArray<float>& piece) noexcept {
  try {
    auto state = std::make_unique<State>();
    GrowingArray<float> memory;
    memory.reserve(size_t{pieceVertices} * stride);
    for (State::Piece& p : state->ring) p.vertices.reserve(size_t{pieceVertices} * stride);
    state->stride = stride;
    BackgroundJob::Work work = [s = state.get()](const std::atomic<bool>& cancelled) { s->work(cancelled); };
    std::swap(state->run, run);
    if (!state->job.start(std::move(work), BackgroundJob::Priority::usual))
      return std::swap(state->run, run), false;
    piece = std::move(memory);
    state_ = std::move(state);
    return true;
  } catch (const std::bad_alloc&) { return false; }
}

bool WeldBehind::hand(GrowingArray<float>& piece, uint32_t vertices) {
  State& s = *state_;
  s.checkProcess();
  std::unique_lock lock(s.mutex);
  s.welded.wait(lock, [&] { return s.over || s.waiting < kPieces; });
  if (s.over) return false;
  State::Piece& place = s.next();
  std::swap(place.vertices, piece);
  place.count = vertices;
  ++s.waiting;
  s.arrived.notify_one();
  return true;
}

WeldBehind::Run WeldBehind::finish(uint32_t more) {
  State& s = *state_;
  s.checkProcess();
  {
    std::unique_lock lock(s.mutex);
    s.complete = true;
    s.arrived.notify_one();
    s.welded.wait(lock, [&] { return s.over; });
  }
  for (; s.waiting > 0; s.popFirst()) s.weldFirst();  // pieces left when the thread ran out of memory
  s.reserve(more);
  Run run = std::move(s.run);
  state_.reset();
  return run;
}

void WeldBehind::drop() noexcept {
  if (state_ && state_->process != getpid())
    (void)state_.release();  // forked: its thread and lock belong to the parent
  else
    state_.reset();
}

}  // namespace gluray::gl
