// Records when buffers were attached to vertex array objects. A deleted buffer stays alive in vertex array
// objects that are not bound (OpenGL 4.6, 5.1.2 and 5.1.3). By then, the name that the real OpenGL reports
// for it may belong to another buffer. GL threads.
#pragma once
#include "gl/sharing/deleted_buffers.h"

#include <GL/gl.h>

#include <array>
#include <cstdint>
#include <unordered_map>

namespace gluray::gl {

struct ArrayState;

/// Attachment times in the vertex array objects of one context, which are not shared.
class Attachments {
 public:
  /// Attachment points of a vertex array object. Below kElements: bindings of generic attributes.
  enum Place : GLuint {
    kElements = 32,
    kVertex,
    kNormal,
    kColor,
    kSecondaryColor,
    kFogCoord,
    kTexCoord,  // of unit 0, followed by those of seven more units
    kPlaces = kTexCoord + 8
  };

  explicit Attachments(const DeletedBuffers& deleted) : deleted_(deleted) {}

  void bind(GLuint array) { bound_ = array, any_ = any_ || array != 0; }
  /// Whether a vertex array object other than the default one was ever used.
  bool any() const { return any_; }
  /// Reports that a buffer is attached there now.
  void set(GLuint place) { set(bound_, place); }
  void set(GLuint array, GLuint place);
  /// Forgets the times of the bound vertex array object, which may be wrong.
  void forget() { when_.erase(bound_); }
  /// Forgets the times of a vertex array object that was deleted, or whose times may be wrong.
  void forget(GLuint array) { when_.erase(array); }
  /// Like set(), for a target outside vertex array objects: buffers that another context deletes stay bound
  /// there.
  void setTarget(GLenum target);
  /// Whether the buffer bound to `target`, which may be GL_ELEMENT_ARRAY_BUFFER, may be a deleted one that
  /// had `name` before. Bindings by other commands than glBindBuffer (glBindBufferBase ...) count as old.
  bool mayBeDeletedAt(GLenum target, GLuint name) const;
  /// Sets Reason::deletedBuffer if arrays of the bound vertex array object may lie in deleted buffers.
  void check(ArrayState& arrays) const;

 private:
  bool mayBeDeleted(GLuint place, GLuint name) const;

  const DeletedBuffers& deleted_;
  GLuint bound_ = 0;
  bool any_ = false;
  std::unordered_map<GLuint, std::array<uint64_t, kPlaces>> when_;  // 0: before the first deletion
  std::unordered_map<GLenum, uint64_t> targets_;                    // likewise
};

}  // namespace gluray::gl
