// Handlers of calls that attach buffers to vertex array objects, and images to framebuffer objects.
#include "gl/context/handlers.h"
#include "gl/real/state_queries.h"

#include <algorithm>

namespace gluray::gl {

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
  if (!c.info().core && integer(c.real, GL_CLIENT_ATTRIB_STACK_DEPTH) == 0) return 0;  // an error
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

uint32_t imageAttached(Context& c, GLenum target, GLenum attachment, GLenum type, GLuint name) {
  c.shadow.images.setBound(c.real, target, attachment, type, name);
  return kTarget;
}

uint32_t imageAttachedTo(Context& c, GLuint framebuffer, GLenum attachment, GLenum type, GLuint name) {
  c.shadow.images.set(framebuffer, attachment, type, name);
  return kTarget;
}

uint32_t imagesDeleted(Context& c, GLenum type, GLsizei n, const GLuint* names) {
  for (GLsizei i = 0; names && i < n; ++i)
    if (names[i] != 0) c.shadow.group.deletedImages.add(type, names[i]);
  c.shadow.images.update();
  return kTarget;  // the bound framebuffer object loses them
}

uint32_t framebuffersDeleted(Context& c, GLsizei n, const GLuint* names) {
  for (GLsizei i = 0; names && i < n; ++i) c.shadow.images.forget(names[i]);
  return kTarget;
}

}  // namespace gluray::gl
