// The light that arrives at samples (SampleIllumination). Compiled once for each instruction set.
#if defined(GLURAY_RENDER_ARRIVING_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_ARRIVING_SAMPLES_INL_H_
#undef GLURAY_RENDER_ARRIVING_SAMPLES_INL_H_
#else
#define GLURAY_RENDER_ARRIVING_SAMPLES_INL_H_
#endif

#include "render/volumes/transfer_lookups.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Cells of the lattice around samples, and the shares of the farther ones.
class LatticePlaces {
 public:
  /// `p`: in texture space.
  HWY_ATTR LatticePlaces(const SampleIllumination& light, const Positions& p) {
    const glm::vec3 scale = glm::vec3(light.size) / (light.upper - light.lower);
    const Floats coordinates[] = {p.x, p.y, p.z};
    Ints first[3], next[3];
    for (int axis = 0; axis < 3; ++axis) {
      const VolumeD d;
      const VolumeI di;
      const int last = light.size[axis] - 1;
      const Floats at = hn::MulSub(hn::Sub(coordinates[axis], hn::Set(d, light.lower[axis])),
                                   hn::Set(d, scale[axis]), hn::Set(d, 0.5f));
      const Floats inside = hn::Min(hn::Max(at, hn::Zero(d)), hn::Set(d, static_cast<float>(last)));
      first[axis] = hn::ConvertTo(di, inside);
      shares_[axis] = hn::Sub(inside, hn::ConvertTo(d, first[axis]));
      next[axis] = hn::Min(hn::Add(first[axis], hn::Set(di, 1)), hn::Set(di, last));
    }
    for (int corner = 0; corner < 8; ++corner) {
      const VolumeI di;
      const Ints x = corner & 1 ? next[0] : first[0], y = corner & 2 ? next[1] : first[1],
                 z = corner & 4 ? next[2] : first[2];
      const Ints row = hn::Add(hn::Mul(z, hn::Set(di, light.size.y)), y);
      cells_[corner] = hn::Add(hn::Mul(row, hn::Set(di, light.size.x)), x);
    }
  }
  HWY_ATTR Floats valueOf(const std::vector<float>& values) const {
    Floats at[8];
    for (int corner = 0; corner < 8; ++corner)
      at[corner] = hn::GatherIndex(VolumeD(), values.data(), cells_[corner]);
    for (int axis = 0, count = 8; axis < 3; ++axis, count /= 2)
      for (int i = 0; i < count / 2; ++i)
        at[i] = hn::MulAdd(hn::Sub(at[2 * i + 1], at[2 * i]), shares_[axis], at[2 * i]);
    return at[0];
  }

 private:
  Ints cells_[8];
  Floats shares_[3];
};

/// Darkens the colours of samples by what hides their surroundings.
HWY_ATTR inline void occlude(const SampleIllumination& light, const Positions& p, Colors& c) {
  if (light.occlusion.empty()) return;
  const Floats open = LatticePlaces(light, p).valueOf(light.occlusion);
  c.r = hn::Mul(c.r, open), c.g = hn::Mul(c.g, open), c.b = hn::Mul(c.b, open);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
