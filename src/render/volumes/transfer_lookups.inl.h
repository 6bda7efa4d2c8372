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

/// Entries before coordinates 0 .. 1, and the shares of those behind.
struct EntryPlaces {
  Ints index;
  Floats shares;

  HWY_INLINE HWY_ATTR EntryPlaces(Floats at, float entries, bool linear) {
    const VolumeD d;
    const VolumeI di;
    const Floats count = hn::Set(d, entries), last = hn::Sub(count, hn::Set(d, 1.0f));
    const Floats scaled = hn::Mul(at, count);
    const Floats place =
        hn::Min(hn::Max(linear ? hn::Sub(scaled, hn::Set(d, 0.5f)) : hn::Floor(scaled), hn::Zero(d)), last);
    index = hn::ConvertTo(di, place);
    shares = hn::Sub(place, hn::ConvertTo(d, index));
  }
};

/// From numbers of entries to bytes.
HWY_INLINE HWY_ATTR Ints bytesOf(Ints entries) { return hn::ShiftLeft<4>(entries); }
static_assert(sizeof(glm::vec4) == 1 << 4);

/// The entries that lie `first` bytes behind others, mixed with the next ones. Rays first, first + 4, first +
/// 8 ..., four numbers each.
template <size_t first>
HWY_INLINE HWY_ATTR Floats mixedEntries(const glm::vec4* entries, const RayNumbers& bytes, Floats shares) {
  const auto entryAt = [&](size_t ray) {
    return reinterpret_cast<const float*>(reinterpret_cast<const std::byte*>(entries) + bytes[ray]);
  };
  const Floats here = blocksOf<first>(entryAt);
  const Floats next = blocksOf<first>([&](size_t ray) { return entryAt(ray) + 4; });
  return hn::MulAdd(hn::Sub(next, here), ofBlocks<first>(shares), here);
}

HWY_INLINE HWY_ATTR Colors colorsOf(Floats a, Floats b, Floats c, Floats e) {
  const auto [v] = columnsOf<4>(VolumeD(), a, b, c, e);
  return {v[0], v[1], v[2], v[3]};
}

/// Entries of a transfer function at several coordinates 0 .. 1 of each ray, found as VoxelSamples::at()
/// does.
template <int count>
HWY_INLINE HWY_ATTR void lookUp(const VolumeLookup& table, const Floats* at, Colors* colors) {
  RayNumbers index[count];
  Floats shares[count], mixed[count][4];
  for (int i = 0; i < count; ++i) {
    const EntryPlaces places(at[i], table.count, table.linear);
    index[i].set(bytesOf(places.index)), shares[i] = places.shares;
  }
  const glm::vec4* const entries = table.entries.data();
  for (int i = 0; i < count; ++i) mixed[i][0] = mixedEntries<0>(entries, index[i], shares[i]);
  for (int i = 0; i < count; ++i) mixed[i][1] = mixedEntries<1>(entries, index[i], shares[i]);
  for (int i = 0; i < count; ++i) mixed[i][2] = mixedEntries<2>(entries, index[i], shares[i]);
  for (int i = 0; i < count; ++i) mixed[i][3] = mixedEntries<3>(entries, index[i], shares[i]);
  for (int i = 0; i < count; ++i) colors[i] = colorsOf(mixed[i][0], mixed[i][1], mixed[i][2], mixed[i][3]);
}
HWY_INLINE HWY_ATTR Colors lookUp(const VolumeLookup& table, Floats at) {
  Colors colors;
  lookUp<1>(table, &at, &colors);
  return colors;
}

HWY_ATTR inline Colors lookUp(const VolumeLookup2D& table, Floats x, Floats y) {
  const EntryPlaces columns(x, static_cast<float>(table.size.x), table.linear),
      rows(y, static_cast<float>(table.size.y), table.linear);
  const int width = table.size.x + 1;
  const RayNumbers index(bytesOf(hn::Add(hn::Mul(rows.index, hn::Set(VolumeI(), width)), columns.index)));
  const auto mixed = [&]<size_t first>() HWY_ATTR {
    const Floats a = mixedEntries<first>(table.entries.data(), index, columns.shares),
                 b = mixedEntries<first>(table.entries.data() + width, index, columns.shares);
    return hn::MulAdd(hn::Sub(b, a), ofBlocks<first>(rows.shares), a);
  };
  return colorsOf(mixed.template operator()<0>(), mixed.template operator()<1>(),
                  mixed.template operator()<2>(), mixed.template operator()<3>());
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
