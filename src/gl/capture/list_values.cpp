#include "gl/capture/list_values.h"

#include <cstring>

namespace gluray::gl {
namespace {

void keep(SlotValues& values, Slot slot, const float* value) {
  std::memcpy(values[slot].data(), value, sizeOf(slot) * sizeof(float));
}

bool equal(const SlotValues& values, Slot slot, const float* value) {
  return std::memcmp(values[slot].data(), value, sizeOf(slot) * sizeof(float)) == 0;
}

}  // namespace

ListEffect::ListEffect() {
  for (const bool pending : {false, true})
    for (const bool due : {false, true}) {
      Left& left = left_[index(pending, due)];
      left.keepsOlder = !due;
      left.due = pending && !due;
    }
}

void ListValues::State::draw(const SlotValues& set) {
  if (!left.due && !left.pending) return;
  forEachSlot(left.set & ~bit(kMaterialNumber), [&](Slot slot) { stored[slot] = set[slot]; });
  if (left.due) {
    left.stored |= left.set & ~bit(kMaterialNumber);
    left.set = 0, left.keepsOlder = false;
  }
  left.due = !left.due, left.pending = false;
}

void ListValues::start() {
  for (size_t i = 0; i < states_.size(); ++i) {
    states_[i].left = {};
    states_[i].left.pending = i & 1, states_[i].left.due = i & 2;
  }
  drawing_ = continues_ = false, first_ = true;
  changedFirst_ = 0;
}

void ListValues::set(const VertexStream& stream, Slot slot, const float* value) {
  finish(stream);
  if (slot != kMaterialNumber) keep(set_, slot, value);
  for (State& s : states_) s.left.set |= bit(slot), s.left.pending = true;
}

void ListValues::begin(const VertexStream& stream, bool continues) {
  arraysLast_ = false;
  if (drawing_) return;
  drawing_ = true, continues_ = continues;
  from_ = stream.sent();
  known_ = stream.layout().mask & kVertexAttributes;
  forEachSlot(known_, [&](Slot slot) { keep(before_, slot, stream.get(slot)); });
}

void ListValues::fromArrays(const VertexStream& stream) {
  arraysLast_ = true;
  const SlotMask added = stream.layout().mask & kVertexAttributes & ~known_;
  forEachSlot(added, [&](Slot slot) { keep(before_, slot, stream.get(slot)); });
  known_ |= added;
}

void ListValues::addSlot(const VertexStream& stream) {
  if (!drawing_ || stream.sent() == from_) return;
  finish(stream);
  begin(stream, false);
}

void ListValues::finish(const VertexStream& stream) {
  if (!drawing_) return;
  drawing_ = false;
  if (stream.sent() == from_) return;
  if (!continues_) draw();
  const SlotMask slots = arraysLast_ ? 0 : stream.layout().mask & kVertexAttributes;
  forEachSlot(slots, [&](Slot slot) {
    const float* value = stream.get(slot);
    if ((known_ & bit(slot)) && equal(before_, slot, value)) return;
    if (first_ && (known_ & bit(slot))) changedFirst_ |= bit(slot), beforeFirst_[slot] = before_[slot];
    for (State& s : states_) keep(s.stored, slot, value), s.left.stored |= bit(slot);
  });
  first_ = false;
}

void ListValues::draw() {
  for (size_t i = 0; i < states_.size(); ++i) {
    states_[i].draw(set_);
    if (first_ && i >= kBefore) states_[i].draw(set_);
  }
}

// Values set before the first vertex are in the stream's layout, and so Mesa's draw that they start in the
// middle is seen by the first vertex alone: it has the value from before.
ListEffect ListValues::effect(const CapturedVertices& run) const {
  bool twice = false;
  if (run.vertexCount > 0)
    forEachSlot(changedFirst_ & run.layout.mask, [&](Slot slot) {
      twice = twice || equal(beforeFirst_, slot, run.vertex(0) + run.layout.offset[slot]);
    });
  ListEffect effect;
  for (size_t i = 0; i < kBefore; ++i) {
    const State& state = states_[i + (twice ? kBefore : 0)];
    ListEffect::Left& left = effect.left_[i];
    left = state.left;
    left.stored &= ~left.set;
    forEachSlot((left.set | left.stored) & ~bit(kMaterialNumber), [&](Slot slot) {
      left.values.push_back(left.set & bit(slot) ? set_[slot] : state.stored[slot]);
    });
  }
  return effect;
}

}  // namespace gluray::gl
