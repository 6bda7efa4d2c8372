// SIMD test of rays against the capsules of a bundle, compiled once per instruction set.
#include "accel/impostors/capsule_bundles.h"
#include "accel/rays/ray_packet.h"

#include <bit>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/impostors/capsule_bundle_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.

HWY_BEFORE_NAMESPACE();
namespace gluray::accel {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A ray meets all capsules of a bundle at once, or the rays of a packet one capsule.
using BundleTag = hn::CappedTag<float, CapsuleBundle::kMost>;
using PacketTag = hn::CappedTag<float, kLanes>;

template <class D>
struct Vec3Of {
  hn::Vec<D> x, y, z;
  HWY_INLINE static Vec3Of set(float x, float y, float z) {
    return {hn::Set(D(), x), hn::Set(D(), y), hn::Set(D(), z)};
  }
  HWY_INLINE static Vec3Of load(const float* x, const float* y, const float* z) {
    return {hn::LoadU(D(), x), hn::LoadU(D(), y), hn::LoadU(D(), z)};
  }
  HWY_INLINE hn::Vec<D> dot(const Vec3Of& o) const {
    return hn::MulAdd(x, o.x, hn::MulAdd(y, o.y, hn::Mul(z, o.z)));
  }
  HWY_INLINE Vec3Of minus(const Vec3Of& o) const {
    return {hn::Sub(x, o.x), hn::Sub(y, o.y), hn::Sub(z, o.z)};
  }
  /// this + s*o
  HWY_INLINE Vec3Of along(hn::Vec<D> s, const Vec3Of& o) const {
    return {hn::MulAdd(s, o.x, x), hn::MulAdd(s, o.y, y), hn::MulAdd(s, o.z, z)};
  }
  HWY_INLINE hn::Vec<D> size() const { return hn::Add(hn::Abs(x), hn::Add(hn::Abs(y), hn::Abs(z))); }
};

/// One ray in all lanes, or a ray a lane.
template <class D>
struct RaysOf {
  Vec3Of<D> org, dir;
  hn::Vec<D> tNear, tFar, perSquare;  // of the direction

  HWY_INLINE static RaysOf one(const float* rays, unsigned count, unsigned i) {
    const float* r = rays + i;
    const float x = r[4 * count], y = r[5 * count], z = r[6 * count];
    return {Vec3Of<D>::set(r[0], r[count], r[2 * count]), Vec3Of<D>::set(x, y, z), hn::Set(D(), r[3 * count]),
            hn::Set(D(), r[8 * count]), hn::Set(D(), 1 / (x * x + y * y + z * z))};
  }
  HWY_INLINE static RaysOf several(const float* rays, unsigned count, unsigned i) {
    const float* r = rays + i;
    const auto dir = Vec3Of<D>::load(r + 4 * count, r + 5 * count, r + 6 * count);
    return {Vec3Of<D>::load(r, r + count, r + 2 * count), dir, hn::LoadU(D(), r + 3 * count),
            hn::LoadU(D(), r + 8 * count), hn::Div(hn::Set(D(), 1), dir.dot(dir))};
  }
};

/// Capsules with one radius each that hold the solids: several, or one in all lanes.
template <class D>
struct HullsOf {
  Vec3Of<D> middle, half;
  hn::Vec<D> radius, place;  // place: how large coordinates are
  hn::Vec<D> perSquare;      // of `half`

