// An image for a multisampled framebuffer that has not been written yet. Programs clear such a framebuffer,
// draw into it and resolve it. A software OpenGL takes longer to write and average the samples than GLuRay
// takes to trace them. So the image waits. When the program resolves it, only the resolved pixels are
// written, to their destination. The samples are written only if anything else uses the framebuffer. Owned by
// ResolveDraws.
#pragma once
#include "gl/batch/held_batch.h"

#include <glm/glm.hpp>

#include <optional>

namespace gluray::gl {

struct UnresolvedImage {
  struct Attachment {
    GLenum type = GL_NONE;  // GL_TEXTURE or GL_RENDERBUFFER
    GLuint name = 0;
    bool operator==(const Attachment&) const = default;
  };
  /// A framebuffer object that was cleared and not drawn into since. framebuffer is 0 if there is none.
  struct Cleared {
    GLuint framebuffer = 0;
    GLenum drawBuffer = GL_NONE;
    Attachment color, depth;
    glm::ivec4 box{0};          // x, y, width, height; the pixels in it were cleared, with depth 1
    uint32_t background = 0;    // the clear colour, RGBA8
    float depthResolution = 0;  // of the depth buffer

    bool covers(const glm::ivec4& other) const {
      return other.x >= box.x && other.y >= box.y && other.x + other.z <= box.x + box.z &&
             other.y + other.w <= box.y + box.w;
    }
  };
  /// The only batch that was drawn into the framebuffer after the clear.
  struct Waiting {
    Cleared cleared;
    HeldBatch batch;
    bool traced = false;  // its image is traced already
  };
  Cleared cleared;
  std::optional<Waiting> waiting;

  bool any() const { return cleared.framebuffer != 0 || waiting.has_value(); }
};

}  // namespace gluray::gl
