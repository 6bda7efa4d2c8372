// Scalars of a volume's samples, and their differences around them. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_SAMPLE_SCALARS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_SAMPLE_SCALARS_INL_H_
#undef GLURAY_RENDER_SAMPLE_SCALARS_INL_H_
#else
#define GLURAY_RENDER_SAMPLE_SCALARS_INL_H_
#endif

#include "render/volumes/sample_lighting.inl.h"
#include "render/volumes/voxel_samples.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

template <class Samples>
class SampleScalars {
 public:
  /// `samples`: of each channel.
  HWY_ATTR SampleScalars(const VolumeFrame& frame, const Samples* samples)
      : volume_(*frame.volume), samples_(samples) {
    const scene::VoxelGrid& grid = *volume_.grid;
    const glm::vec3 beyond = volume_.cellStep * glm::vec3(grid.size) - 1.0f;
    stepsAreVoxels_ = std::min({grid.size.x, grid.size.y, grid.size.z}) >= 4 &&
                      glm::all(glm::lessThan(glm::abs(beyond), glm::vec3(0.01f)));
    for (size_t c = 0; c < frame.channels.size(); ++c)
      scales_[c] = frame.channels[c].scale, biases_[c] = frame.channels[c].bias;
  }

  HWY_ATTR Floats scalarAt(const Positions& p, size_t channel) const {
    return scalarOf(samples_[channel].at(p), channel);
  }

  /// A scalar, and what its gradient is made of.
  struct Sample {
    Floats scalar;
    typename Samples::Around around;
    bool windows = false;  // false: there is no `around`
  };
  /// `gradients`: whether differences are asked for.
  HWY_INLINE HWY_ATTR void sampleAt(const Positions& p, Alive alive, size_t channel, bool gradients,
                                    Sample& sample) const {
    const VolumeD d;
    if constexpr (Samples::kHasWindows)
      if (stepsAreVoxels_ && gradients) {
        samples_[channel].around(p, volume_.cellStep, sample.around);
        sample.windows = true;
        sample.scalar = scalarOf(sample.around.here, channel);
        if (!hn::AllFalse(d, hn::AndNot(sample.around.known, alive)))
          sample.scalar = hn::IfThenElse(sample.around.known, sample.scalar, scalarAt(p, channel));
        return;
      }
    sample.around = {};  // compilers do not see that `windows` tells whether it is set
    sample.scalar = scalarAt(p, channel);
  }
  template <int count>
  HWY_INLINE HWY_ATTR void samplesAt(const Positions* p, const Alive* alive, size_t channel, bool gradients,
                                     Sample* samples, Floats* scalars) const {
    if (stepsAreVoxels_ && gradients && Samples::kHasWindows) {
      for (int i = 0; i < count; ++i) {
        sampleAt(p[i], alive[i], channel, gradients, samples[i]);
        scalars[i] = samples[i].scalar;
      }
      return;
    }
    const Samples voxels = samples_[channel];
    voxels.template at<count>(p, scalars);
    for (int i = 0; i < count; ++i) scalars[i] = scalarOf(scalars[i], channel);
  }
  /// Differences of scalars around a sample, of rays that have `seen` it.
  HWY_INLINE HWY_ATTR Positions differencesAt(const Positions& p, Alive seen, const Sample& sample,
                                              size_t channel) const {
    const VolumeD d;
    if constexpr (Samples::kHasWindows)
      if (sample.windows) {
        const Alive known = sample.around.known;
        const Positions found =
            scaled(samples_[channel].differences(sample.around), hn::Set(d, scales_[channel]));
        if (hn::AllFalse(d, hn::AndNot(known, seen))) return found;
        const Positions other = differencesAt(p, channel);
        return {hn::IfThenElse(known, found.x, other.x), hn::IfThenElse(known, found.y, other.y),
                hn::IfThenElse(known, found.z, other.z)};
      }
    return differencesAt(p, channel);
  }

  /// Differences of scalars around a sample.
  HWY_ATTR Positions differencesAt(const Positions& p, size_t channel) const {
    const VolumeD d;
    const Floats x = hn::Set(d, volume_.cellStep.x), y = hn::Set(d, volume_.cellStep.y),
                 z = hn::Set(d, volume_.cellStep.z);
    const auto at = [&](Floats px, Floats py, Floats pz) HWY_ATTR { return scalarAt({px, py, pz}, channel); };
    return {hn::Sub(at(hn::Add(p.x, x), p.y, p.z), at(hn::Sub(p.x, x), p.y, p.z)),
            hn::Sub(at(p.x, hn::Add(p.y, y), p.z), at(p.x, hn::Sub(p.y, y), p.z)),
            hn::Sub(at(p.x, p.y, hn::Add(p.z, z)), at(p.x, p.y, hn::Sub(p.z, z)))};
  }

 protected:
  const scene::Volume& volume_;

 private:
  HWY_ATTR Floats scalarOf(Floats value, size_t channel) const {
    const VolumeD d;
    return hn::MulAdd(value, hn::Set(d, scales_[channel]), hn::Set(d, biases_[channel]));
  }

  const Samples* samples_;
  float scales_[4] = {}, biases_[4] = {};  // from a stored number to the scalar
  bool stepsAreVoxels_ = false;            // gradients need samples about a voxel apart
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
