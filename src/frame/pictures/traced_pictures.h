// Provides a context's pictures: from the cache of earlier frames, traced ahead by a thread, or traced now.
// GL thread, one per context.
#pragma once
#include "frame/pictures/frame_pictures.h"
#include "frame/pictures/last_pictures.h"
#include "frame/refinement/refiner.h"
#include "frame/tracing/trace_ahead.h"
#include "frame/tracing/tracer.h"

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gluray::frame {

class TracedPictures {
 public:
  /// A picture, or null if tracing failed, and its cost.
  struct Result {
    const LastPictures::Picture* picture = nullptr;  // valid until the next call of pictureOf()
    bool repeated = false;                           // from an earlier frame
    scene::TraceCost cost;
    std::string why;  // one line, if tracing failed
    // For pictures with light: passes traced in this call, and estimated noise; infinite: unknown.
    uint32_t passes = 0;
    double noise = std::numeric_limits<double>::infinity();
  };
  /// What the caller accepts. Pictures without light are always finished.
  struct Wish {
    bool mayRepeat = true;              // an earlier frame's picture
    std::optional<uint32_t> missColor;  // the colour of misses, if it matters
    bool finished = false;              // light only at the noise of the settings
    bool asShown = false;               // an earlier frame's picture without further refinement
  };

  explicit TracedPictures(Tracer tracer) : tracer_(std::move(tracer)) {}

  /// Returns the picture of `snapshot`. A picture that is not yet finished starts with one pass, and gets
  /// more passes for a limited time in each further call.
  Result pictureOf(const scene::Snapshot& snapshot, const Wish& wish);
  /// Whether an earlier frame's picture is available.
  bool knows(const scene::Snapshot& snapshot, std::optional<uint32_t> missColor) noexcept {
    return lastOf(snapshot, missColor) || recolorable(snapshot);
  }
  /// The pictures of this frame that were written.
  FramePictures& frame() { return frame_; }
  /// Starts tracing ahead: see TraceAhead::start().
  bool startAhead(scene::SnapshotPtr snapshot, uint32_t missColor, TraceAhead::Late late);
  /// Discards the picture that is traced ahead.
  void dropAhead() noexcept;

 private:
  void tellShown(const scene::Snapshot& snapshot, const LastPictures::Picture& picture,
                 const Result& result) noexcept;
  bool traceOnce(const scene::Snapshot& snapshot, bool full, LastPictures::Picture& picture, Result& result);
  LastPictures::Picture* lastOf(const scene::Snapshot& snapshot,
                                std::optional<uint32_t> missColor = {}) noexcept;
  LastPictures::Picture* recolorable(const scene::Snapshot& snapshot) noexcept;
  LastPictures::Picture* ofColor(const scene::Snapshot& snapshot, std::optional<uint32_t> missColor) noexcept;
  LastPictures::Picture* known(const scene::Snapshot& snapshot, const Wish& wish, bool refines) noexcept;
  bool finish(const scene::Snapshot& snapshot, LastPictures::Picture& picture, Result& result) noexcept;
  void refine(const scene::Snapshot& snapshot, LastPictures::Picture& picture, bool finish,
              Result& result) noexcept;

  Tracer tracer_;
  LastPictures last_;
  FramePictures frame_{tracer_, last_};
  std::unique_ptr<TraceAhead> ahead_;  // made at the first lagged frame
};

}  // namespace gluray::frame
