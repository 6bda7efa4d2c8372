// The current vertex attributes of a context, as far as they are known here.
#pragma once
#include "gl/capture/attribute_slots.h"
#include "gl/real.h"

#include <cstring>

namespace gluray::gl {

/// What the program sets is kept here, and the real OpenGL told when something of its own may depend on it.
/// Mesa stores what it is told with its next vertices or when it is asked, and until then neither
/// GL_COLOR_MATERIAL nor glPopAttrib finds it there (seen in 22.3; src/mesa/vbo, FLUSH_VERTICES leaves
/// attributes alone that no vertex followed). What draws of ours have used is therefore sent with a question,
/// as it would have been stored at the draw; all else is left to wait as it would without us. GL thread.
class CurrentValues {
 public:
  const SlotValues& all() const { return values_; }
  const float* operator[](Slot slot) const { return values_[slot].data(); }

  /// A value that the real OpenGL has. `value`: as many floats as the slot.
  void keep(Slot slot, const float* value) {
    std::memcpy(values_[slot].data(), value, sizeOf(slot) * sizeof(float));
  }
  /// One that it does not have yet.
  void set(Slot slot, const float* value) {
    keep(slot, value);
    unsent_ |= bit(slot);
  }
  /// A draw that the real OpenGL has not seen used the values of now: it must store them.
  void drawn() { drawn_ = drawn_ || unsent_ != 0 || waiting_; }
  /// Whether it must store some of them.
  bool anyDrawn() const { return drawn_; }
  /// Tells it everything and has it store that, as it does at glCallList. Outside its glBegin and glEnd.
  void store(const RealGl& real) {
    drawn();
    if (drawn_) send(real);
  }
  /// The real OpenGL has come to other values of these.
  void lost(SlotMask slots) { unsent_ |= slots; }
  /// Whether there are values that it does not have, or has not stored.
  bool anyUnsent() const { return unsent_ != 0 || drawn_; }
  /// Tells it those. Between its glBegin and glEnd only where none is of a draw.
  void send(const RealGl& real);
  /// Asks it for all others, or for one.
  void read(const RealGl& real);
  void read(const RealGl& real, Slot slot);

 private:
  SlotValues values_ = initialSlotValues();
  SlotMask unsent_ = 0;
  bool waiting_ = false;  // values that were sent may not be stored
  bool drawn_ = false;    // values of now, sent or not, belong to a draw
};

}  // namespace gluray::gl
