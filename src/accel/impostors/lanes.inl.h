// Vectors of a packet's lanes. Compiled once for each instruction set.
#if defined(GLURAY_ACCEL_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_ACCEL_LANES_INL_H_
#undef GLURAY_ACCEL_LANES_INL_H_
#else
#define GLURAY_ACCEL_LANES_INL_H_
#endif

#include "accel/rays/ray_packet.h"

#include <glm/glm.hpp>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gluray::accel {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<float, kLanes>;
using Float = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

HWY_INLINE Float splat(float v) { return hn::Set(Tag(), v); }
HWY_INLINE Float load(const float* p) { return hn::Load(Tag(), p); }
HWY_INLINE int width() { return static_cast<int>(hn::Lanes(Tag())); }

struct Float3 {
  Float x, y, z;
};
HWY_INLINE Float3 splat(const glm::vec3& v) { return {splat(v.x), splat(v.y), splat(v.z)}; }
HWY_INLINE Float dot(const Float3& a, const Float3& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
/// a + s*b
HWY_INLINE Float3 along(const Float3& a, Float s, const Float3& b) {
  return {hn::MulAdd(s, b.x, a.x), hn::MulAdd(s, b.y, a.y), hn::MulAdd(s, b.z, a.z)};
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::accel
HWY_AFTER_NAMESPACE();
#endif
