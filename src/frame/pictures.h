// Where a context's pictures come from: known from an earlier frame, traced ahead by a thread of its own, or
// traced now. GL thread, one per context.
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
  /// A picture, or null where tracing failed, and what it cost to get it.
  struct Result {
    const LastPictures::Picture* picture = nullptr;  // valid until the next call of of()
    bool repeated = false;                           // known from an earlier frame
    scene::TraceCost cost;
    std::string why;  // one line, where tracing failed
  };

  explicit Pictures(Trace trace, Improves improves = {})
      : trace_(std::move(trace)), improves_(std::move(improves)) {}

  /// The picture of `snapshot`, its misses in `missColor` where one is given. `mayRepeat`: a picture of an
  /// earlier frame will do.
  Result of(const scene::Snapshot& snapshot, bool mayRepeat, std::optional<uint32_t> missColor);
  /// Whether the picture of an earlier frame would do.
  bool knows(const scene::Snapshot& snapshot, std::optional<uint32_t> missColor) noexcept {
    return last_.of(snapshot, missColor) != nullptr;
  }
  /// Begins to trace ahead (TraceAhead::start()).
  bool startAhead(scene::SnapshotPtr snapshot, uint32_t missColor, TraceAhead::Late late);
  /// Nobody wants the picture that is traced ahead.
  void dropAhead() noexcept;

 private:
  Trace trace_;
  Improves improves_;
  LastPictures last_;
  std::unique_ptr<TraceAhead> ahead_;  // where frames lag
};

}  // namespace gluray::frame
