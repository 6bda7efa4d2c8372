#include "gl/capture/current_values.h"

#include "gl/capture/replay.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <utility>

namespace gluray::gl {

namespace {

/// In Mesa FLUSH_VERTICES and FLUSH_CURRENT, which together do what FLUSH_FOR_DRAW does.
void askMaterial(const RealGl& real) {
  GLfloat shininess = 0;
  real.GetMaterialfv(GL_FRONT, GL_SHININESS, &shininess);
}

void askColor(const RealGl& real) {
  GLfloat color[4];
  real.GetFloatv(GL_CURRENT_COLOR, color);
}

}  // namespace

void CurrentValues::set(const RealGl& real, Slot slot, const float* value) {
  keep(slot, value);
  sendAttribute(real, slot, value);
  held_ |= bit(slot), pending_ = true;
}

void CurrentValues::changeState(const RealGl& real) {
  if (!due_) return;
  askMaterial(real);
  letGo();
}

void CurrentValues::store(const RealGl& real) {
  if (!pending_) return;
  askColor(real);
  stored();
}

void CurrentValues::drawn(const RealGl& real) {
  if (!pending_ && !due_) return;
  askMaterial(real);
  drawnByReal();
}

void CurrentValues::begun(const RealGl* real) {
  if (real && (pending_ || due_)) askMaterial(*real), askMaterial(*real);
  letGo();
}

// Materials alone are held back by the same flags: a value that changes nothing sets them.
void CurrentValues::hold(const RealGl& real) const {
  if (held_ == bit(kMaterialNumber)) return sendAttribute(real, kNormal, values_[kNormal].data());
  forEachSlot(held_, [&](Slot slot) { sendAttribute(real, slot, values_[slot].data()); });
}

void CurrentValues::restore(const RealGl& real) const {
  if (!held_) return;
  hold(real);
  if (!due_) return;
  askMaterial(real);
  if (pending_) hold(real);
}

void CurrentValues::storeAside(const RealGl& real, SlotMask slots) {
  if (!slots) return;
  forEachSlot(slots, [&](Slot slot) { sendAttribute(real, slot, values_[slot].data()); });
  askMaterial(real), askMaterial(real);
  restore(real);
}

void CurrentValues::sendRun(const RealGl& real, SlotMask slots) {
  if (!slots) return;
  forEachSlot(slots, [&](Slot slot) { sendAttribute(real, slot, values_[slot].data()); });
  askMaterial(real);
  held_ |= slots, pending_ = false, due_ = true;
}

void CurrentValues::read(const RealGl& real) {
  const SlotMask unread = pending_ ? held_ : 0;
  for (int s = kNormal; s < kSlotCount; ++s)
    if (!(unread & bit(static_cast<Slot>(s)))) read(real, static_cast<Slot>(s));
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
