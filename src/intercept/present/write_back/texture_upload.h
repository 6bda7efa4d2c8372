// Uploads a traced image into the textures of a framebuffer object that has only been cleared, instead of
// drawing it. GL thread, context current, outside glBegin/glEnd.
#pragma once
#include "base/image.h"
#include "frame/pixels/hit_bands.h"
#include "gl/batch/presenter.h"
#include "intercept/present/state/features.h"
#include "intercept/present/state/state_guard.h"

#include <optional>
#include <vector>

namespace gluray::present {

/// Whether uploads into the 2D texture bound to the active unit make its mipmaps, as draws into it do not.
bool makesMipmaps(const gl::RealGl& real, const Features& features);

class TextureUpload {
 public:
  /// Uploads the image, whose misses have the cleared colour, into the bound draw framebuffer's textures. The
  /// result equals WriteBack::write() with GL_LEQUAL over a depth of 1. False if the textures are of other
  /// kinds or an upload fails; parts uploaded by then may be drawn over. Moves pending errors to `pending`.
  /// Uses `threads` threads (0: all). Restores all queryable state.
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

  std::vector<uint32_t> depths_;  // as uploaded, in the image's shape; reused memory
};

}  // namespace gluray::present
