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

/// A rectangle of a framebuffer's depth that was cleared.
struct ClearedDepth {
  uint32_t framebuffer = 0;  // OpenGL's name; 0: the window
  scene::Region box;
};

/// One traced batch of a frame.
struct ShownBatch {
  scene::SnapshotPtr snapshot;
  uint32_t framebuffer = 0;           // as of ClearedDepth
  bool strict = true;                 // equal depths fail the depth test
  std::vector<ClearedDepth> cleared;  // since the batch before
};

/// A frame that was shown: its batches in drawing order. Their surfaces are numbered.
struct ShownFrame {
  uint64_t frame = 0;  // number in SettingsSource; 0: unknown, and the frame may be incomplete
  std::vector<ShownBatch> batches;
  std::vector<glm::ivec4> places;  // where images of framebuffer objects may appear in the window
  double when = nowSeconds();      // time at which it was shown
};
using ShownFramePtr = std::shared_ptr<const ShownFrame>;

class ShownFrames {
 public:
  /// Stores frames until time `when` of nowSeconds(). 0: stores none and forgets stored ones.
  void wantUntil(double when) noexcept;
  /// Stores frames whatever wantUntil() says.
  void wantAlways(bool always) noexcept { always_ = always; }
  bool wanted() const noexcept {
    const double until = until_.load(std::memory_order_relaxed);
    return (until > 0 && nowSeconds() < until) || always_.load(std::memory_order_relaxed);
  }
  /// Call when a context has shown a frame; in a context that never swaps, when it has traced a batch.
  /// Replaces the context's last frame. `context` is any key that identifies the context.
  void show(const void* context, ShownFramePtr frame) noexcept;
  /// Call when the frame that was last given to show() is complete and the context begins another.
  void whole(const void* context) noexcept;
  /// Call when the context no longer stores frames.
  void forget(const void* context) noexcept;
  /// The last frame of the context that traced last; if no context has traced, the last frame shown. Null if
  /// none was shown. While a frame may be incomplete and still changes, the complete frame before it.
  ShownFramePtr last() const;
  /// The same for each context that has traced.
  std::vector<ShownFramePtr> all() const;
  /// ShownFrame::places of the last shown frame that has any: a toolkit may use a separate context for its
  /// windows.
  std::vector<glm::ivec4> places() const;

 private:
  struct Entry {
    const void* context;
    ShownFramePtr frame, whole;  // the last frame; the last complete one before it, or null
    const ShownFramePtr& settled(double now) const {
      return frame->frame == 0 && whole && now - frame->when < kSettles ? whole : frame;
    }
  };
  static constexpr double kSettles = 0.1;  // seconds without another batch until a frame counts as complete
  std::atomic<double> until_{0};
  std::atomic<bool> always_{false};
  mutable std::mutex mutex_;
  std::vector<Entry> entries_;  // the last shown one is at the end
};

/// The shown frames of the process. Never destroyed.
ShownFrames& shownFrames();

}  // namespace gluray::gl
