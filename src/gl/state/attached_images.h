// Records the images that were attached to framebuffer objects. A deleted texture or renderbuffer stays alive
// in framebuffer objects that are not bound (OpenGL 4.6, 5.1.2, 5.1.3 and 9.2.8). By then, the name that the
// real OpenGL reports for it may belong to another image. GL thread.
#pragma once
#include "gl/real/real.h"
#include "gl/sharing/deleted_images.h"

#include <cstdint>
#include <map>
#include <utility>

namespace gluray::gl {

/// The attachments of one context's framebuffer objects, which are not shared.
class AttachedImages {
 public:
  explicit AttachedImages(const DeletedImages& deleted) : deleted_(deleted) {}

  /// Records that an image of `type`, GL_TEXTURE or GL_RENDERBUFFER, is attached there now; name 0: none.
  void set(GLuint framebuffer, GLenum attachment, GLenum type, GLuint name);
  /// Like set(), for the framebuffer object bound to `target`.
  void setBound(const RealGl& real, GLenum target, GLenum attachment, GLenum type, GLuint name);
  /// Forgets a framebuffer object that was deleted.
  void forget(GLuint framebuffer);
  /// Applies deletions by any context of the share group.
  void update();
  /// Whether the image at `attachment` of the framebuffer bound to `target`, GL_DRAW_FRAMEBUFFER or
  /// GL_READ_FRAMEBUFFER, may be a deleted one whose name now belongs to another image. Also true for
  /// attachments that another context has made.
  bool mayBeDeleted(const RealGl& real, GLenum target, GLenum attachment);

 private:
  struct Image {
    GLenum type = GL_NONE;
    GLuint name = 0;
    bool deleted = false;
  };
  void setOne(GLuint framebuffer, GLenum attachment, const Image& image);

  const DeletedImages& deleted_;
  uint64_t seen_ = 0;  // deletions
  std::map<std::pair<GLuint, GLenum>, Image> attached_;
};

}  // namespace gluray::gl
