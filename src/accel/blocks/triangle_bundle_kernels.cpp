// Packets against triangle bundles, compiled once per instruction set.
#include "accel/blocks/triangle_bundle_kernels.h"

#include <bit>
#include <cmath>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/blocks/triangle_bundle_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "accel/blocks/triangle_test.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::accel {
namespace HWY_NAMESPACE {

/// The boxes of a bundle's blocks, by axis.
struct alignas(64) BlockBoxes {
  float lower[3][TriangleBundle::kBlocks], upper[3][TriangleBundle::kBlocks];

  explicit HWY_INLINE BlockBoxes(const TriangleBundle& bundle) {
    const hn::CappedTag<float, TriangleBundle::kBlocks> d;
    const hn::Rebind<int32_t, decltype(d)> di;
    const hn::Rebind<uint8_t, decltype(d)> du;
    for (int axis = 0; axis < 3; ++axis) {
      const auto base = hn::Set(d, bundle.base[axis]), step = hn::Set(d, bundle.step[axis]);
      const auto decode = [&](const uint8_t* from, float* to) {
        hn::StoreU(hn::MulAdd(hn::ConvertTo(d, hn::PromoteTo(di, hn::LoadU(du, from))), step, base), d, to);
      };
      for (size_t b = 0; b < TriangleBundle::kBlocks; b += hn::Lanes(d))
        decode(bundle.lower[axis] + b, lower[axis] + b), decode(bundle.upper[axis] + b, upper[axis] + b);
    }
  }
};

constexpr float kSmallest = 1e-18f;  // of a direction's components: their reciprocals stay finite

/// Reciprocals of directions, and along which axes they are negative (of -0, too).
template <class D>
struct Slopes {
  Vector3<D> inverse;
  hn::Mask<D> backX, backY, backZ;

  HWY_INLINE Slopes(D d, const Vector3<D>& dir)
      : inverse{of(d, dir.x), of(d, dir.y), of(d, dir.z)},
        backX(hn::Lt(inverse.x, hn::Zero(d))),
        backY(hn::Lt(inverse.y, hn::Zero(d))),
        backZ(hn::Lt(inverse.z, hn::Zero(d))) {}

 private:
  static HWY_INLINE hn::Vec<D> of(D d, hn::Vec<D> x) {
    const auto least = hn::Set(d, kSmallest);
    return hn::Div(hn::Set(d, 1.0f), hn::IfThenElse(hn::Lt(hn::Abs(x), least), hn::CopySign(least, x), x));
  }
};

/// The rays that meet the box of block `b` before their tFar.
template <class D>
HWY_INLINE hn::Mask<D> meetBox(D d, const Rays<D>& rays, const Slopes<D>& slopes, const BlockBoxes& boxes,
                               uint32_t b, const float* tFar) {
  const auto enter = [&](uint32_t axis, hn::Mask<D> back, hn::Vec<D> org, hn::Vec<D> inverse) {
    const auto lower = hn::Set(d, boxes.lower[axis][b]), upper = hn::Set(d, boxes.upper[axis][b]);
    return hn::Mul(hn::Sub(hn::IfThenElse(back, upper, lower), org), inverse);
  };
  const auto leave = [&](uint32_t axis, hn::Mask<D> back, hn::Vec<D> org, hn::Vec<D> inverse) {
    const auto lower = hn::Set(d, boxes.lower[axis][b]), upper = hn::Set(d, boxes.upper[axis][b]);
    return hn::Mul(hn::Sub(hn::IfThenElse(back, lower, upper), org), inverse);
  };
  const auto& [org, dir, tNear, valid] = rays;
  const auto from = hn::Max(hn::Max(enter(0, slopes.backX, org.x, slopes.inverse.x),
                                    enter(1, slopes.backY, org.y, slopes.inverse.y)),
                            hn::Max(enter(2, slopes.backZ, org.z, slopes.inverse.z), tNear));
  const auto to = hn::Min(hn::Min(leave(0, slopes.backX, org.x, slopes.inverse.x),
                                  leave(1, slopes.backY, org.y, slopes.inverse.y)),
                          hn::Min(leave(2, slopes.backZ, org.z, slopes.inverse.z), hn::LoadU(d, tFar)));
  return hn::And(valid, hn::Le(from, to));
}

/// The blocks whose boxes ray `i` meets: bit b is block b. Tests several boxes at once.
HWY_INLINE uint32_t blocksOnRay(const BlockBoxes& boxes, const PacketRows& p, unsigned i) {
  const hn::CappedTag<float, TriangleBundle::kBlocks> d;
  const float org[] = {p.orgX[i], p.orgY[i], p.orgZ[i]}, dir[] = {p.dirX[i], p.dirY[i], p.dirZ[i]};
  uint32_t met = 0;
  for (uint32_t b = 0; b < TriangleBundle::kBlocks; b += static_cast<uint32_t>(hn::Lanes(d))) {
    auto from = hn::Set(d, p.tNear[i]), to = hn::Set(d, p.tFar[i]);
    for (int axis = 0; axis < 3; ++axis) {
      const float least = std::fabs(dir[axis]) < kSmallest ? std::copysign(kSmallest, dir[axis]) : dir[axis];
      const auto start = hn::Set(d, org[axis]), inverse = hn::Set(d, 1.0f / least);
      const float* rows[] = {boxes.lower[axis] + b, boxes.upper[axis] + b};
      const bool back = least < 0;
      from = hn::Max(from, hn::Mul(hn::Sub(hn::LoadU(d, rows[back]), start), inverse));
      to = hn::Min(to, hn::Mul(hn::Sub(hn::LoadU(d, rows[!back]), start), inverse));
    }
    uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Le(from, to), bits);
    met |= uint32_t{bits[0]} << b;
  }
  return met;
}

