// The current vertex attributes of a context, as far as they are known here.
#pragma once
#include "gl/real.h"
#include "gl/slots.h"

#include <cstring>

namespace gluray::gl {

/// What the program sets is kept here, and the real OpenGL told when something of its own may depend on it.
/// GL thread.
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
  /// The real OpenGL has come to other values of these.
  void lost(SlotMask slots) { unsent_ |= slots; }
  /// Whether there are values that it does not have.
  bool anyUnsent() const { return unsent_ != 0; }
  /// Tells it those.
  void send(const RealGl& real);
  /// Asks it for all others, or for one.
  void read(const RealGl& real);
  void read(const RealGl& real, Slot slot);

 private:
  SlotValues values_ = initialSlotValues();
  SlotMask unsent_ = 0;
};

}  // namespace gluray::gl
