// Snapshot of the objects that each context drew last, for the control thread. Without requests, nothing is
// stored, and a frame costs one atomic load. Any thread.
#pragma once
#include "base/clock.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace gluray::gl {

/// One traced batch of a frame.
struct ShownBatch {
  scene::SnapshotPtr snapshot;
  uint32_t framebuffer = 0;  // OpenGL's name; 0: the window
};

/// A frame that was shown: its batches in the order of drawing. Their surfaces have numbers.
struct ShownFrame {
  uint64_t frame = 0;  // as SettingsSource counts; 0: not known, it may not be whole yet
  std::vector<ShownBatch> batches;
  std::vector<glm::ivec4> places;  // where images of framebuffer objects may be in the window
  double when = nowSeconds();      // it was shown
};
using ShownFramePtr = std::shared_ptr<const ShownFrame>;

class ShownFrames {
 public:
  /// Frames are kept until this time, on the clock nowSeconds(); 0: not at all, and those that are kept are
  /// forgotten.
  void wantUntil(double when) noexcept;
  bool wanted() const noexcept {
    const double until = until_.load(std::memory_order_relaxed);
    return until > 0 && nowSeconds() < until;
  }
  /// Call when a context has shown a frame, or in one that never swaps when it has traced a batch; replaces
  /// its last one. `context` is any key of it.
  void show(const void* context, ShownFramePtr frame) noexcept;
  /// Call when the frame that show() was given last is over, and the context draws another.
  void whole(const void* context) noexcept;
  /// Call when the context keeps none any more.
  void forget(const void* context) noexcept;
  /// The last frame of the context that traced one last; if none has traced any, the last one. Null: none was
  /// shown. Of frames that may not be whole, those before them while they change.
  ShownFramePtr last() const;
  /// The same of each context that has traced any.
  std::vector<ShownFramePtr> all() const;
  /// ShownFrame::places of the frame that was shown last and has some: a toolkit may have a context of its
  /// own for its windows.
  std::vector<glm::ivec4> places() const;

 private:
  struct Entry {
    const void* context;
    ShownFramePtr frame, whole;  // the last one; the last whole one before it, or null
    const ShownFramePtr& settled(double now) const {
      return frame->frame == 0 && whole && now - frame->when < kSettles ? whole : frame;
    }
  };
  static constexpr double kSettles = 0.1;  // seconds without another batch
  std::atomic<double> until_{0};
  mutable std::mutex mutex_;
  std::vector<Entry> entries_;  // the last shown one at the end
};

/// The process's. Never destroyed.
ShownFrames& shownFrames();

}  // namespace gluray::gl
