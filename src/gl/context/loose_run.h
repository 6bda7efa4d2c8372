// A display list's run that ends inside an open primitive. GL threads: several may call a list of their share
// group.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/context/list.h"

#include <vector>

namespace gluray::gl {

/// A run of glBegin/glEnd pairs without the last glEnd: the steps that follow continue the primitive when the
/// list is called. Sent call by call, as the program sent it.
class LooseRun final : public ListOp {
 public:
  /// `open`: the primitive without glEnd. `finals`: values of all slots of the run after its last vertex.
  LooseRun(CapturedVertices run, const Primitive& open, const SlotValues& finals,
           std::vector<InheritedSlot> inherited);
  void execute(Context& context) override;

 private:
  void sendPrimitive(Context& context, const Primitive& primitive) const;
  void sendVertex(Context& context, uint32_t number) const;

  CapturedVertices run_;
  Primitive open_;
  SlotValues finals_;
  uint32_t inheriting_[kSlotCount] = {};  // per slot: how many first vertices take the caller's value
};

}  // namespace gluray::gl
