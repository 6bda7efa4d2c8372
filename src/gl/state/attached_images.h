// Records when images were attached to framebuffer objects. A deleted texture or renderbuffer lives on in
// those that are not bound (OpenGL 4.6, 5.1.2, 5.1.3 and 9.2.8), and the name that the real OpenGL reports
// for it may belong to another one by then. GL thread.
#pragma once
#include "gl/real.h"
#include "gl/state/deleted_names.h"

#include <cstdint>
#include <map>
#include <utility>

namespace gluray::gl {

/// Attachment times in the framebuffer objects of one context, which are not shared.
class AttachedImages {
 public:
  AttachedImages(const DeletedNames& textures, const DeletedNames& renderbuffers)
      : textures_(textures), renderbuffers_(renderbuffers) {}

  /// An image of `type`, GL_TEXTURE or GL_RENDERBUFFER, is attached there now.
  void set(GLuint framebuffer, GLenum attachment, GLenum type);
  /// set() for the framebuffer object bound to `target`.
  void setBound(const RealGl& real, GLenum target, GLenum attachment, GLenum type);
  /// Whether the image at `attachment` of the framebuffer bound to `target`, GL_DRAW_FRAMEBUFFER or
  /// GL_READ_FRAMEBUFFER, may be a deleted one that had the name of another image before. Attachments made in
  /// other contexts count as old.
  bool mayBeDeleted(const RealGl& real, GLenum target, GLenum attachment) const;

 private:
  struct Attached {
    GLenum type = GL_NONE;
    uint64_t when = 0;  // in deletions of this type
  };
  const DeletedNames& of(GLenum type) const { return type == GL_TEXTURE ? textures_ : renderbuffers_; }
  void setOne(GLuint framebuffer, GLenum attachment, GLenum type);

  const DeletedNames &textures_, &renderbuffers_;
  std::map<std::pair<GLuint, GLenum>, Attached> attached_;  // those since the first deletion
};

}  // namespace gluray::gl
