// Loads neighbouring numbers from a place of each ray. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_RAY_BLOCKS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_RAY_BLOCKS_INL_H_
#undef GLURAY_RENDER_RAY_BLOCKS_INL_H_
#else
#define GLURAY_RENDER_RAY_BLOCKS_INL_H_
#endif

#include <hwy/highway.h>

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using VolumeD = hn::CappedTag<float, 16>;
using VolumeI = hn::RebindToSigned<VolumeD>;
using Floats = hn::Vec<VolumeD>;
using Ints = hn::Vec<VolumeI>;
using Alive = hn::Mask<VolumeD>;
constexpr size_t kRays = HWY_LANES(float) < 16 ? HWY_LANES(float) : 16;

/// Numbers of rays, one each, in memory: from there they are used one by one.
struct RayNumbers {
  alignas(64) int32_t at[kRays];
  RayNumbers() = default;
  HWY_INLINE HWY_ATTR explicit RayNumbers(Ints numbers) { set(numbers); }
  HWY_INLINE HWY_ATTR void set(Ints numbers) { hn::Store(numbers, VolumeI(), at); }
  HWY_INLINE size_t operator[](size_t ray) const { return static_cast<uint32_t>(at[ray]); }
};

/// What integers in memory are loaded as, and floats.
template <class Stored>
using LoadedD = std::conditional_t<std::is_integral_v<Stored>, VolumeI, VolumeD>;

/// Four numbers of each ray: `column[i]` has number i.
template <class D>
struct Columns {
  hn::Vec<D> column[4];
};

#if HWY_TARGET == HWY_SCALAR

/// Number `first` of those that begin at from(ray).
template <size_t first, class From>
HWY_INLINE HWY_ATTR auto blocksOf(const From& from) {
  const auto* const stored = from(0);
  const LoadedD<std::remove_cvref_t<decltype(*stored)>> d;
  return hn::Set(d, static_cast<hn::TFromD<decltype(d)>>(stored[first]));
}
template <size_t first>
HWY_INLINE HWY_ATTR Floats ofBlocks(Floats numbers) {
  return numbers;
}
template <int count, class D>
HWY_INLINE HWY_ATTR Columns<D> columnsOf(D /*d*/, hn::Vec<D> a, hn::Vec<D> b, hn::Vec<D> c, hn::Vec<D> e) {
  return {{a, b, c, e}};
}

#else

template <class Stored>
HWY_INLINE HWY_ATTR auto fourAt(const Stored* from) {
  if constexpr (std::is_integral_v<Stored>)
    return hn::PromoteTo(hn::CappedTag<int32_t, 4>(), hn::LoadU(hn::CappedTag<Stored, 4>(), from));
  else
    return hn::LoadU(hn::CappedTag<float, 4>(), from);
}

/// Blocks of four numbers that begin at from(ray), of the rays first, first + 4, first + 8 ...
template <size_t first, class From>
HWY_INLINE HWY_ATTR auto blocksOf(const From& from) {
  using Stored = std::remove_cvref_t<decltype(*from(0))>;
  const LoadedD<Stored> d;
  if constexpr (kRays == 16) {
    const hn::Half<decltype(d)> half;
    return hn::Combine(d, hn::Combine(half, fourAt(from(first + 12)), fourAt(from(first + 8))),
                       hn::Combine(half, fourAt(from(first + 4)), fourAt(from(first))));
  } else if constexpr (kRays == 8) {
    return hn::Combine(d, fourAt(from(first + 4)), fourAt(from(first)));
  } else {
    return fourAt(from(first));
  }
}

/// The numbers of these rays, each as often as a block has numbers.
template <size_t first>
HWY_INLINE HWY_ATTR Floats ofBlocks(Floats numbers) {
  return hn::Broadcast<static_cast<int>(first)>(numbers);
}

/// Makes columns of blocksOf() from rays 0, 1, 2 and 3. `count`: of columns that are made.
template <int count, class D>
HWY_INLINE HWY_ATTR Columns<D> columnsOf(D d, hn::Vec<D> a, hn::Vec<D> b, hn::Vec<D> c, hn::Vec<D> e) {
  const auto ac = hn::InterleaveLower(d, a, c), be = hn::InterleaveLower(d, b, e);
  Columns<D> made;
  made.column[0] = hn::InterleaveLower(d, ac, be), made.column[1] = hn::InterleaveUpper(d, ac, be);
  if constexpr (count == 4) {
    const auto acBehind = hn::InterleaveUpper(d, a, c), beBehind = hn::InterleaveUpper(d, b, e);
    made.column[2] = hn::InterleaveLower(d, acBehind, beBehind);
    made.column[3] = hn::InterleaveUpper(d, acBehind, beBehind);
  }
  return made;
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
