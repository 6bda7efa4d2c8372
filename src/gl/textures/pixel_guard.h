// Protects the program's state of pixel transfers while textures are read. GL thread.
#pragma once
#include "gl/real/state_queries.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <iterator>

namespace gluray::gl {

/// Resets pack and pixel transfer state while texels are fetched; the destructor restores the program's.
class PixelGuard {
 public:
  PixelGuard(const RealGl& real, bool fixedFunction) : real_(real), transfers_(fixedFunction) {
    for (size_t i = 0; i < std::size(kPack); ++i) {
      real.GetIntegerv(kPack[i], &pack_[i]);
      real.PixelStorei(kPack[i], kPack[i] == GL_PACK_ALIGNMENT ? 4 : 0);
    }
    for (size_t i = 0; transfers_ && i < std::size(kTransfer); ++i) {
      real.GetFloatv(kTransfer[i], &transfer_[i]);
      const GLfloat neutral = i < kScales ? 1.0f : 0.0f;
      if (transfer_[i] != neutral) real.PixelTransferf(kTransfer[i], neutral);
    }
    if (isPresent(real.GenBuffers)) {
      buffer_ = static_cast<GLuint>(integer(real, GL_PIXEL_PACK_BUFFER_BINDING));
      if (buffer_) real.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    }
  }
  ~PixelGuard() {
    for (size_t i = 0; i < std::size(kPack); ++i) real_.PixelStorei(kPack[i], pack_[i]);
    for (size_t i = 0; transfers_ && i < std::size(kTransfer); ++i)
      if (transfer_[i] != (i < kScales ? 1.0f : 0.0f)) real_.PixelTransferf(kTransfer[i], transfer_[i]);
    if (buffer_) real_.BindBuffer(GL_PIXEL_PACK_BUFFER, buffer_);
  }
  PixelGuard(const PixelGuard&) = delete;
  PixelGuard& operator=(const PixelGuard&) = delete;

 private:
  static constexpr GLenum kPack[] = {GL_PACK_ALIGNMENT,    GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS,
                                     GL_PACK_SKIP_PIXELS,  GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST,
                                     GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES};
  static constexpr size_t kScales = 5;
  static constexpr GLenum kTransfer[] = {GL_RED_SCALE,   GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE,
                                         GL_DEPTH_SCALE, GL_RED_BIAS,    GL_GREEN_BIAS, GL_BLUE_BIAS,
                                         GL_ALPHA_BIAS,  GL_DEPTH_BIAS,  GL_MAP_COLOR};
  const RealGl& real_;
  bool transfers_;  // core profiles have no pixel transfer
  GLint pack_[std::size(kPack)] = {};
  GLfloat transfer_[std::size(kTransfer)] = {};
  GLuint buffer_ = 0;
};

}  // namespace gluray::gl
