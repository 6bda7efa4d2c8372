// Tracks traced images that are already anti-aliased, so that a program's anti-aliasing pass over them can
// be skipped. Owned by ClearedFramebuffers, GL thread.
#pragma once
#include "gl/real/extensions.h"
#include "gl/real/real.h"
#include "gl/textures/texture_cache.h"
#include "scene/snapshot.h"

#include <GL/gl.h>

namespace gluray::gl {

/// A framebuffer object, a region of it that contains only a clear and images whose pixels are averages
/// (setting spp), and the texture that a part of the region was copied into since.
class AntialiasedImage {
 public:
  AntialiasedImage() = default;
  /// Nothing has been copied yet.
  AntialiasedImage(GLuint framebuffer, GLenum buffer, const scene::Region& region)
      : framebuffer_(framebuffer), buffer_(buffer), region_(region) {}
  bool any() const { return framebuffer_ != 0; }
  bool copied() const { return texture_ != 0; }
  /// Reports that the draw framebuffer's colours are cleared.
  void clear(const RealGl& real, const RareState& has);
  /// Reports that an image of averages was written into this draw buffer of the framebuffer.
  void wrote(GLuint framebuffer, GLenum buffer);
  /// Reports that the texture bound to `target`, which may be attached to the framebuffer, was written.
  void send(const RealGl& real, const TextureCache& textures, GLenum target);
  /// Call after send() if the pixels were copied from region `from` of the read framebuffer.
  void copy(const RealGl& real, GLenum target, GLint level, glm::ivec2 offset, const scene::Region& from);
  /// Whether `texture` is a copy of that region of the framebuffer, and the region is anti-aliased.
  bool isCopy(GLuint texture, const scene::Region& region, GLuint framebuffer, GLenum buffer) const;

 private:
  bool isOf(GLuint framebuffer, GLenum buffer) const {
    return any() && framebuffer_ == framebuffer && buffer_ == buffer;
  }

  GLuint framebuffer_ = 0, texture_ = 0;  // 0: none
  GLenum buffer_ = GL_NONE;               // draw buffer of the framebuffer
  scene::Region region_, copied_;         // anti-aliased region; the part copied into texture_
};

}  // namespace gluray::gl
