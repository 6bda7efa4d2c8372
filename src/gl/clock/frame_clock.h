// A context's current frame: its number, when it began, and which engine draws it. A part of each Context, GL
// thread.
#pragma once
#include "base/clock.h"
#include "gl/clock/context_info.h"
#include "gl/clock/image_wish.h"
#include "gl/clock/offscreen_animation.h"
#include "gl/trials/engine_choice.h"
#include "scene/light_sampling.h"

#include <GL/gl.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace gluray::gl {

class FrameClock {
 public:
  /// `info` must outlive it.
  FrameClock(const ContextInfo& info, const Settings& settings);

  uint64_t frame = 1;
  double beganSeconds = 0;  // time of this frame's first known clear or draw; 0: none yet
  EngineChoice choice;

  /// Whether draws pass through to the real OpenGL. If so, only lists are captured, and no state is read.
  bool passesThrough() const { return passesThrough_; }
  void setPassthrough(bool passesThrough) { passesThrough_ = passesThrough; }
  /// Whether this frame is being measured. If so, no image may be repeated or delayed.
  bool measured() const { return choice.wantsStop(); }
  /// True while flushes write an image that the program reads.
  bool reads = false;
  /// True while flushes write an image that is about to be shown: by a swap, or by glFlush of a window with
  /// one buffer.
  bool shows = false;
  /// The picture in a framebuffer is finished: it is shown, read or copied next. Throws std::bad_alloc.
  void finishPicture(GLuint framebuffer) {
    if (!hasPicture(framebuffer)) pictures_.push_back(framebuffer);
  }
  /// Whether the framebuffer's picture was finished since forgetPictures().
  bool hasPicture(GLuint framebuffer) const {
    return std::find(pictures_.begin(), pictures_.end(), framebuffer) != pictures_.end();
  }
  void forgetPictures() { pictures_.clear(); }
  /// What a flush requires of its image. `known`: the image was shown before, elsewhere.
  ImageWish wish(bool known = false) const { return {known || !measured(), reads && !animates_}; }
  /// The same for an image that the window already shows: reads find it there (FinishedRead).
  ImageWish wishAsShown() const { return {true, false, true}; }
  /// How light is sampled for the next image: as for moving frames if a visible window shows it, else in
  /// full. In programs without a window, watchesOffscreen() says whether frames may belong to an animation,
  /// which offscreenMode() decides later.
  scene::LightSampling::Mode lightMode(const Settings& settings);
  bool watchesOffscreen(const Settings& settings) const;
  /// How light is sampled for an image of `size` that is about to be traced without a window. `viewFrame`:
  /// frame of its view. Throws std::bad_alloc.
  scene::LightSampling::Mode offscreenMode(glm::ivec2 size, uint64_t viewFrame);
  /// Whether the last image belongs to an animation: then reads return it without refining it.
  bool animates() const { return animates_; }
  /// Reports that the image is complete.
  void drawn() {
    if (isOffscreen_) [[unlikely]]
      offscreen_.drawn(nowSeconds());
  }
  bool startsMeasuring() const { return choice.wantsStart(); }
  /// Whether a surface of `triangles` triangles is left to the real OpenGL, whatever else the frame contains.
  bool leavesAlone(uint64_t triangles, double viewportPixels) const {
    return choice.way() == EngineChoice::Way::mixed && choice.takesAlone(triangles, viewportPixels);
  }
  /// As leavesAlone(), for surfaces that are blended in drawing order.
  bool leavesLayers(uint64_t triangles, double viewportPixels) const {
    return choice.takesLayers(triangles, viewportPixels);
  }

 private:
  bool isShown() const;

  const ContextInfo& info_;
  bool passesThrough_ = false;
  std::vector<GLuint> pictures_;  // framebuffers
  OffscreenAnimation offscreen_;
  bool isOffscreen_ = false, animates_ = false;  // of the last image
};

/// Sets FrameClock::reads or FrameClock::shows while it lives.
class FlushPurpose {
 public:
  FlushPurpose(FrameClock& clock, bool FrameClock::*purpose) : flag_(clock.*purpose) { flag_ = true; }
  ~FlushPurpose() { flag_ = false; }
  FlushPurpose(const FlushPurpose&) = delete;
  FlushPurpose& operator=(const FlushPurpose&) = delete;

 private:
  bool& flag_;
};

}  // namespace gluray::gl
