#include "gl/buffers/attachments.h"

#include "gl/handlers.h"
#include "gl/state/state_queries.h"

#include <algorithm>
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
  // deleted: the real OpenGL draws then.
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

uint32_t vertexArrayBound(Context& c, GLuint array) {
  c.shadow.attachments.bind(array);
  return kArrays;
}

uint32_t vertexArraysDeleted(Context& c, GLsizei n, const GLuint* arrays) {
  for (GLsizei i = 0; arrays && i < n; ++i) c.shadow.attachments.forget(arrays[i]);
  GLint bound = 0;  // deleting the bound one has unbound it
  c.real.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
  c.shadow.attachments.bind(static_cast<GLuint>(bound));
  return kArrays;
}

uint32_t arraysPopped(Context& c) {
  c.shadow.attachments.forget();
  return kArrays;
}

namespace {

/// The place of a generic attribute's binding. From kElements on none is recorded: these always count as old.
GLuint placeOf(GLuint binding) { return binding < Attachments::kElements ? binding : Attachments::kPlaces; }

}  // namespace

uint32_t attributeSet(Context& c, GLuint binding) { return bindingsSet(c, binding, 1); }

uint32_t bindingsSet(Context& c, GLuint first, GLsizei count) {
  for (GLuint i = 0; i < Attachments::kElements && i < static_cast<GLuint>(std::max(count, 0)); ++i)
    c.shadow.attachments.set(placeOf(first + i));
  return kArrays;
}

uint32_t bindingsOfArraySet(Context& c, GLuint array, GLuint first, GLsizei count) {
  for (GLuint i = 0; i < Attachments::kElements && i < static_cast<GLuint>(std::max(count, 0)); ++i)
    c.shadow.attachments.set(array, placeOf(first + i));
  return kArrays;
}

uint32_t elementsOfArraySet(Context& c, GLuint array) {
  c.shadow.attachments.set(array, Attachments::kElements);
  return kArrays;
}

uint32_t fixedArraySet(Context& c, GLenum array) {
  switch (array) {
    case GL_VERTEX_ARRAY: c.shadow.attachments.set(Attachments::kVertex); break;
    case GL_NORMAL_ARRAY: c.shadow.attachments.set(Attachments::kNormal); break;
    case GL_COLOR_ARRAY: c.shadow.attachments.set(Attachments::kColor); break;
    case GL_SECONDARY_COLOR_ARRAY: c.shadow.attachments.set(Attachments::kSecondaryColor); break;
    case GL_FOG_COORD_ARRAY: c.shadow.attachments.set(Attachments::kFogCoord); break;
    default: {
      if (c.shadow.group.deletedBuffers.now() == 0) break;
      const GLint unit = integer(c.real, GL_CLIENT_ACTIVE_TEXTURE) - GL_TEXTURE0;
      if (unit >= 0 && unit < 8) c.shadow.attachments.set(Attachments::kTexCoord + static_cast<GLuint>(unit));
    }
  }
  return kArrays;
}

uint32_t interleavedArraysSet(Context& c, GLenum format) {
  if (format < GL_V2F || format > GL_T4F_C4F_N3F_V4F) return kArrays;  // an error
  const bool texcoord = format >= GL_T2F_V3F, normal = format == GL_N3F_V3F || format == GL_C4F_N3F_V3F ||
                                                       format == GL_T2F_N3F_V3F ||
                                                       format >= GL_T2F_C4F_N3F_V3F;
  const bool color = (format >= GL_C4UB_V2F && format <= GL_C3F_V3F) || format == GL_C4F_N3F_V3F ||
                     format == GL_T2F_C4UB_V3F || format == GL_T2F_C3F_V3F || format >= GL_T2F_C4F_N3F_V3F;
  fixedArraySet(c, GL_VERTEX_ARRAY);
  if (texcoord) fixedArraySet(c, GL_TEXTURE_COORD_ARRAY);
  if (normal) fixedArraySet(c, GL_NORMAL_ARRAY);
  if (color) fixedArraySet(c, GL_COLOR_ARRAY);
  return kArrays;
}

}  // namespace gluray::gl
