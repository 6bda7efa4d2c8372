// The pictures that were written into a frame: refined in its window while the program draws nothing, and
// finished for a program that reads the frame. GL thread, one per context.
#pragma once
#include "frame/pictures/last_pictures.h"
#include "frame/refinement/idle_refiner.h"
#include "frame/tracing/tracer.h"

#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace gluray::frame {

class FramePictures {
 public:
  /// `last` has the passes over the current frame's pictures, and must outlive this.
  FramePictures(const Tracer& tracer, LastPictures& last) : tracer_(tracer), last_(last) {}

  /// A picture was written into the frame, as `pixels`; `how`: its samples were resolved. Remembered if it
  /// can be refined.
  void wrote(const scene::SnapshotPtr& snapshot, const LastPictures::Picture& picture, const Image& pixels,
             const scene::Resolve* how = nullptr) noexcept;
  /// What was written into the region of the frame was anti-aliased: `before` are its pixels, RGBA8.
  void antialiased(const scene::Fxaa& how, const scene::Region& region, const uint32_t* before,
                   const Settings& settings) noexcept;
  /// The frame is in the window that `open` opens: refines its pictures there while nothing else is asked.
  /// Without a window they are only remembered; without `open` nothing is from now on.
  void refineWhileIdle(const std::function<std::shared_ptr<IdleWindow>()>& open) noexcept;
  /// The program draws something: the window is not refined any more.
  void stop() noexcept;
  /// A picture of another frame is asked for.
  void nextFrame() noexcept { stop(), shown_ = false; }
  /// Hands over the passes over the picture of this id; null: there are none. Call after nextFrame().
  std::unique_ptr<Refinement> takePasses(uint64_t id) noexcept;

  /// Where the remembered pictures of this frame are in its framebuffer, or those of the last frame, if it is
  /// shown and no other one began. Throws std::bad_alloc.
  std::vector<scene::Region> regions() const;
  struct Finished {
    bool any = false;  // `window` has finished pixels
    uint32_t passes = 0;
    double noise = 0;  // of the noisiest picture
    scene::TraceCost cost;
  };
  /// Refines those of these pictures that `window` shows until they are finished, and puts them there.
  Finished finishIn(const std::shared_ptr<IdleWindow>& window) noexcept;

 private:
  IdleFrame* remembered();
  void forget() noexcept { written_.clear(), antialiased_.clear(), read_.reset(), tooMany_ = false; }
  std::vector<IdlePicture> takePasses(std::vector<IdlePicture> pictures) noexcept;
  void takeBackPasses() noexcept;

  const Tracer& tracer_;
  LastPictures& last_;
  std::vector<IdlePicture> written_;   // of this frame
  std::vector<IdleFxaa> antialiased_;  // over these
  bool tooMany_ = false;               // more than are remembered
  std::unique_ptr<IdleFrame> read_;    // the same with their passes, once the program has read them
  std::unique_ptr<IdleRefiner> idle_;  // made at the first frame that is refined while idle
  bool shown_ = false;                 // idle_ has the frame before this one
  bool rests_ = false;                 // the program has drawn nothing since that was shown
};

}  // namespace gluray::frame
