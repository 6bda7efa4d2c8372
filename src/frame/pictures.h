// Provides a context's pictures: from the cache of earlier frames, traced ahead by a thread, or traced now.
// GL thread, one per context.
#pragma once
#include "frame/last_pictures.h"
#include "frame/trace_ahead.h"
#include "frame/tracer.h"

#include <memory>
#include <optional>
#include <string>

namespace gluray::frame {

class Pictures {
 public:
  /// A picture, or null if tracing failed, and its cost.
  struct Result {
    const LastPictures::Picture* picture = nullptr;  // valid until the next call of of()
    bool repeated = false;                           // from an earlier frame
    scene::TraceCost cost;
    std::string why;  // one line, if tracing failed
  };

  explicit Pictures(Trace trace, Improves improves = {})
      : trace_(std::move(trace)), improves_(std::move(improves)) {}

  /// The picture of `snapshot`, with misses in `missColor` if given. `mayRepeat`: may be an earlier frame's.
  Result of(const scene::Snapshot& snapshot, bool mayRepeat, std::optional<uint32_t> missColor);
  /// Whether an earlier frame's picture is available.
  bool knows(const scene::Snapshot& snapshot, std::optional<uint32_t> missColor) noexcept {
    return last_.of(snapshot, missColor) != nullptr;
  }
  /// Starts tracing ahead: see TraceAhead::start().
  bool startAhead(scene::SnapshotPtr snapshot, uint32_t missColor, TraceAhead::Late late);
  /// Discards the picture that is traced ahead.
  void dropAhead() noexcept;

 private:
  Trace trace_;
  Improves improves_;
  LastPictures last_;
  std::unique_ptr<TraceAhead> ahead_;  // made at the first lagged frame
};

}  // namespace gluray::frame
