#include "gl/capture/current_values.h"

#include "gl/capture/replay.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <utility>

namespace gluray::gl {

void CurrentValues::send(const RealGl& real) {
  const SlotMask slots = std::exchange(unsent_, 0);
  for (int s = kNormal; s < kSlotCount; ++s)
    if (slots & bit(static_cast<Slot>(s)))
      sendAttribute(real, static_cast<Slot>(s), (*this)[static_cast<Slot>(s)]);
  waiting_ = waiting_ || slots != 0;
  if (!std::exchange(drawn_, false)) return;
  float asked[4];
  real.GetFloatv(GL_CURRENT_COLOR, asked);
  waiting_ = false;
}

void CurrentValues::read(const RealGl& real) {
  for (int s = kNormal; s < kSlotCount; ++s)
    if (!(unsent_ & bit(static_cast<Slot>(s)))) read(real, static_cast<Slot>(s));
}

void CurrentValues::read(const RealGl& real, Slot slot) {
  float* value = values_[slot].data();
  switch (slot) {
    case kPosition:
    case kPositionW:
    case kMaterialNumber: return;
    case kNormal: return real.GetFloatv(GL_CURRENT_NORMAL, value);
    case kColor: return real.GetFloatv(GL_CURRENT_COLOR, value);
    case kSecondaryColor: return real.GetFloatv(GL_CURRENT_SECONDARY_COLOR, value);
    case kFogCoord: return real.GetFloatv(GL_CURRENT_FOG_COORD, value);
    case kIndex: return real.GetFloatv(GL_CURRENT_INDEX, value);
    case kEdgeFlag: {
      GLboolean edge = GL_TRUE;
      real.GetBooleanv(GL_EDGE_FLAG, &edge);
      *value = edge ? 1.0f : 0.0f;
      return;
    }
    default: break;
  }
  if (slot >= kGeneric1) {
    if (isPresent(real.GetVertexAttribfv))
      real.GetVertexAttribfv(static_cast<GLuint>(slot - kGeneric1 + 1), GL_CURRENT_VERTEX_ATTRIB, value);
    return;
  }
  GLint units = 1, active = GL_TEXTURE0;
  real.GetIntegerv(GL_MAX_TEXTURE_COORDS, &units);
  if (slot - kTexCoord0 >= std::max(units, 1)) return;
  real.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
  const auto choose = [&](GLenum unit) {
    if (isPresent(real.ActiveTexture) && static_cast<GLenum>(active) != unit) real.ActiveTexture(unit);
  };
  const auto unit = static_cast<GLenum>(GL_TEXTURE0 + (slot - kTexCoord0));
  choose(unit);
  real.GetFloatv(GL_CURRENT_TEXTURE_COORDS, value);
  if (static_cast<GLenum>(active) != unit) real.ActiveTexture(static_cast<GLenum>(active));
}

}  // namespace gluray::gl
