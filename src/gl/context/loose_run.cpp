#include "gl/context/loose_run.h"

#include "gl/context/context.h"
#include "gl/context/geometry_run.h"

#include <utility>

namespace gluray::gl {
namespace {

/// Whether the slot is a vertex attribute: no part of the position and no material number.
bool isAttribute(Slot slot) { return slot >= kNormal && slot != kMaterialNumber; }

}  // namespace

LooseRun::LooseRun(CapturedVertices run, const Primitive& open, const SlotValues& finals,
                   std::vector<InheritedSlot> inherited)
    : run_(std::move(run)), open_(open), finals_(finals) {
  for (const InheritedSlot& slot : inherited) inheriting_[slot.slot] = slot.vertices;
}

void LooseRun::execute(Context& context) {
  for (const Primitive& primitive : run_.primitives) {
    sendPrimitive(context, primitive);
    context.immediate.end();
  }
  sendPrimitive(context, open_);
  for (int s = 0; s < kSlotCount; ++s) {
    const auto slot = static_cast<Slot>(s);
    if (isAttribute(slot) && run_.layout.has(slot))
      context.immediate.attribute(slot, finals_[static_cast<size_t>(s)].data());
  }
  if (!run_.materials.empty()) applyMaterials(context, run_.materials.back());
}

void LooseRun::sendPrimitive(Context& context, const Primitive& primitive) const {
  context.immediate.begin(primitive.mode);
  for (uint32_t i = primitive.first; i < primitive.first + primitive.count; ++i)
    sendVertex(context, run_.indices.empty() ? i : run_.indices[i]);
}

void LooseRun::sendVertex(Context& context, uint32_t number) const {
  const VertexLayout& layout = run_.layout;
  const float* v = run_.vertex(number);
  if (layout.has(kMaterialNumber))
    if (const auto material = static_cast<uint32_t>(v[layout.offset[kMaterialNumber]]))
      applyMaterials(context, run_.materials[material - 1]);
  for (int s = 0; s < kSlotCount; ++s) {
    const auto slot = static_cast<Slot>(s);
    if (isAttribute(slot) && layout.has(slot) && number >= inheriting_[s])
      context.immediate.attribute(slot, v + layout.offset[s]);
  }
  context.immediate.vertex(v[0], v[1], v[2], layout.has(kPositionW) ? v[layout.offset[kPositionW]] : 1.0f);
}

}  // namespace gluray::gl
