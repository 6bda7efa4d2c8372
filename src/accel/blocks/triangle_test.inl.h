// The watertight triangle test of Embree 3 and 4 for packets
// (kernels/geometry/triangle_intersector_pluecker.h), operation by operation, so that hits equal those of
// Embree's own triangles. Compiled once for each instruction set.
#if defined(GLURAY_ACCEL_TRIANGLE_TEST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_ACCEL_TRIANGLE_TEST_INL_H_
#undef GLURAY_ACCEL_TRIANGLE_TEST_INL_H_
#else
#define GLURAY_ACCEL_TRIANGLE_TEST_INL_H_
#endif

#include "accel/blocks/triangle_block_kernels.h"

#include <hwy/highway.h>

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace gluray::accel {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
struct Vector3 {
  hn::Vec<D> x, y, z;
};
template <class D>
HWY_INLINE Vector3<D> add(const Vector3<D>& a, const Vector3<D>& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
template <class D>
HWY_INLINE Vector3<D> subtract(const Vector3<D>& a, const Vector3<D>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <class D>
HWY_INLINE hn::Vec<D> dot(const Vector3<D>& a, const Vector3<D>& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
template <class D>
HWY_INLINE Vector3<D> cross(const Vector3<D>& a, const Vector3<D>& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}

/// Per component, a x b or b x c, whichever has the smaller rounding error.
template <class D>
HWY_INLINE Vector3<D> stableNormal(const Vector3<D>& a, const Vector3<D>& b, const Vector3<D>& c) {
  const Vector3<D> ab{hn::Mul(a.z, b.y), hn::Mul(a.x, b.z), hn::Mul(a.y, b.x)};
  const Vector3<D> bc{hn::Mul(b.z, c.y), hn::Mul(b.x, c.z), hn::Mul(b.y, c.x)};
  const auto choose = [](auto first, auto second, auto fromFirst, auto fromSecond) {
    return hn::IfThenElse(hn::Lt(hn::Abs(first), hn::Abs(second)), fromFirst, fromSecond);
  };
  return {choose(ab.x, bc.x, hn::MulSub(a.y, b.z, ab.x), hn::MulSub(b.y, c.z, bc.x)),
          choose(ab.y, bc.y, hn::MulSub(a.z, b.x, ab.y), hn::MulSub(b.z, c.x, bc.y)),
          choose(ab.z, bc.z, hn::MulSub(a.x, b.y, ab.z), hn::MulSub(b.x, c.y, bc.z))};
}

/// The processor's approximation, refined by one Newton step.
template <class V>
HWY_INLINE V reciprocal(V a) {
  const V r = hn::ApproximateReciprocal(a);
  return hn::MulAdd(r, hn::NegMulAdd(a, r, hn::Set(hn::DFromV<V>(), 1.0f)), r);
}

template <class D>
struct Rays {
  Vector3<D> org, dir;
  hn::Vec<D> tNear;
  hn::Mask<D> valid;
};

template <class D>
struct Met {
  hn::Mask<D> rays;
  hn::Vec<D> t, u, v;
  Vector3<D> normal;
};

/// False if no ray hits the triangle.
template <class D>
HWY_INLINE bool meet(D d, const Rays<D>& r, const float* a, const float* b, const float* c, const float* tFar,
                     Met<D>& met) {
  const auto corner = [&](const float* p) {
    return subtract<D>({hn::Set(d, p[0]), hn::Set(d, p[1]), hn::Set(d, p[2])}, r.org);
  };
  const Vector3<D> v0 = corner(a), v1 = corner(b), v2 = corner(c);
  const Vector3<D> e0 = subtract<D>(v2, v0), e1 = subtract<D>(v0, v1), e2 = subtract<D>(v1, v2);
  const auto edge = [&](const Vector3<D>& e, const Vector3<D>& sum) {
    return dot<D>(cross<D>(e, sum), r.dir);
  };
  const auto U = edge(e0, add<D>(v2, v0)), V = edge(e1, add<D>(v0, v1)), W = edge(e2, add<D>(v1, v2));
  const auto UVW = hn::Add(hn::Add(U, V), W);
  const auto tolerance = hn::Mul(hn::Set(d, std::numeric_limits<float>::epsilon()), hn::Abs(UVW));
  const auto least = hn::Min(U, hn::Min(V, W)), most = hn::Max(U, hn::Max(V, W));
  met.rays = hn::And(r.valid, hn::Or(hn::Ge(least, hn::Neg(tolerance)), hn::Le(most, tolerance)));
  if (hn::AllFalse(d, met.rays)) return false;
  met.normal = stableNormal<D>(e0, e1, e2);
  const auto twice = [&](hn::Vec<D> x) { return hn::Add(x, x); };
  const auto den = twice(dot<D>(met.normal, r.dir));
  met.t = hn::Mul(reciprocal(den), twice(dot<D>(v0, met.normal)));
  const auto inside = hn::And(hn::Le(r.tNear, met.t), hn::Le(met.t, hn::LoadU(d, tFar)));
  met.rays = hn::And(met.rays, hn::And(inside, hn::Ne(den, hn::Zero(d))));
  if (hn::AllFalse(d, met.rays)) return false;
  const auto tiny = hn::Lt(hn::Abs(UVW), hn::Set(d, 1e-18f));
  const auto share = hn::IfThenZeroElse(tiny, reciprocal(UVW));
  met.u = hn::Min(hn::Mul(U, share), hn::Set(d, 1.0f));
  met.v = hn::Min(hn::Mul(V, share), hn::Set(d, 1.0f));
  return true;
}

template <class D>
HWY_INLINE void keep(D d, hn::Mask<D> rays, const Met<D>& met, const PacketRows& p, unsigned i,
                     uint32_t triangle, const HitNames& names) {
  const hn::Rebind<uint32_t, D> du;
  const auto put = [&](float* row, hn::Vec<D> value) { hn::BlendedStore(value, rays, d, row + i); };
  const auto name = [&](uint32_t* row, uint32_t value) {
    hn::BlendedStore(hn::Set(du, value), hn::RebindMask(du, rays), du, row + i);
  };
  put(p.normalX, met.normal.x), put(p.normalY, met.normal.y), put(p.normalZ, met.normal.z);
  put(p.u, met.u), put(p.v, met.v);
  name(p.primitive, triangle), name(p.geometry, names.geometry), name(p.instance, names.instance);
}

template <class D>
HWY_INLINE Rays<D> load(D d, const PacketRows& p, unsigned i) {
  const hn::Rebind<int32_t, D> di;
  Rays<D> rays;
  rays.valid = hn::RebindMask(d, hn::Ne(hn::LoadU(di, p.valid + i), hn::Zero(di)));
  rays.org = {hn::LoadU(d, p.orgX + i), hn::LoadU(d, p.orgY + i), hn::LoadU(d, p.orgZ + i)};
  rays.dir = {hn::LoadU(d, p.dirX + i), hn::LoadU(d, p.dirY + i), hn::LoadU(d, p.dirZ + i)};
  rays.tNear = hn::LoadU(d, p.tNear + i);
  return rays;
}

HWY_INLINE const float* corner(const TriangleRun& run, uint32_t triangle, size_t k) {
  const size_t at = size_t{triangle} * 3 + k;
  const size_t vertex = run.indices ? run.indices[at] : at;
  return reinterpret_cast<const float*>(run.positions + vertex * run.stride);
}

template <class D>
HWY_INLINE bool meet(D d, const Rays<D>& rays, const TriangleRun& run, uint32_t triangle, const float* tFar,
                     Met<D>& met) {
  return meet(d, rays, corner(run, triangle, 0), corner(run, triangle, 1), corner(run, triangle, 2), tFar,
              met);
}

/// The rays that the chooser leaves of those that met the triangle.
template <class D>
HWY_INLINE hn::Mask<D> chosen(D d, const Met<D>& met, const PacketRows& p, unsigned i, uint32_t triangle,
                              Chooser choose, const void* query) {
  MetTriangle all{triangle, i, 0, {}, {}, {}};
  hn::StoreU(met.t, d, all.t), hn::StoreU(met.u, d, all.u), hn::StoreU(met.v, d, all.v);
  uint8_t bits[8] = {};
  hn::StoreMaskBits(d, met.rays, bits);
  all.rays = bits[0] | static_cast<uint32_t>(bits[1]) << 8;
  const uint32_t left = choose(query, p, all);
  bits[0] = static_cast<uint8_t>(left), bits[1] = static_cast<uint8_t>(left >> 8);
  return hn::LoadMaskBits(d, bits);
}

/// Finds the nearest hits of one vector of rays with a range of triangles.
struct Nearest {
  HitNames names;
  template <class D>
  HWY_INLINE void operator()(D d, Rays<D>& rays, const TriangleRun& run, const PacketRows& p, unsigned i,
                             Chooser choose, const void* query) const {
    for (uint32_t t = run.first; t < run.end; ++t) {
      Met<D> met;
      if (!meet(d, rays, run, t, p.tFar + i, met)) continue;
      if (!choose) {
        hn::BlendedStore(met.t, met.rays, d, p.tFar + i);
        keep(d, met.rays, met, p, i, t, names);
        continue;
      }
      const auto left = chosen(d, met, p, i, t, choose, query);
      if (!hn::AllFalse(d, left)) keep(d, left, met, p, i, t, names);
    }
  }
};

/// Finds the rays that a range of triangles blocks, and makes them invalid.
struct Any {
  template <class D>
  HWY_INLINE void operator()(D d, Rays<D>& rays, const TriangleRun& run, const PacketRows& p, unsigned i,
                             Chooser choose, const void* query) const {
    for (uint32_t t = run.first; t < run.end && !hn::AllFalse(d, rays.valid); ++t) {
      Met<D> met;
      if (!meet(d, rays, run, t, p.tFar + i, met)) continue;
      const auto blocked = choose ? chosen(d, met, p, i, t, choose, query) : met.rays;
      hn::BlendedStore(hn::Set(d, -std::numeric_limits<float>::infinity()), blocked, d, p.tFar + i);
      rays.valid = hn::AndNot(blocked, rays.valid);
    }
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::accel
HWY_AFTER_NAMESPACE();
#endif
