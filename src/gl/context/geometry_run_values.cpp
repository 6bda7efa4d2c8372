// The current values and materials that lists' runs leave, as Mesa's lists leave them.
#include "gl/context/context.h"
#include "gl/context/geometry_run.h"

#include <GL/gl.h>

#include <cstring>
#include <vector>

namespace gluray::gl {

void applyMaterials(Context& context, const MaterialChange& change) {
  const auto each = [&](GLenum face, const scene::Material& m, uint16_t set) {
    if (set & MaterialChange::ambient) context.immediate.material(face, GL_AMBIENT, &m.ambient.x);
    if (set & MaterialChange::diffuse) context.immediate.material(face, GL_DIFFUSE, &m.diffuse.x);
    if (set & MaterialChange::specular) context.immediate.material(face, GL_SPECULAR, &m.specular.x);
    if (set & MaterialChange::emission) context.immediate.material(face, GL_EMISSION, &m.emission.x);
    if (set & MaterialChange::shininess) context.immediate.material(face, GL_SHININESS, &m.shininess);
  };
  each(GL_FRONT, change.values.front, change.front);
  each(GL_BACK, change.values.back, change.back);
}

uint32_t GeometryRun::lastVertex() const {
  const auto& indices = captured_.indices;
  return indices.empty() ? captured_.vertexCount - 1 : indices.data()[indices.size() - 1];
}

uint32_t GeometryRun::materialOfLastVertex() const {
  if (!layout_.has(kMaterialNumber) || captured_.vertexCount == 0) return 0;
  return static_cast<uint32_t>(captured_.vertex(lastVertex())[layout_.offset[kMaterialNumber]]);
}

SlotMask GeometryRun::slotsOfLastVertex() const {
  if (captured_.primitives.empty() || captured_.vertexCount == 0) return 0;
  const uint32_t last = lastVertex();
  SlotMask slots = finalSlots_;
  for (const InheritedSlot& inherited : inherited_)
    if (last < inherited.vertices) slots &= ~bit(inherited.slot);
  forEachSlot(slots, [&](Slot slot) {
    const float* value = captured_.vertex(last) + layout_.offset[slot];
    if (std::memcmp(value, finals_[slot].data(), sizeOf(slot) * sizeof(float)) != 0) slots &= ~bit(slot);
  });
  return slots;
}

const MaterialChange* GeometryRun::leadingMaterial() const {
  if (leadingMaterial_ == 0) return nullptr;
  return &captured_.materials[leadingMaterial_ - 1];
}

// The last change up to the first vertex that was made outside glBegin and glEnd.
uint32_t GeometryRun::findLeadingMaterial() const {
  if (!layout_.has(kMaterialNumber) || captured_.vertexCount == 0) return 0;
  auto number = static_cast<uint32_t>(captured_.vertex(0)[layout_.offset[kMaterialNumber]]);
  while (number > 0 && !captured_.materials[number - 1].outside) --number;
  return number;
}

void GeometryRun::leaveMaterials(Context& context, const MaterialChange* again) {
  const std::vector<MaterialChange>& changes = captured_.materials;
  CurrentValues& current = context.shadow.current;
  if (lastMaterial_ > 0 && (lastMaterial_ != leadingMaterial_ || context.lists.executesNow())) {
    const CurrentValues::Held before = current.held();
    applyMaterials(context, changes[lastMaterial_ - 1]);
    // Materials that Mesa still holds back it stores again later, over those of the vertices.
    if (again) applyMaterials(context, *again);
    context.shadow.latch.letGo(context.real), context.shadow.latch.drawn();
    current.holdAgain(before), current.restore(context.real);
  }
  // Those that were set after the last vertex are held back.
  if (changes.size() > lastMaterial_) applyMaterials(context, changes.back());
}

void GeometryRun::drawContinued(Context& context) {
  CurrentValues& current = context.shadow.current;
  const CurrentValues::Held after = current.held();
  current.letGo();
  const bool rasterised = draw(context).has_value();
  current.holdAgain(after);
  if (rasterised) current.storeAside(context.real, layout_.mask & kVertexAttributes);
}

SlotMask GeometryRun::slotsToRestore(const ListEffect::Left& left, bool pending, SlotMask leftByList) const {
  SlotMask slots = layout_.mask & kVertexAttributes;
  if (pending) return slots;  // with them, what the real list has stored is held back again
  const auto* value = left.values.data();
  forEachSlot((left.set | left.stored) & ~bit(kMaterialNumber), [&](Slot slot) {
    const bool leftSo = std::memcmp(value->data(), finals_[slot].data(), sizeOf(slot) * sizeof(float)) == 0;
    if ((leftByList & left.stored & bit(slot)) && leftSo) slots &= ~bit(slot);
    ++value;
  });
  return slots;
}

void GeometryRun::leaveExecuted(Context& context) {
  CurrentValues& current = context.shadow.current;
  current.drawn(context.real), current.begun(&context.real);
  forEachSlot(finalSlots_, [&](Slot slot) { current.keep(slot, finals_[slot].data()); });
  current.sendRun(context.real, finalSlots_ ? finalSlots_ : bit(kIndex));
  if (finalSlots_ & bit(kColor)) context.shadow.colorSet();
}

}  // namespace gluray::gl
