// Pictures that need no anti-aliasing any more. GL thread.
#pragma once
#include "gl/real.h"
#include "gl/state/extensions.h"
#include "gl/textures/texture.h"
#include "scene/snapshot.h"

#include <GL/gl.h>

namespace gluray::gl {

/// A framebuffer object of which a region holds nothing but what it was cleared to and pictures whose pixels
/// are averages (settings: spp); and the texture that a part of it was copied into since then.
class AntialiasedPicture {
 public:
  bool any() const { return framebuffer_ != 0; }
  bool copied() const { return texture_ != 0; }
  /// The draw framebuffer is cleared, colours among it.
  void clear(const RealGl& real, const RareState& has);
  /// A picture of averages was written into that framebuffer and buffer of it.
  void wrote(GLuint framebuffer, GLenum buffer);
  /// Pixels were sent into the texture bound to `target`, which may be attached to the framebuffer.
  void send(const RealGl& real, const TextureCache& textures, GLenum target);
  /// After send(): they are those of `from`, of the framebuffer bound for reading.
  void copy(const RealGl& real, GLenum target, GLint level, glm::ivec2 offset, const scene::Region& from);
  /// Whether `texture` holds what the framebuffer's region holds.
  bool isCopy(GLuint texture, const scene::Region& region, GLuint framebuffer, GLenum buffer) const;

 private:
  bool isOf(GLuint framebuffer, GLenum buffer) const {
    return any() && framebuffer_ == framebuffer && buffer_ == buffer;
  }

  GLuint framebuffer_ = 0, texture_ = 0;  // 0: there is none
  GLenum buffer_ = GL_NONE;               // draw buffer of the framebuffer
  scene::Region region_, copied_;         // pixels
};

}  // namespace gluray::gl
