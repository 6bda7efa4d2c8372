// The traced images of a frame. Refines them in the window while the program is idle, and finishes them for
// a program that reads the frame. GL thread, one per context.
#pragma once
#include "frame/idle/idle_refiner.h"
#include "frame/images/image_cache.h"
#include "frame/tracing/tracer.h"

#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace gluray::frame {

class FrameImages {
 public:
  /// `last` holds the refinement of the current frame's images, and must outlive this.
  FrameImages(const Tracer& tracer, ImageCache& last) : tracer_(tracer), last_(last) {}

  /// Reports an image that was written into the frame as `pixels`; `how`: its samples were resolved.
  /// Remembers the image if it can be refined.
  void wrote(const scene::SnapshotPtr& snapshot, const ImageCache::CachedImage& cached, const Image& pixels,
             const scene::Resolve* how = nullptr) noexcept;
  /// The image of `before` is no longer in the frame. Call before wrote() for the one in its place.
  void replaces(const scene::Snapshot& before) noexcept;
  /// Reports that a region of the frame was anti-aliased. `before`: its previous pixels, RGBA8.
  void antialiased(const scene::Fxaa& how, const scene::Region& region, const uint32_t* before,
                   const Settings& settings) noexcept;
  /// Refines the frame's images in the window of `open` while the renderer is idle. Without a window it
  /// only remembers the images; without `open` it stops remembering.
  void refineWhileIdle(const std::function<std::shared_ptr<IdleWindow>()>& open) noexcept;
  /// Whether a frame like the last one will be refined in its window, as far as is known.
  bool restsInWindow() const noexcept { return inWindow_ && idle_ && !idle_->refused(); }
  /// Call when the program draws: stops refining the window.
  void stop() noexcept;
  /// Call when an image of another frame is requested.
  void nextFrame() noexcept { stop(), shown_ = false; }
  /// Hands over the refinement of the image with this id; null: none. Call after nextFrame().
  std::unique_ptr<Refinement> takePasses(uint64_t id) noexcept;

  /// Framebuffer regions of the remembered images of this frame, or of the last frame if it is shown and no
  /// other frame has begun. Throws std::bad_alloc.
  std::vector<scene::Region> regions() const;
  struct Finished {
    bool any = false;  // `window` has finished pixels
    uint32_t passes = 0;
    double noise = 0;  // of the noisiest image
    scene::TraceCost cost;
  };
  /// Refines the images that are visible in `window` until they are finished, and writes them there.
  Finished finishIn(const std::shared_ptr<IdleWindow>& window) noexcept;

 private:
  IdleFrame* remembered();
  void forget() noexcept { written_.clear(), antialiased_.clear(), read_.reset(), tooMany_ = false; }
  std::vector<IdleImage> takePasses(std::vector<IdleImage> images) noexcept;
  void takeBackPasses() noexcept;

  const Tracer& tracer_;
  ImageCache& last_;
  std::vector<IdleImage> written_;     // of this frame
  std::vector<IdleFxaa> antialiased_;  // over these
  bool tooMany_ = false;               // more than are remembered
  std::unique_ptr<IdleFrame> read_;    // with refinement, once the program has read them
  std::unique_ptr<IdleRefiner> idle_;  // made with the first frame that is refined while idle
  bool inWindow_ = false;              // that frame has a window
  bool shown_ = false;                 // idle_ has the previous frame
  bool rests_ = false;                 // the program has drawn nothing since that frame was shown
};

}  // namespace gluray::frame
