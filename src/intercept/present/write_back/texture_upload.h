// A traced picture sent straight into the textures of a framebuffer object that holds nothing but what it was
// cleared to: nothing is drawn. GL thread, context current, outside glBegin/glEnd.
#pragma once
#include "base/image.h"
#include "frame/hit_bands.h"
#include "gl/batch/presenter.h"
#include "intercept/present/features.h"
#include "intercept/present/write_back/state_guard.h"

#include <optional>
#include <vector>

namespace gluray::present {

class TextureUpload {
 public:
  /// Puts the image, whose misses have the cleared colour, into the bound draw framebuffer's textures, as
  /// WriteBack::write() would have drawn it with GL_LEQUAL over a depth of 1. False where textures are of
  /// other kinds, or something went wrong: then what was put so far may be drawn over. Errors that were
  /// pending are moved to `pending`. Works on as many threads as `threads` says (0: all). No state that the
  /// program can query differs afterwards.
  bool put(const gl::RealGl& real, const Features& features, const Image& image, int threads,
           PendingErrors& pending);

 private:
  struct Attached {
    GLuint color = 0, depth = 0;  // textures
    GLenum depthFormat = 0;       // GL_DEPTH24_STENCIL8 or GL_DEPTH_COMPONENT32F
  };
  std::optional<Attached> attached(const gl::RealGl& real, StateGuard& guard, const Features& features,
                                   const Image& image) const;
  void fillDepths(const Image& image, const frame::Band& band, bool floats);
  void send(const gl::RealGl& real, const Features& features, const Image& image, const frame::Band& band,
            bool floats) const;

  std::vector<uint32_t> depths_;  // as sent, the image's shape; memory is kept
};

}  // namespace gluray::present
