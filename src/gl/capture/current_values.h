// The current vertex attributes of a context. Part of ShadowState, GL thread.
#pragma once
#include "gl/capture/attribute_slots.h"
#include "gl/real/real.h"

#include <cstring>

namespace gluray::gl {

/// Keeps the values that the program sets, and sends them when the real OpenGL may depend on them.
/// Mesa stores a value only at the next vertex or query. Until then neither GL_COLOR_MATERIAL nor glPopAttrib
/// sees it (seen in 22.3: in src/mesa/vbo, FLUSH_VERTICES skips attributes that no vertex followed). A draw
/// by the real OpenGL would have made Mesa store its values, so values that a traced draw used are sent with
/// a query after them. Other values stay unstored in Mesa, as they would without GLuRay.
class CurrentValues {
 public:
  const SlotValues& all() const { return values_; }
  const float* operator[](Slot slot) const { return values_[slot].data(); }

  /// Records a value that the real OpenGL already has. `value`: sizeOf(slot) floats.
  void keep(Slot slot, const float* value) {
    std::memcpy(values_[slot].data(), value, sizeOf(slot) * sizeof(float));
  }
  /// Records a value that the real OpenGL does not have yet.
  void set(Slot slot, const float* value) {
    keep(slot, value);
    unsent_ |= bit(slot);
  }
  /// Reports a draw that the real OpenGL did not see and that used the current values: the next send() makes
  /// the real OpenGL store them.
  void drawn() { drawn_ = drawn_ || unsent_ != 0 || waiting_; }
  /// Whether the next send() must make the real OpenGL store values.
  bool anyDrawn() const { return drawn_; }
  /// Sends all values and makes the real OpenGL store them, as glCallList does. Only outside the real
  /// glBegin/glEnd.
  void store(const RealGl& real) {
    drawn();
    if (drawn_) send(real);
  }
  /// Reports that the real OpenGL's values of these slots have changed: ours will be sent again.
  void lost(SlotMask slots) { unsent_ |= slots; }
  /// Whether the real OpenGL lacks values, or must still store some.
  bool anyUnsent() const { return unsent_ != 0 || drawn_; }
  /// Sends these values. Between the real glBegin and glEnd only if !anyDrawn().
  void send(const RealGl& real);
  /// Reads back all values except unsent ones.
  void read(const RealGl& real);
  /// Reads back one slot.
  void read(const RealGl& real, Slot slot);

 private:
  SlotValues values_ = initialSlotValues();
  SlotMask unsent_ = 0;
  bool waiting_ = false;  // values were sent that the real OpenGL may not have stored yet
  bool drawn_ = false;    // a draw that the real OpenGL did not see used the current values, sent or not
};

}  // namespace gluray::gl
