// Labels of a volume's samples. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_SAMPLE_LABELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_SAMPLE_LABELS_INL_H_
#undef GLURAY_RENDER_SAMPLE_LABELS_INL_H_
#else
#define GLURAY_RENDER_SAMPLE_LABELS_INL_H_
#endif

#include "render/volumes/transfer_lookups.inl.h"
#include "render/volumes/voxel_samples.inl.h"

#include <optional>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

class SampleLabels {
 public:
  explicit HWY_ATTR SampleLabels(const scene::VolumeLabels& labels) : labels_(labels) {
    if (labels.voxels) bytes_.emplace(*labels.voxels, 0);
  }

  /// Coordinates of the rows of labels in the table; 0: no label. There must be labels.
  HWY_ATTR Floats rowsAt(const Positions& p) const {
    const VolumeD d;
    alignas(64) float rows[kRays];
    hn::Store(bytes_->at(p), d, rows);
    for (float& row : rows) row = labels_.rows[static_cast<size_t>(row)];
    return hn::Load(d, rows);
  }

 private:
  const scene::VolumeLabels& labels_;
  std::optional<VoxelSamples<uint8_t, NearestFilter>> bytes_;
};

HWY_ATTR inline Colors byOpacity(const Colors& c) {
  return {hn::Mul(c.r, c.a), hn::Mul(c.g, c.a), hn::Mul(c.b, c.a), c.a};
}
HWY_ATTR inline Colors chosen(Alive first, const Colors& a, const Colors& b) {
  return {hn::IfThenElse(first, a.r, b.r), hn::IfThenElse(first, a.g, b.g), hn::IfThenElse(first, a.b, b.b),
          hn::IfThenElse(first, a.a, b.a)};
}
HWY_ATTR inline Colors mixedColors(const Colors& a, const Colors& b, Floats share) {
  const auto mix = [&](Floats x, Floats y) HWY_ATTR { return hn::MulAdd(share, hn::Sub(y, x), x); };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), mix(a.a, b.a)};
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
