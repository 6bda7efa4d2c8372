#include "gl/capture/current_values.h"

#include "gl/capture/list_values.h"
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
  setInside(slot, value);
  sendAttribute(real, slot, value);
}

void CurrentValues::setLater(Slot slot, const float* value) {
  setInside(slot, value);
  setLater_ |= bit(slot);
}

// Materials are never set later.
void CurrentValues::drawnLater(const RealGl& real) {
  if (!holdsAny()) return;
  if (held_.slots & bit(kMaterialNumber)) return sendLater(real), drawn(real);
  ++drawsLater_;
  storedLater_ |= held_.slots;
  forEachSlot(held_.slots, [&](Slot slot) { valuesLater_[slot] = values_[slot]; });
  drawnByReal();
}

void CurrentValues::sendLater(const RealGl& real) {
  const SlotMask set = std::exchange(setLater_, 0), stored = std::exchange(storedLater_, 0);
  const int draws = std::exchange(drawsLater_, 0);
  if (draws == 0) return send(real, set, values_);
  if (draws == 1 && !held_.pending) return send(real, set, values_), askMaterial(real);  // no value after it
  send(real, stored, valuesLater_);
  askMaterial(real), askMaterial(real);
  restore(real);
}

void CurrentValues::readInside(const RealGl& real, SlotMask slots) {
  forEachSlot(slots, [&](Slot slot) { read(real, slot); });
  if (!holdsBack_) return;
  held_ = {held_.slots | slots, true, true};
  restore(real);
}

void CurrentValues::changeState(const RealGl& real) {
  if (!held_.due) return;
  askMaterial(real);
  letGo();
}

void CurrentValues::store(const RealGl& real) {
  if (!held_.pending) return;
  askColor(real);
  stored();
}

void CurrentValues::drawn(const RealGl& real) {
  if (!holdsAny()) return;
  askMaterial(real);
  drawnByReal();
}

void CurrentValues::begun(const RealGl* real) {
  if (real && holdsAny()) askMaterial(*real), askMaterial(*real);
  letGo();
}

void CurrentValues::send(const RealGl& real, SlotMask slots, const SlotValues& values) {
  forEachSlot(slots, [&](Slot slot) { sendAttribute(real, slot, values[slot].data()); });
}

// Materials alone are held back by the same flags: a value that nobody uses sets them.
void CurrentValues::hold(const RealGl& real, Colors colors) const {
  const SlotMask slots = held_.slots & ~bit(kMaterialNumber);
  send(real, slots ? slots : bit(kIndex), values_);
  if (colors == Colors::stored) shelve(real);
}

void CurrentValues::shelve(const RealGl& real) const {
  if (held_.color) sendAttribute(real, kColor, storedColor_.data());
}

void CurrentValues::restore(const RealGl& real) const {
  if (!held_.slots) return;
  if (!held_.due) return hold(real);
  hold(real, Colors::stored);
  askMaterial(real);
  if (held_.pending) hold(real);
}

void CurrentValues::storeAside(const RealGl& real, SlotMask slots) {
  if (!slots) return;
  send(real, slots, values_);
  askMaterial(real), askMaterial(real);
  restore(real);
}

bool CurrentValues::applyList(const RealGl& real, const ListEffect& effect, SlotMask drawn) {
  const Held before = held_;
  const ListEffect::Left& left = effect.after(before.pending, before.due);
  held_ = {left.set | (left.keepsOlder ? before.slots : 0), left.pending, left.due};
  SlotMask changed = 0;
  const auto* value = left.values.data();
  forEachSlot((left.set | left.stored) & ~bit(kMaterialNumber), [&](Slot slot) {
    const bool heldStill = (left.stored & held_.slots) & bit(slot);  // it will be stored again, over this
    if (!heldStill && keepChanged(slot, value->data())) changed |= bit(slot);
    ++value;
  });
  const SlotMask aside = (changed & ~held_.slots) | drawn;
  if (!aside && left.keepsOlder && !(left.set & ~bit(kMaterialNumber))) {
    if (held_.due && !before.due) askMaterial(real);
  } else {
    send(real, aside, values_);
    const bool any = aside || before.pending || drawn;
    if (any || before.due) askMaterial(real);
    if (any && (drawn || !before.due)) askMaterial(real);
    restore(real);
  }
  return changed & bit(kColor);
}

// A value that equals the stored one is not sent: storing it again would change nothing.
void CurrentValues::sendRun(const RealGl& real, SlotMask slots) {
  if (!holdsBack_) return send(real, slots, values_);
  if (!slots && !holdsAny()) return;
  held_.slots |= slots;
  if (held_.due)
    askMaterial(real), hold(real);
  else
    send(real, slots, values_);
  askMaterial(real);
  held_.pending = held_.color = false, held_.due = true;
}

void CurrentValues::read(const RealGl& real) {
  sendLater(real);
  const SlotMask unread = held_.pending ? held_.slots : 0;
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