  HWY_INLINE HullsOf(const Vec3Of<D>& aMiddle, const Vec3Of<D>& aHalf, const PlacedImpostors& placed)
      : middle(aMiddle), half(aHalf) {
    const D d;
    const glm::vec4& r = placed.objectRadius;
    const auto per = Vec3Of<D>::set(r.x, r.y, r.z);
    const auto wide = hn::Add(hn::Add(per.dot(middle), hn::Set(d, r.w)), hn::Abs(per.dot(half)));
    // Beside rounding: places on lines are known to about a thousandth of the lines, because reciprocals are
    // approximate, and less well where rays are nearly parallel to them.
    radius = hn::MulAdd(hn::Max(wide, hn::Zero(d)), hn::Set(d, 1.001f),
                        hn::MulAdd(half.size(), hn::Set(d, 5e-3f), hn::Set(d, placed.objectError)));
    place = hn::Add(middle.size(), half.size());
    perSquare = hn::ApproximateReciprocal(hn::Max(half.dot(half), hn::Set(d, 1e-30f)));
  }
  HWY_INLINE static HullsOf several(const CapsuleBundle& b, const PlacedImpostors& placed, int i) {
    return {Vec3Of<D>::load(b.middle[0] + i, b.middle[1] + i, b.middle[2] + i),
            Vec3Of<D>::load(b.half[0] + i, b.half[1] + i, b.half[2] + i), placed};
  }
  HWY_INLINE static HullsOf one(const CapsuleBundle& b, const PlacedImpostors& placed, uint32_t k) {
    return {Vec3Of<D>::set(b.middle[0][k], b.middle[1][k], b.middle[2][k]),
            Vec3Of<D>::set(b.half[0][k], b.half[1][k], b.half[2][k]), placed};
  }
};

/// Bits of the lanes whose ray comes near its hull. Least distance of two line segments: C. Ericson,
/// "Real-Time Collision Detection", 2005, 5.1.9.
template <class D>
HWY_INLINE uint32_t nearBits(const HullsOf<D>& hulls, const RaysOf<D>& ray, float rounding) {
  const D d;
  const auto one = hn::Set(d, 1), minusOne = hn::Set(d, -1);
  const Vec3Of<D> from = ray.org.minus(hulls.middle);
  // From the ray's point that is nearest to the middle.
  const auto nearest = hn::Neg(hn::Mul(from.dot(ray.dir), ray.perSquare));
  const Vec3Of<D> aside = from.along(nearest, ray.dir);
  const auto b = ray.dir.dot(hulls.half), side = aside.dot(hulls.half);
  const auto perRay = hn::Mul(b, ray.perSquare);
  const auto across = hn::Max(hn::NegMulAdd(b, perRay, hulls.half.dot(hulls.half)), hn::Set(d, 1e-30f));
  const auto s = hn::Clamp(hn::Mul(side, hn::ApproximateReciprocal(across)), minusOne, one);
  const auto t = hn::Clamp(hn::Mul(s, perRay), hn::Sub(ray.tNear, nearest), hn::Sub(ray.tFar, nearest));
  const auto at = hn::Clamp(hn::Mul(hn::MulAdd(t, b, side), hulls.perSquare), minusOne, one);
  const Vec3Of<D> apart = aside.along(t, ray.dir).along(hn::Neg(at), hulls.half);
  const auto reach = hn::MulAdd(hn::Set(d, rounding), hn::Add(hulls.place, from.size()), hulls.radius);
  const auto far = hn::Gt(apart.dot(apart), hn::Mul(reach, reach));  // not <=: what is no number is near
  uint8_t bits[8] = {};
  hn::StoreMaskBits(d, far, bits);
  return ~(bits[0] | static_cast<uint32_t>(bits[1]) << 8) & ((1u << hn::Lanes(d)) - 1);
}

void nearLanes(const CapsuleBundle& bundle, const PlacedImpostors& placed, const float* rays, unsigned count,
               uint32_t lanes, uint32_t* near) {
  constexpr int kManyRays = 6;
  const auto width = static_cast<unsigned>(hn::Lanes(PacketTag()));
  for (int k = 0; k < CapsuleBundle::kMost; ++k) near[k] = 0;
  if (std::popcount(lanes) >= kManyRays && count % width == 0) {
    for (unsigned i = 0; i < count; i += width) {
      if (!(lanes >> i & ((1u << width) - 1))) continue;
      const auto several = RaysOf<PacketTag>::several(rays, count, i);
      for (uint32_t k = 0; k < bundle.count; ++k) {
        const auto hull = HullsOf<PacketTag>::one(bundle, placed, k);
        near[k] |= nearBits(hull, several, placed.objectRounding) << i & lanes;
      }
    }
    return;
  }
  for (int first = 0; first < CapsuleBundle::kMost; first += static_cast<int>(hn::Lanes(BundleTag()))) {
    const auto hulls = HullsOf<BundleTag>::several(bundle, placed, first);
    for (uint32_t left = lanes; left; left &= left - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(left));
      uint32_t bits = nearBits(hulls, RaysOf<BundleTag>::one(rays, count, i), placed.objectRounding);
      for (; bits; bits &= bits - 1) near[first + std::countr_zero(bits)] |= 1u << i;
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::accel {

HWY_EXPORT(nearLanes);

void nearCapsules(const CapsuleBundle& bundle, const PlacedImpostors& placed, const float* rays,
                  unsigned count, uint32_t lanes, uint32_t (&near)[CapsuleBundle::kMost]) {
  HWY_DYNAMIC_DISPATCH(nearLanes)(bundle, placed, rays, count, lanes, near);
}

}  // namespace gluray::accel
#endif
