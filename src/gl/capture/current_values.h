// The current vertex attributes of a context. Part of ShadowState, GL thread.
#pragma once
#include "gl/capture/attribute_slots.h"
#include "gl/real/real.h"

#include <cstring>

namespace gluray::gl {

class ListEffect;

/// Keeps the values that the program sets, and sends them at once. Mesa holds them back: it stores a value,
/// and lets GL_COLOR_MATERIAL see it, when a draw, a query or certain state changes follow (seen in 22.3, in
/// src/mesa/vbo and the macros FLUSH_VERTICES and FLUSH_CURRENT). Programs see when: glColorMaterial and
/// glPopAttrib act on what is stored. This class follows which values Mesa holds back, so that draws of ours
/// in place of the program's have the same effect on them, and queries of ours have none. A flush stores the
/// held-back values; while `due_` is set, the next state change or draw stores them again and lets go of
/// them.
/// While a run of small draws from arrays is open, values are sent when it ends: setLater(), drawnLater(),
/// sendLater().
class CurrentValues {
 public:
  /// What Mesa holds back.
  struct Held {
    SlotMask slots = 0;    // Mesa's vertex template
    bool pending = false;  // some of them are not yet stored (FLUSH_UPDATE_CURRENT)
    bool due = false;      // the next state change or draw stores them and lets go (FLUSH_STORED_VERTICES)
    bool color = false;    // the current colour is one of those that are not yet stored
  };
  const SlotValues& all() const { return values_; }
  const float* operator[](Slot slot) const { return values_[slot].data(); }

  /// Records a value that the real OpenGL already has. `value`: sizeOf(slot) floats.
  void keep(Slot slot, const float* value) {
    std::memcpy(values_[slot].data(), value, sizeOf(slot) * sizeof(float));
  }
  /// The same. Returns whether it is another value.
  bool keepChanged(Slot slot, const float* value) {
    if (std::memcmp(values_[slot].data(), value, sizeOf(slot) * sizeof(float)) == 0) return false;
    keep(slot, value);
    return true;
  }
  /// Takes a value, and sends it.
  void set(const RealGl& real, Slot slot, const float* value);
  /// Takes a value that the program has set between glBegin and glEnd of the real OpenGL.
  void setInside(Slot slot, const float* value) {
    if (holdsBack_) {
      if (slot == kColor && !held_.color) storedColor_ = values_[kColor], held_.color = true;
      held_.slots |= bit(slot), held_.pending = true;
    }
    keep(slot, value);
  }
  /// glEnd of such a primitive. `any`: it has vertices.
  void ended(bool any) { held_.due = held_.due || (any && holdsBack_); }
  /// Reads values that glArrayElement has set in such a primitive. Call after ended().
  void readInside(const RealGl& real, SlotMask slots);

  // The same as set() and drawn(), but without calls of the real OpenGL. Before any other command reaches it,
  // sendLater() makes up for them.
  void setLater(Slot slot, const float* value);
  void drawnLater(const RealGl& real);
  void sendLater(const RealGl& real);

  /// Says that the real OpenGL is not Mesa: it stores values when they are set.
  void holdNothingBack() { holdsBack_ = false; }
  bool holdsBack() const { return holdsBack_; }

  // What Mesa does to held-back values.
  /// The program changes state.
  void stateChanges() {
    if (held_.due) letGo();
  }
  /// The same for a change that the real OpenGL does not get.
  void changeState(const RealGl& real);
  /// The program makes a call that stores held-back values: a query of them, glCallList, glNewList,
  /// glPushAttrib, glColorMaterial.
  void stored() {
    if (held_.pending) held_.due = true, held_.pending = held_.color = false;
  }
  /// The same for a call that the real OpenGL does not get.
  void store(const RealGl& real);
  /// The real OpenGL makes a draw from arrays.
  void drawnByReal() { held_.due ? letGo() : stored(); }
  /// A draw that it does not get uses the current values.
  void drawn(const RealGl& real);
  /// The program's glBegin stores all values; `real` if the real OpenGL does not get it.
  void begun(const RealGl* real);
  /// Forgets what is held back.
  void letGo() { held_ = {}; }
  /// Call before draws of ours, which store all values: Mesa gets the colour that it has stored, so that
  /// GL_COLOR_MATERIAL does not see the one that it holds back. Call restore() afterwards.
  void shelve(const RealGl& real) const;
  /// After queries or draws of ours, which stored all values: they are held back again as before.
  void restore(const RealGl& real) const;
  /// Whether Mesa may hold back values.
  bool holdsAny() const { return held_.pending || held_.due; }
  const Held& held() const { return held_; }
  /// Whether Mesa may hold back materials.
  bool holdsMaterials() const { return held_.slots & bit(kMaterialNumber); }
  /// After commands that Mesa does not get as the program makes them: the same is held back as before.
  void holdAgain(const Held& held) { held_ = held; }
  /// Stores values without holding them back.
  void storeAside(const RealGl& real, SlotMask slots);
  /// A list has drawn vertices, since these values were held back. `drawn`: slots to which the real OpenGL
  /// has given other values. Returns whether the current colour has changed.
  bool applyList(const RealGl& real, const ListEffect& effect, SlotMask drawn);
  /// The real OpenGL lacks values that a traced run of glBegin and glEnd has set to others: sends them, as if
  /// its vertices had.
  void sendRun(const RealGl& real, SlotMask slots);

  /// Reads back all values except those that are held back and not yet stored, or one slot.
  void read(const RealGl& real);
  /// Reads back one slot.
  void read(const RealGl& real, Slot slot);

 private:
  static void send(const RealGl& real, SlotMask slots, const SlotValues& values);
  enum class Colors : uint8_t { stored, newest };
  void hold(const RealGl& real, Colors colors = Colors::newest) const;

  SlotValues values_ = initialSlotValues();
  bool holdsBack_ = true;  // the real OpenGL is Mesa
  Held held_;
  SlotValues::value_type storedColor_{};  // with Held::color: the colour that Mesa has stored
  // Since the last sendLater(): slots that have been set, and those that a draw has stored, with their
  // values.
  SlotMask setLater_ = 0, storedLater_ = 0;
  SlotValues valuesLater_{};
  int drawsLater_ = 0;  // that have stored values
};

}  // namespace gluray::gl
