// An image for a multisampled framebuffer that has not been written yet. Programs clear such a framebuffer,
// draw into it and resolve it; a software OpenGL takes longer to write and average the samples than we take
// to trace them. So the image waits: when the program resolves it, only its pixels are written, to their
// destination. Its samples are written only if anything else uses the framebuffer. Owned by ResolveDraws.
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
  /// A framebuffer object that was cleared and not drawn into since; framebuffer 0: none.
  struct Cleared {
    GLuint framebuffer = 0;
    GLenum drawBuffer = GL_NONE;
    Attachment color, depth;
    glm::ivec4 box{0};          // x, y, width, height; its pixels in the framebuffer are cleared to depth 1
    uint32_t background = 0;    // their colour, RGBA8
    float depthResolution = 0;  // of the depth buffer

    bool covers(const glm::ivec4& other) const {
      return other.x >= box.x && other.y >= box.y && other.x + other.z <= box.x + box.z &&
             other.y + other.w <= box.y + box.w;
    }
  };
  /// The one batch that was drawn into it since.
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
