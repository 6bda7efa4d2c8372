// Reads the framebuffer's depth and colours for traced layers, and prepares reads of the program. Implemented
// in intercept/present/. GL thread, context current; restores all state.
#pragma once
#include "gl/batch/present_result.h"
#include "gl/real/real.h"
#include "scene/snapshot.h"

#include <cstdint>
#include <vector>

namespace gluray::gl {

/// The base class reads nothing.
class FramebufferReader {
 public:
  virtual ~FramebufferReader() = default;
  /// Reads the bound draw framebuffer's window depths in `region`, bottom row first, one sample a pixel.
  /// False if it has no depth, or it cannot be read. No error may be pending. Never throws.
  virtual bool readDepth(const RealGl&, const scene::Region& /*region*/,
                         std::vector<float>& /*out*/) noexcept {
    return false;
  }
  /// The same for its colours: RGBA8 as stored, red in the lowest byte.
  virtual bool readColors(const RealGl&, const scene::Region& /*region*/,
                          std::vector<uint32_t>& /*out*/) noexcept {
    return false;
  }
  /// readColors() of a multisampled framebuffer: the mean of each pixel's samples.
  virtual bool readResolved(const RealGl&, const scene::Region& /*region*/,
                            std::vector<uint32_t>& /*out*/) noexcept {
    return false;
  }
  /// readDepth() of a multisampled framebuffer: of each pixel's samples the largest depth or, if `least`, the
  /// smallest, rounded to 23 bits.
  virtual bool readFarthest(const RealGl&, const scene::Region& /*region*/, bool /*least*/,
                            std::vector<float>& /*out*/) noexcept {
    return false;
  }
  /// All that a multisampled framebuffer holds in `region`, only to be compared: bits of its resolved colours
  /// and of the depths of all samples.
  virtual bool readSamples(const RealGl&, const scene::Region& /*region*/,
                           std::vector<uint32_t>& /*out*/) noexcept {
    return false;
  }
  /// Binds a framebuffer of ours for drawing that is like the program's multisampled framebuffer object,
  /// which is bound, and has its depths in `region` at the same pixels. Colours: none or, if `colors`, black
  /// ones. readFarthest() and readSamples() read it until unbindCopy(). False: nothing was bound. No error
  /// may be pending. Never throws.
  virtual bool bindCopy(const RealGl&, const scene::Region& /*region*/, bool /*colors*/) noexcept {
    return false;
  }
  /// Binds the program's framebuffer again. Call after bindCopy() has bound one.
  virtual void unbindCopy(const RealGl&) noexcept {}
  /// Whether blending by alpha, added up, leaves nothing of what was below where alpha is gl::Opacity::kMin
  /// or more, in framebuffers whose colours are normalised bytes; and whether shaders compute the number of
  /// min(), max() and clamp() of a number and a NaN. No error may be pending. Never throws.
  virtual bool replacesColors(const RealGl&) noexcept { return false; }
  /// Keeps a copy of the bound draw framebuffer's colours, depths and stencil values in `region`. False: it
  /// cannot. No error may be pending. Never throws.
  virtual bool keep(const RealGl&, const scene::Region& /*region*/) noexcept { return false; }
  /// Puts the copy of the last keep() back into the same framebuffer, which is bound.
  virtual void putBack(const RealGl&) noexcept {}
  /// The program reads colours of this region of the bound read framebuffer next. If that holds images with
  /// light as they were written, finishes them and binds a copy with the finished ones for reading. Not
  /// traced: nothing was bound. Never throws.
  virtual PresentResult bindFinished(const RealGl&, const scene::Region& /*region*/) noexcept { return {}; }
  /// Binds the program's framebuffer again. Call after bindFinished() has bound a copy.
  virtual void unbindFinished(const RealGl&) noexcept {}
};

}  // namespace gluray::gl
