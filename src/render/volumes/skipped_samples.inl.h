// Samples that a volume's cropping or mask leaves out. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_SKIPPED_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_SKIPPED_SAMPLES_INL_H_
#undef GLURAY_RENDER_SKIPPED_SAMPLES_INL_H_
#else
#define GLURAY_RENDER_SKIPPED_SAMPLES_INL_H_
#endif

#include "render/volumes/voxel_samples.inl.h"

#include <optional>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

class SkippedSamples {
 public:
  explicit HWY_ATTR SkippedSamples(const scene::Volume& volume) : cropping_(volume.cropping.get()) {
    if (!volume.mask) return;
    if (volume.maskLinear)
      linearMask_.emplace(*volume.mask, 0);
    else
      nearestMask_.emplace(*volume.mask, 0);
  }
  bool any() const { return cropping_ || linearMask_ || nearestMask_; }

  /// The rays among those `alive` whose sample at `p` counts.
  HWY_ATTR Alive kept(const Positions& p, Alive alive) const {
    const VolumeD d;
    if (cropping_) alive = hn::And(alive, isKept(p));
    if (linearMask_) alive = hn::And(alive, hn::Gt(linearMask_->at(p), hn::Zero(d)));
    if (nearestMask_) alive = hn::And(alive, hn::Gt(nearestMask_->at(p), hn::Zero(d)));
    return alive;
  }

 private:
  HWY_ATTR Alive isKept(const Positions& p) const {
    const VolumeD d;
    const Floats positions[] = {p.x, p.y, p.z}, zero = hn::Zero(d);
    Floats box = zero;
    float size = 1;
    for (int axis = 0; axis < 3; ++axis, size *= 3) {
      const auto first = static_cast<size_t>(2 * axis);
      const Floats one = hn::Set(d, size), two = hn::Set(d, 2 * size);
      const Floats beyondLower = hn::Set(d, cropping_->planes[first]),
                   beyondUpper = hn::Set(d, cropping_->planes[first + 1]);
      const Floats part = hn::IfThenElse(hn::Ge(positions[axis], beyondUpper), two, one);
      box = hn::Add(box, hn::IfThenZeroElse(hn::Lt(positions[axis], beyondLower), part));
    }
    alignas(64) float boxes[kRays];
    hn::Store(box, d, boxes);
    for (float& b : boxes) b = cropping_->kept[static_cast<size_t>(b)] ? 1.0f : 0.0f;
    return hn::Gt(hn::Load(d, boxes), zero);
  }

  const scene::VolumeCropping* cropping_;
  std::optional<VoxelSamples<uint8_t, LinearFilter>> linearMask_;
  std::optional<VoxelSamples<uint8_t, NearestFilter>> nearestMask_;
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
