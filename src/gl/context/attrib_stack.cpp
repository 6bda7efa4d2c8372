#include "gl/context/attrib_stack.h"

#include "gl/context/list_compiler.h"
#include "gl/framebuffers/cleared_framebuffers.h"
#include "gl/real/state_queries.h"

#include <GL/gl.h>
#include <GL/glext.h>

namespace gluray::gl {
namespace {

/// State groups that the attribute groups of `mask` (glPushAttrib) belong to.
uint32_t groupsOfAttrib(GLbitfield mask) {
  if (mask == GL_ALL_ATTRIB_BITS) return kAttribGroups;
  uint32_t groups = 0;
  if (mask & GL_CURRENT_BIT) groups |= kCurrent | kMaterial;
  if (mask & GL_LIGHTING_BIT) groups |= kLighting | kMaterial;
  if (mask & GL_ENABLE_BIT)  // sRGB encoding, too
    groups |= kViewport | kRaster | kLighting | kMaterial | kTexture | kClip | kTarget;
  if (mask & GL_TRANSFORM_BIT) groups |= kLighting | kClip | kRaster;  // depth clamp
  if (mask & GL_VIEWPORT_BIT) groups |= kViewport;
  if (mask & GL_SCISSOR_BIT) groups |= kViewport;
  if (mask & GL_TEXTURE_BIT) groups |= kTexture;
  if (mask & GL_FOG_BIT) groups |= kRaster | kLighting;  // colour sum
  if (mask & GL_COLOR_BUFFER_BIT) groups |= kRaster | kTarget;
  if (mask & (GL_POLYGON_BIT | GL_POLYGON_STIPPLE_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT |
              GL_MULTISAMPLE_BIT))
    groups |= kRaster;
  return groups;
}

}  // namespace

void AttribStack::push(GLbitfield mask) {
  p_.shadow.real.PushAttrib(mask);
  if (mask & (GL_CURRENT_BIT | GL_LIGHTING_BIT)) p_.shadow.current.stored();
  if (deepest_ == 0) p_.shadow.real.GetIntegerv(GL_MAX_ATTRIB_STACK_DEPTH, &deepest_);
  if (saved_.size() >= static_cast<size_t>(deepest_)) return;  // the real OpenGL refused, too
  saved_.push_back({mask, p_.lists.base});
}

void AttribStack::pop() {
  bool redirects = false;
  if (!saved_.empty()) {
    const Saved saved = saved_.back();
    saved_.pop_back();
    if (saved.mask & GL_LIST_BIT) p_.lists.base = saved.listBase;
    if (saved.mask & GL_TRANSFORM_BIT) p_.shadow.matrixMode = 0;
    // A change of the draw buffer would redirect the pending batch.
    redirects = saved.mask & GL_COLOR_BUFFER_BIT;
    if (redirects) p_.flusher.flush();
    p_.shadow.current.stateChanges();
    p_.shadow.touch(groupsOfAttrib(saved.mask));
    if (saved.mask & GL_CURRENT_BIT) p_.shadow.current.stored();
  }
  const GLint before = redirects ? integer(p_.shadow.real, GL_DRAW_BUFFER) : 0;
  p_.shadow.real.PopAttrib();
  if (redirects && integer(p_.shadow.real, GL_DRAW_BUFFER) != before) p_.cleared.forgetClear();
}

}  // namespace gluray::gl
