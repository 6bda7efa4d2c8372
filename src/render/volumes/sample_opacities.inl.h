// Opacities of a volume's samples at given positions. Part of opacity_kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_SAMPLE_OPACITIES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_SAMPLE_OPACITIES_INL_H_
#undef GLURAY_RENDER_SAMPLE_OPACITIES_INL_H_
#else
#define GLURAY_RENDER_SAMPLE_OPACITIES_INL_H_
#endif

#include "render/volumes/sample_colors.inl.h"
#include "render/volumes/skipped_samples.inl.h"
#include "render/volumes/with_samples.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

struct SampleRow {
  glm::vec3 first;  // texture space
  float step;       // along x
  int count;
  float* opacities;

  template <class Samples>
  HWY_ATTR void visit(const VolumeFrame& frame, const Samples* samples) const {
    const VolumeD d;
    const SampleColors<Samples> colors(frame, samples);
    const SkippedSamples skipped(*frame.volume);
    const Floats zero = hn::Zero(d);
    const Rays rays{spread(first), spread({step, 0, 0}), {zero, zero, zero}, zero};
    const bool one = frame.volume->use == scene::VolumeChannels::one;
    for (int i = 0; i < count; i += static_cast<int>(kRays)) {
      const Floats number = hn::Iota(d, static_cast<float>(i));
      const Positions p = rays.at(number);
      Alive alive = hn::Lt(number, hn::Set(d, static_cast<float>(count)));
      if (skipped.any()) alive = skipped.kept(p, alive);
      Colors c = noColors();
      const Alive seen = one ? colors.ofOne(rays, p, alive, c) : colors.ofMore(rays, p, alive, c);
      alignas(64) float found[kRays];
      hn::Store(hn::IfThenElseZero(seen, clamped(c.a)), d, found);
      std::copy_n(found, std::min(static_cast<int>(kRays), count - i), opacities + i);
    }
  }
};

HWY_ATTR void sampleRow(const VolumeFrame& frame, const glm::vec3& first, float step, int count,
                        float* opacities) {
  withSamples(frame, SampleRow{first, step, count, opacities});
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
