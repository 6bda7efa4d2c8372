// What a display list holds of a primitive that does not begin and end in it. GL thread; lists of a share
// group may be called from several.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/lists/list.h"

#include <vector>

namespace gluray::gl {

/// A run of glBegin/glEnd pairs whose last glEnd is missing: what follows is whatever comes after it where
/// the list is called. Sent call by call, as the program sent it.
class LooseRun final : public ListOp {
 public:
  /// `open`: the primitive without an end. `finals`: values of all slots of the run after its last vertex.
  LooseRun(CapturedVertices run, const Primitive& open, const SlotValues& finals,
           std::vector<InheritedSlot> inherited);
  void execute(Context& context) override;

 private:
  void sendPrimitive(Context& context, const Primitive& primitive) const;
  void sendVertex(Context& context, uint32_t number) const;

  CapturedVertices run_;
  Primitive open_;
  SlotValues finals_;
  uint32_t inheriting_[kSlotCount] = {};  // so many vertices take the caller's value of the slot
};

}  // namespace gluray::gl
