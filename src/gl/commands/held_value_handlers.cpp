// Commands that make the real OpenGL store the current values that it holds back (CurrentValues), or not:
// this depends on their arguments and on the state before them.
#include "gl/context/context.h"
#include "gl/context/handlers.h"
#include "gl/real/state_queries.h"

#include <GL/gl.h>
#include <GL/glext.h>

namespace gluray::gl {

void noteCurrentValueQuery(Context& c, GLenum pname) {
  switch (pname) {
    case GL_CURRENT_COLOR:
    case GL_CURRENT_INDEX:
    case GL_CURRENT_NORMAL:
    case GL_CURRENT_TEXTURE_COORDS:
    case GL_CURRENT_SECONDARY_COLOR:
    case GL_CURRENT_FOG_COORD:
    case GL_EDGE_FLAG: c.shadow.current.stored();
    default: break;
  }
}

uint32_t materialAsked(Context& c) {
  c.shadow.current.stateChanges(), c.shadow.current.stored();
  return 0;
}

namespace {

/// Groups that glEnable or glDisable touches. Notes what becomes of held-back current values: nothing if the
/// capability has that value already.
uint32_t capabilitySet(Context& c, GLenum capability, bool on) {
  const uint32_t groups = groupsOfCapability(capability);
  if (!c.shadow.current.holdsAny()) return groups;
  if (isOn(c.real, capability) == on) return groups | kHeldNoted;
  c.shadow.current.stateChanges();
  if (capability == GL_COLOR_MATERIAL) c.shadow.current.stored();
  return groups | kHeldNoted;
}

}  // namespace

uint32_t capabilityEnabled(Context& c, GLenum capability) {
  if (capability == GL_STENCIL_TEST) stencilSet(c);
  return capabilitySet(c, capability, true);
}

uint32_t capabilityDisabled(Context& c, GLenum capability) { return capabilitySet(c, capability, false); }

uint32_t colorMaterialSet(Context& c, GLenum face, GLenum mode) {
  constexpr uint32_t kGroups = kLighting | kMaterial;
  if (!c.shadow.current.holdsAny()) return kGroups;
  if (integer(c.real, GL_COLOR_MATERIAL_FACE) == static_cast<GLint>(face) &&
      integer(c.real, GL_COLOR_MATERIAL_PARAMETER) == static_cast<GLint>(mode))
    return kGroups | kHeldNoted;
  c.shadow.current.stateChanges();
  if (isOn(c.real, GL_COLOR_MATERIAL)) c.shadow.current.stored();
  return kGroups | kHeldNoted;
}

}  // namespace gluray::gl
