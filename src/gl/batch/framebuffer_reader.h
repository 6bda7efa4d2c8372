// Reads what the framebuffer holds, for batches that are drawn over it. Implemented in
// intercept/present/read_back/. GL thread, context current; all state is put back.
#pragma once
#include "gl/real.h"
#include "scene/snapshot.h"

#include <cstdint>
#include <vector>

namespace gluray::gl {

/// The base class reads nothing.
class FramebufferReader {
 public:
  virtual ~FramebufferReader() = default;
  /// Reads the bound draw framebuffer's window depths in `region`, lowest row first, one sample a pixel.
  /// False where there are none, or they cannot be read. No error may be pending. Never throws.
  virtual bool readDepth(const RealGl&, const scene::Region& /*region*/,
                         std::vector<float>& /*out*/) noexcept {
    return false;
  }
  /// The same of its colours, RGBA8 with red in the lowest byte, as they are kept.
  virtual bool readColors(const RealGl&, const scene::Region& /*region*/,
                          std::vector<uint32_t>& /*out*/) noexcept {
    return false;
  }
};

}  // namespace gluray::gl
