// Rays of neighbouring pixels, and how they leap over empty space. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_LEAPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_LEAPS_INL_H_
#undef GLURAY_RENDER_LEAPS_INL_H_
#else
#define GLURAY_RENDER_LEAPS_INL_H_
#endif

#include "accel/volumes/macro_cells.h"
#include "render/volumes/voxel_filters.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// The rays of neighbouring pixels.
struct Rays {
  Positions first, step, towardsViewer;
  Floats samples;
  HWY_ATTR Positions at(Floats sample) const {
    return {hn::MulAdd(sample, step.x, first.x), hn::MulAdd(sample, step.y, first.y),
            hn::MulAdd(sample, step.z, first.z)};
  }
};

/// Bytes of an array, which is followed by VolumeFrame::kEmptyPadding more.
HWY_INLINE HWY_ATTR Ints bytesAt(const uint8_t* bytes, Ints index) {
  const VolumeI d;
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2
  return hn::And(hn::GatherOffset(d, reinterpret_cast<const int32_t*>(bytes), index), hn::Set(d, 255));
#else
  alignas(64) int32_t at[kRays];
  hn::Store(index, d, at);
  for (int32_t& i : at) i = bytes[i];
  return hn::Load(d, at);
#endif
}

/// Numbers of the next samples of rays, which leap over what cannot be seen.
class Leaps {
 public:
  HWY_ATTR Leaps(const VolumeFrame& frame, const Rays& rays) : frame_(frame), rays_(rays) {
    const VolumeD d;
    next_ = hn::Zero(d);
    const glm::vec3 size(frame.volume->grid->size);
    speed_ = {hn::Mul(rays.step.x, hn::Set(d, size.x)), hn::Mul(rays.step.y, hn::Set(d, size.y)),
              hn::Mul(rays.step.z, hn::Set(d, size.z))};
    const Floats one = hn::Set(d, 1.0f);
    inverse_ = {hn::Div(one, speed_.x), hn::Div(one, speed_.y), hn::Div(one, speed_.z)};
  }

  /// Rays that have just `seen` something at `sample` take their next samples without a look at their cells:
  /// most will see something, too, and a look takes longer than a sample.
  HWY_ATTR void stay(Alive seen, Floats sample) {
    const VolumeD d;
    next_ = hn::IfThenElse(seen, hn::Max(next_, hn::Add(sample, hn::Set(d, kUnlooked))), next_);
  }
  /// Moves the samples of rays that are `alive` on to the next one that may be seen. Returns those that have
  /// one.
  HWY_INLINE HWY_ATTR Alive move(Alive alive, Floats& sample) {
    const VolumeD d;
    Alive waiting = hn::And(alive, hn::Ge(sample, next_));
    while (!hn::AllFalse(d, waiting)) {
      Alive seen = waiting;
      const Floats end = endOfCell(rays_.at(sample), sample, seen);
      next_ = hn::IfThenElse(waiting, end, next_);
      sample = hn::IfThenElse(hn::AndNot(seen, waiting), end, sample);
      waiting = hn::And(hn::AndNot(seen, waiting), hn::Lt(sample, rays_.samples));
    }
    return hn::And(alive, hn::Lt(sample, rays_.samples));
  }

 private:
  /// Number of the first sample beyond the macro cell, or beyond the empty cells around it. `seen`: the rays
  /// whose cell is not empty.
  HWY_ATTR Floats endOfCell(const Positions& p, Floats sample, Alive& seen) const {
    const VolumeD d;
    const VolumeI di;
    const glm::ivec3 size = frame_.volume->grid->size;
    const Floats coordinates[] = {p.x, p.y, p.z}, speeds[] = {speed_.x, speed_.y, speed_.z},
                 inverses[] = {inverse_.x, inverse_.y, inverse_.z};
    Floats u[3];
    Ints cell[3];
    for (int axis = 0; axis < 3; ++axis) {
      u[axis] = hn::MulSub(coordinates[axis], hn::Set(d, static_cast<float>(size[axis])), hn::Set(d, 0.5f));
      const Floats inside =
          hn::Min(hn::Max(u[axis], hn::Zero(d)), hn::Set(d, static_cast<float>(size[axis] - 1)));
      cell[axis] = hn::Min(hn::ShiftRight<3>(hn::ConvertTo(di, inside)), hn::Set(di, frame_.cells[axis] - 1));
    }
    const Ints row = hn::Add(hn::Mul(cell[2], hn::Set(di, frame_.cells.y)), cell[1]);
    const Ints index = hn::Add(hn::Mul(row, hn::Set(di, frame_.cells.x)), cell[0]);
    const Ints distance = bytesAt(frame_.empty->data(), index);
    seen = hn::RebindMask(d, hn::Eq(distance, hn::Zero(di)));
    const Ints around = hn::Max(hn::Sub(distance, hn::Set(di, 1)), hn::Zero(di));
    Floats steps = hn::Set(d, std::numeric_limits<float>::max());
    static_assert(accel::MacroCells::kSide == 8);
    for (int axis = 0; axis < 3; ++axis) {
      const Floats lower = hn::ConvertTo(d, hn::ShiftLeft<3>(hn::Sub(cell[axis], around)));
      const Floats upper =
          hn::ConvertTo(d, hn::ShiftLeft<3>(hn::Add(hn::Add(cell[axis], around), hn::Set(di, 1))));
      const Floats end = hn::IfThenElse(hn::Gt(speeds[axis], hn::Zero(d)), upper, lower);
      const Floats along = hn::Mul(hn::Sub(end, u[axis]), inverses[axis]);
      steps = hn::IfThenElse(hn::Ne(speeds[axis], hn::Zero(d)), hn::Min(steps, hn::Max(along, hn::Zero(d))),
                             steps);
    }
    const Floats end = hn::Ceil(hn::Add(sample, steps));
    return hn::Max(hn::Min(end, hn::Set(d, 3e7f)), hn::Add(sample, hn::Set(d, 1.0f)));
  }

  static constexpr float kUnlooked = 6;  // samples

  const VolumeFrame& frame_;
  const Rays& rays_;
  Floats next_;                // sample at which the ray leaves the cell that it has looked up
  Positions speed_, inverse_;  // voxels a step
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
