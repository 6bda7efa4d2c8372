#include "gl/arrays/attachments.h"

#include "gl/arrays/arrays.h"

#include <new>

namespace gluray::gl {

void Attachments::set(GLuint array, GLuint place) {
  any_ = any_ || array != 0;
  if (deleted_.now() == 0 || place >= kPlaces) return;
  try {
    when_[array][place] = deleted_.now() + 1;
  } catch (const std::bad_alloc&) {}  // then the attachment counts as old
}

void Attachments::setTarget(GLenum target) {
  if (deleted_.now() == 0) return;
  try {
    targets_[target] = deleted_.now() + 1;
  } catch (const std::bad_alloc&) {}  // then the attachment counts as old
}

bool Attachments::mayBeDeleted(GLuint place, GLuint name) const {
  const uint64_t deleted = name == 0 ? 0 : deleted_.when(name);
  if (deleted == 0) return false;
  const auto it = when_.find(bound_);
  return it == when_.end() || place >= kPlaces || it->second[place] <= deleted;
}

bool Attachments::mayBeDeletedAt(GLenum target, GLuint name) const {
  if (deleted_.now() == 0 || name == 0) return false;
  if (target == GL_ELEMENT_ARRAY_BUFFER) return mayBeDeleted(kElements, name);
  const uint64_t deleted = deleted_.when(name);
  if (deleted == 0) return false;
  const auto it = targets_.find(target);
  return it == targets_.end() || it->second <= deleted;
}

void Attachments::check(ArrayState& arrays) const {
  if (deleted_.now() == 0) return;
  const auto name = [](const std::shared_ptr<Buffer>& buffer) { return buffer ? buffer->name() : 0; };
  // Places that are not recorded, such as high bindings and units, always count as old once their name was
  // deleted: then the real OpenGL draws.
  bool any = mayBeDeleted(kElements, name(arrays.elements));
  const auto look = [&](const ArraySource& source, GLuint place) {
    if (!source.enabled) return;
    any = any || mayBeDeleted(source.location >= 0 ? source.binding : place, name(source.buffer));
  };
  look(arrays.vertex, kVertex), look(arrays.normal, kNormal), look(arrays.color, kColor);
  look(arrays.secondaryColor, kSecondaryColor), look(arrays.fogCoord, kFogCoord);
  look(arrays.texcoord, kTexCoord);
  for (GLuint i = 0; i < arrays.texcoordsAbove.size(); ++i) look(arrays.texcoordsAbove[i], kTexCoord + 1 + i);
  look(arrays.radius, kPlaces), look(arrays.axis, kPlaces);
  for (const ArraySource& source : arrays.generic) look(source, kPlaces);
  if (any) arrays.reason = Reason::deletedBuffer;
}

}  // namespace gluray::gl
