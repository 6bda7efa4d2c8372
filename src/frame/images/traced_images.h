// Provides a context's images: from the cache of earlier frames, traced ahead by a thread, or traced now.
// GL thread, one per context.
#pragma once
#include "frame/images/frame_images.h"
#include "frame/images/image_cache.h"
#include "frame/refinement/refiner.h"
#include "frame/tracing/trace_ahead.h"
#include "frame/tracing/tracer.h"

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gluray::frame {

class TracedImages {
 public:
  /// An image, or null if tracing failed, and its cost.
  struct Result {
    const ImageCache::CachedImage* cached = nullptr;  // valid until the next call of imageOf()
    bool repeated = false;                            // from an earlier frame
    scene::TraceCost cost;
    std::string why;  // one line, if tracing failed
    // For images with light: passes traced in this call, and estimated noise; infinite: unknown.
    uint32_t passes = 0;
    double noise = std::numeric_limits<double>::infinity();
  };
  /// What the caller accepts. Images without light are always finished.
  struct Wish {
    bool mayRepeat = true;              // an earlier frame's image
    std::optional<uint32_t> missColor;  // the colour of misses, if it matters
    bool finished = false;              // light only at the noise of the settings
    bool asShown = false;               // an earlier frame's image without further refinement
    bool anew = false;                  // scene::LightSampling::anew
    bool averages = true;               // of an image made anew: as many samples as settings ask for
  };

  explicit TracedImages(Tracer tracer) : tracer_(std::move(tracer)) {}

  /// Returns the image of `snapshot`. An image that is not yet finished starts with one pass, and gets
  /// more passes for a limited time in each further call.
  Result imageOf(const scene::Snapshot& snapshot, const Wish& wish);
  /// Whether an earlier frame's image is available.
  bool knows(const scene::Snapshot& snapshot, std::optional<uint32_t> missColor) noexcept {
    return lastOf(snapshot, missColor) || recolorable(snapshot);
  }
  /// The images of this frame that were written.
  FrameImages& frame() { return frame_; }
  /// Starts tracing ahead: see TraceAhead::start().
  bool startAhead(scene::SnapshotPtr snapshot, uint32_t missColor, TraceAhead::Late late);
  /// Discards the image that is traced ahead.
  void dropAhead() noexcept;

 private:
  void tellShown(const scene::Snapshot& snapshot, const ImageCache::CachedImage& cached,
                 const Result& result) noexcept;
  bool traceOnce(const scene::Snapshot& snapshot, bool full, const Wish& wish,
                 ImageCache::CachedImage& cached, Result& result);
  ImageCache::CachedImage* lastOf(const scene::Snapshot& snapshot,
                                  std::optional<uint32_t> missColor = {}) noexcept;
  ImageCache::CachedImage* recolorable(const scene::Snapshot& snapshot) noexcept;
  ImageCache::CachedImage* ofColor(const scene::Snapshot& snapshot,
                                   std::optional<uint32_t> missColor) noexcept;
  ImageCache::CachedImage* known(const scene::Snapshot& snapshot, const Wish& wish, bool refines) noexcept;
  bool finish(const scene::Snapshot& snapshot, ImageCache::CachedImage& cached, Result& result) noexcept;
  void refine(const scene::Snapshot& snapshot, ImageCache::CachedImage& cached, bool finish,
              Result& result) noexcept;

  Tracer tracer_;
  ImageCache last_;
  FrameImages frame_{tracer_, last_};
  std::unique_ptr<TraceAhead> ahead_;  // made at the first lagged frame
};

}  // namespace gluray::frame