template <class Wanted>
struct BundleQuery {
  const Wanted& wanted;
  const TriangleBundle& bundle;
  const TriangleRun& mesh;
  const PacketRows& p;
  Chooser choose;
  const void* query;
  BlockBoxes boxes{bundle};

  template <class D>
  HWY_INLINE void meetBlock(D d, Rays<D>& rays, uint32_t b, unsigned i) const {
    TriangleRun run = mesh;
    run.first = bundle.first + bundle.offset[b];
    run.end = run.first + bundle.count[b];
    wanted(d, rays, run, p, i, choose, query);
  }

  template <class D>
  HWY_INLINE void meetSome(D d, unsigned i) const {
    Rays<D> rays = load(d, p, i);
    const size_t valid = hn::CountTrue(d, rays.valid);
    if (valid == 0) return;
    if (valid == 1) {
      const auto lane = static_cast<unsigned>(hn::FindFirstTrue(d, rays.valid));
      for (uint32_t met = blocksOnRay(boxes, p, i + lane); met; met &= met - 1)
        meetBlock(d, rays, static_cast<uint32_t>(std::countr_zero(met)), i);
      return;
    }
    const Slopes<D> slopes(d, rays.dir);
    for (uint32_t b = 0; b < bundle.blocks; ++b)
      if (!hn::AllFalse(d, meetBox(d, rays, slopes, boxes, b, p.tFar + i))) meetBlock(d, rays, b, i);
  }

  void meetAll() const {
    const hn::CappedTag<float, kLanes> wide;
    const auto step = static_cast<unsigned>(hn::Lanes(wide));
    unsigned i = 0;
    for (; i + step <= p.count; i += step) meetSome(wide, i);
    for (; i < p.count; ++i) meetSome(hn::CappedTag<float, 1>(), i);
  }
};

void bundleNearest(const TriangleBundle& bundle, const TriangleRun& mesh, const PacketRows& p,
                   const HitNames& names, Chooser choose, const void* query) {
  BundleQuery<Nearest>{Nearest{names}, bundle, mesh, p, choose, query}.meetAll();
}
void bundleAny(const TriangleBundle& bundle, const TriangleRun& mesh, const PacketRows& p, Chooser choose,
               const void* query) {
  BundleQuery<Any>{Any{}, bundle, mesh, p, choose, query}.meetAll();
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::accel {

HWY_EXPORT(bundleNearest);
HWY_EXPORT(bundleAny);

void meetBundle(const TriangleBundle& bundle, const TriangleRun& mesh, const PacketRows& packet,
                const HitNames& names, Chooser choose, const void* query) {
  HWY_DYNAMIC_DISPATCH(bundleNearest)(bundle, mesh, packet, names, choose, query);
}

void occludeBundle(const TriangleBundle& bundle, const TriangleRun& mesh, const PacketRows& packet,
                   Chooser choose, const void* query) {
  HWY_DYNAMIC_DISPATCH(bundleAny)(bundle, mesh, packet, choose, query);
}

}  // namespace gluray::accel
#endif
