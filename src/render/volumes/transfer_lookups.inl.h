// Looks up transfer functions. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_TRANSFER_LOOKUPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_TRANSFER_LOOKUPS_INL_H_
#undef GLURAY_RENDER_TRANSFER_LOOKUPS_INL_H_
#else
#define GLURAY_RENDER_TRANSFER_LOOKUPS_INL_H_
#endif

#include "render/volumes/voxel_filters.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Colours and opacities.
struct Colors {
  Floats r, g, b, a;
};

HWY_ATTR inline Colors noColors() {
  const VolumeD d;
  return {hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
}

/// A vector extension of GCC and Clang.
using FourFloats = float __attribute__((vector_size(16)));

/// Entries before coordinates 0 .. 1, and the shares of those behind.
struct EntryPlaces {
  alignas(64) int32_t index[kRays];
  alignas(64) float shares[kRays];

  HWY_INLINE HWY_ATTR EntryPlaces(Floats at, float entries, bool linear) {
    const VolumeD d;
    const VolumeI di;
    const Floats count = hn::Set(d, entries), last = hn::Sub(count, hn::Set(d, 1.0f));
    const Floats scaled = hn::Mul(at, count);
    const Floats place =
        hn::Min(hn::Max(linear ? hn::Sub(scaled, hn::Set(d, 0.5f)) : hn::Floor(scaled), hn::Zero(d)), last);
    const Ints entry = hn::ConvertTo(di, place);
    hn::Store(entry, di, index);
    hn::Store(hn::Sub(place, hn::ConvertTo(d, entry)), d, shares);
  }
};

HWY_INLINE HWY_ATTR FourFloats mixedPair(const glm::vec4* first, float share) {
  FourFloats pair[2];
  std::memcpy(pair, first, sizeof pair);
  return pair[0] + (pair[1] - pair[0]) * share;
}

HWY_INLINE HWY_ATTR Colors colorsOf(const float* values) {
  Colors colors;
  hn::LoadInterleaved4(VolumeD(), values, colors.r, colors.g, colors.b, colors.a);
  return colors;
}

/// Entries of a transfer function at coordinates 0 .. 1.
HWY_INLINE HWY_ATTR Colors lookUp(const VolumeLookup& table, Floats at) {
  const EntryPlaces places(at, table.count, table.linear);
  alignas(64) float values[4 * kRays];
  for (size_t i = 0; i < kRays; ++i) {
    const FourFloats mixed =
        mixedPair(&table.entries[static_cast<size_t>(places.index[i])], places.shares[i]);
    std::memcpy(values + 4 * i, &mixed, sizeof mixed);
  }
  return colorsOf(values);
}

HWY_ATTR inline Colors lookUp(const VolumeLookup2D& table, Floats x, Floats y) {
  const EntryPlaces columns(x, static_cast<float>(table.size.x), table.linear),
      rows(y, static_cast<float>(table.size.y), table.linear);
  const auto width = static_cast<size_t>(table.size.x) + 1;
  alignas(64) float values[4 * kRays];
  for (size_t i = 0; i < kRays; ++i) {
    const glm::vec4* const first =
        table.entries.data() + static_cast<size_t>(rows.index[i]) * width + columns.index[i];
    const FourFloats a = mixedPair(first, columns.shares[i]), b = mixedPair(first + width, columns.shares[i]);
    const FourFloats mixed = a + (b - a) * rows.shares[i];
    std::memcpy(values + 4 * i, &mixed, sizeof mixed);
  }
  return colorsOf(values);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
