// Reads the framebuffer's depth and colours for traced layers, and prepares reads by the program. Implemented
// in intercept/present/. GL thread, context current; restores all state.
#pragma once
#include "gl/batch/present_result.h"
#include "gl/real/real.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace gluray::gl {

/// The base class reads nothing.
class FramebufferReader {
 public:
  virtual ~FramebufferReader() = default;
  /// Reads the bound draw framebuffer's window depths in `region`, bottom row first, one sample per pixel.
  /// Returns false if it has no depth, or if it cannot be read. No error may be pending. Never throws.
  virtual bool readDepth(const RealGl&, const scene::Region& /*region*/,
                         std::vector<float>& /*out*/) noexcept {
    return false;
  }
  /// Reads its colours in the same way: RGBA8 as stored, red in the lowest byte.
  virtual bool readColors(const RealGl&, const scene::Region& /*region*/,
                          std::vector<uint32_t>& /*out*/) noexcept {
    return false;
  }
  /// As readColors(), for colours that are floats: as stored, not clamped.
  virtual bool readFloatColors(const RealGl&, const scene::Region& /*region*/,
                               std::vector<glm::vec4>& /*out*/) noexcept {
    return false;
  }
  /// As readColors(), for a multisampled framebuffer: the mean of each pixel's samples.
  virtual bool readResolved(const RealGl&, const scene::Region& /*region*/,
                            std::vector<uint32_t>& /*out*/) noexcept {
    return false;
  }
  /// As readDepth(), for a multisampled framebuffer: the largest depth of each pixel's samples, or the
  /// smallest if `least`, rounded to 23 bits.
  virtual bool readFarthest(const RealGl&, const scene::Region& /*region*/, bool /*least*/,
                            std::vector<float>& /*out*/) noexcept {
    return false;
  }
  /// Reads all contents of a multisampled framebuffer in `region`, in a form that is only good for
  /// comparison: bits of its resolved colours and of the depths of all samples.
  virtual bool readSamples(const RealGl&, const scene::Region& /*region*/,
                           std::vector<uint32_t>& /*out*/) noexcept {
    return false;
  }
  /// Binds, for drawing, a framebuffer that is like the program's bound multisampled framebuffer object and
  /// has its depths in `region` at the same pixels. It has no colours or, if `colors`, black ones.
  /// readFarthest() and readSamples() read it until unbindCopy(). Returns false if nothing was bound. No
  /// error may be pending. Never throws.
  virtual bool bindCopy(const RealGl&, const scene::Region& /*region*/, bool /*colors*/) noexcept {
    return false;
  }
  /// Binds the program's framebuffer again. Call only after a successful bindCopy().
  virtual void unbindCopy(const RealGl&) noexcept {}
  /// Whether two properties hold. In framebuffers with normalised byte colours, blending by alpha with an
  /// alpha of at least gl::Opacity::kMin leaves nothing of the colour below. In shaders, min(), max() and
  /// clamp() of a number and a NaN return the number. No error may be pending. Never throws.
  virtual bool replacesColors(const RealGl&) noexcept { return false; }
  /// How far, in pixels of the window's axes, gl_PointCoord at a pixel's centre is that of a position beside
  /// it, in framebuffers of `samples` samples: (0, 0) as specified. Found out by drawing, in each call.
  /// Nullopt if it differs from point to point, or cannot be found out. No error may be pending. Never
  /// throws.
  virtual std::optional<glm::vec2> pointCoordinateShift(const RealGl&, int /*samples*/) noexcept {
    return std::nullopt;
  }
  /// Copies the bound draw framebuffer's colours, depths and stencil values in `region`. Returns false if
  /// that is not possible. No error may be pending. Never throws.
  virtual bool keep(const RealGl&, const scene::Region& /*region*/) noexcept { return false; }
  /// Writes the copy of the last keep() back into the same framebuffer, which must be bound.
  virtual void putBack(const RealGl&) noexcept {}
  /// Call before the program reads colours in this region of the bound read framebuffer. If the region
  /// contains images whose light has been written with noise, refines them and binds a copy with the finished
  /// images for reading. Outcome other than traced: nothing was bound. Never throws.
  virtual PresentResult bindFinished(const RealGl&, const scene::Region& /*region*/) noexcept { return {}; }
  /// Binds the program's framebuffer again. Call only after bindFinished() has bound a copy.
  virtual void unbindFinished(const RealGl&) noexcept {}
};

}  // namespace gluray::gl
