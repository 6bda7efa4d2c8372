// Looks up transfer functions. Part of volume_kernels.cpp (compiled once for
// each instruction set).
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

/// Entries of a transfer function at coordinates 0 .. 1.
HWY_INLINE HWY_ATTR Colors lookUp(const VolumeLookup& table, Floats at) {
  const VolumeD d;
  const VolumeI di;
  const Floats count = hn::Set(d, table.count), last = hn::Sub(count, hn::Set(d, 1.0f));
  const Floats scaled = hn::Mul(at, count);
  const Floats place = hn::Min(
      hn::Max(table.linear ? hn::Sub(scaled, hn::Set(d, 0.5f)) : hn::Floor(scaled), hn::Zero(d)), last);
  const Ints entry = hn::ConvertTo(di, place);
  alignas(64) int32_t index[kRays];
  alignas(64) float shares[kRays];
  hn::Store(entry, di, index);
  hn::Store(hn::Sub(place, hn::ConvertTo(d, entry)), d, shares);
  alignas(64) float values[4 * kRays];
  for (size_t i = 0; i < kRays; ++i) {
    FourFloats pair[2];
    std::memcpy(pair, &table.entries[static_cast<size_t>(index[i])], sizeof pair);
    const FourFloats mixed = pair[0] + (pair[1] - pair[0]) * shares[i];
    std::memcpy(values + 4 * i, &mixed, sizeof mixed);
  }
  Colors colors;
  hn::LoadInterleaved4(d, values, colors.r, colors.g, colors.b, colors.a);
  return colors;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
