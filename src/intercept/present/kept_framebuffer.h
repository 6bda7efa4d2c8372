// A copy of a part of the program's framebuffer, which can be restored to the bit. GL thread, context
// current; restores all state.
#pragma once
#include "base/image.h"
#include "gl/real/real.h"
#include "intercept/present/presented_images.h"
#include "scene/snapshot.h"

#include <GL/gl.h>

namespace gluray::present {

/// The copy is in memory. Mesa (22.3) blits depths between a window and a framebuffer object by a shader,
/// which changes the last bit of 24 bit depths.
class KeptFramebuffer {
 public:
  /// Copies colours of the first draw buffer and depths of the bound draw framebuffer. False: they cannot be
  /// copied, or not be put back exactly.
  bool keep(const gl::RealGl& real, PresentedImages& shared, const scene::Region& region);
  /// Copies them back.
  void putBack(const gl::RealGl& real, PresentedImages& shared);

 private:
  Image image_;
  bool colors_ = false;  // there are some
};

}  // namespace gluray::present
