// OpenGL's per-vertex attributes as numbered slots of captured vertices.
#pragma once
#include <array>
#include <bit>
#include <cstdint>

namespace gluray::gl {

enum Slot : uint8_t {
  kPosition,   // x, y, z
  kPositionW,  // only if some vertex has w != 1
  kNormal,
  kColor,
  kSecondaryColor,
  kFogCoord,
  kEdgeFlag,
  kIndex,
  kMaterialNumber,             // number of an entry of CapturedVertices::materials, as a float
  kTexCoord0,                  // units 0 .. 7
  kGeneric1 = kTexCoord0 + 8,  // glVertexAttrib 1 .. 15; 0 is the position
  kSlotCount = kGeneric1 + 15
};
static_assert(kSlotCount == 32);

using SlotMask = uint32_t;
constexpr SlotMask bit(Slot slot) { return SlotMask{1} << slot; }

/// Calls body(Slot) for each slot of the mask, in order.
template <class F>
void forEachSlot(SlotMask slots, F&& body) {
  for (; slots; slots &= slots - 1) body(static_cast<Slot>(std::countr_zero(slots)));
}

/// Floats a slot occupies in a captured vertex.
constexpr uint32_t sizeOf(Slot slot) {
  switch (slot) {
    case kPosition:
    case kNormal:
    case kSecondaryColor: return 3;
    case kPositionW:
    case kFogCoord:
    case kEdgeFlag:
    case kIndex:
    case kMaterialNumber: return 1;
    default: return 4;
  }
}

/// Texture coordinates of all units.
inline constexpr SlotMask kTexCoordSlots = SlotMask{0xFF} << kTexCoord0;
constexpr Slot texCoordSlot(uint32_t unit) { return static_cast<Slot>(kTexCoord0 + unit); }

/// All slots but those of positions and materials.
inline constexpr SlotMask kVertexAttributes = ~(bit(kPosition) | bit(kPositionW) | bit(kMaterialNumber));

/// Slots that a traced image can depend on; the others only affect rasterised draws.
inline constexpr SlotMask kTracedSlots = bit(kPosition) | bit(kPositionW) | bit(kNormal) | bit(kColor) |
                                         bit(kSecondaryColor) | bit(kFogCoord) | bit(kMaterialNumber) |
                                         kTexCoordSlots;

/// Values of all slots, padded to four floats.
using SlotValues = std::array<std::array<float, 4>, kSlotCount>;

/// OpenGL's initial values (GL 2.1, table 6.6).
constexpr SlotValues initialSlotValues() {
  SlotValues v{};
  for (auto& value : v) value = {0, 0, 0, 1};
  v[kPositionW] = {1, 0, 0, 0};
  v[kNormal] = {0, 0, 1, 0};
  v[kColor] = {1, 1, 1, 1};
  v[kFogCoord] = {0, 0, 0, 0};
  v[kEdgeFlag] = {1, 0, 0, 0};
  v[kIndex] = {1, 0, 0, 0};
  v[kMaterialNumber] = {0, 0, 0, 0};
  return v;
}

}  // namespace gluray::gl
