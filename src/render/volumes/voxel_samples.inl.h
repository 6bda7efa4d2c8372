// Samples of a voxel grid at several positions at once. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_VOXEL_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_VOXEL_SAMPLES_INL_H_
#undef GLURAY_RENDER_VOXEL_SAMPLES_INL_H_
#else
#define GLURAY_RENDER_VOXEL_SAMPLES_INL_H_
#endif

#include "render/volumes/voxel_filters.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Values of one channel at texture coordinates, in the units in which they are stored, clamped to the grid's
/// edge. `Stored`: type of a voxel's channel. `Filter`: one of voxel_filters.inl.h.
template <class Stored, class Filter>
class VoxelSamples {
 public:
  HWY_ATTR VoxelSamples(const scene::VoxelGrid& grid, int channel)
      : values_(reinterpret_cast<const Stored*>(grid.channel(channel))),
        size_(grid.size),
        up_(grid.size.y > 1 ? grid.size.x : 0),
        back_(grid.size.z > 1 ? static_cast<ptrdiff_t>(grid.size.x) * grid.size.y : 0) {}

  HWY_ATTR Floats at(const Positions& p) const {
    const Place x(p.x, size_.x), y(p.y, size_.y), z(p.z, size_.z);
    alignas(64) int32_t index[kRays];
    indices(x.voxel, y.voxel, z.voxel, index);
    Rows rows;
    rows.load(values_, index, up_, back_, size_.x > 1);
    return Filter::value(sheet(rows.mixed(x.share), y.share, z.share));
  }

  /// Whether around() may be called, with four voxels or more along each axis.
  static constexpr bool kHasWindows = Filter::kMixes;

  /// A sample, and the differences of those a step farther and a step before along each axis.
  struct Around {
    Floats here;
    Positions differences;
  };
  /// The values of seven calls of at(), from fewer loads. `step`: of texture coordinates, longer than a voxel
  /// by at most 0.01 voxels: where it crosses one more voxel, the values before that are continued. Returns
  /// the rays for which they are set: none at the grid's border.
  HWY_ATTR Alive around(const Positions& p, const glm::vec3& step, Around& out) const {
    const VolumeD d;
    const VolumeI di;
    const Place x(p.x, size_.x), y(p.y, size_.y), z(p.z, size_.z);
    const Alive inside = hn::And(x.isInside(size_.x), hn::And(y.isInside(size_.y), z.isInside(size_.z)));
    if (hn::AllFalse(d, inside)) return inside;
    const auto kept = [&](Ints voxel) HWY_ATTR {
      return hn::IfThenElse(hn::RebindMask(di, inside), voxel, hn::Set(di, 1));
    };
    alignas(64) int32_t index[kRays];
    indices(kept(x.voxel), kept(y.voxel), kept(z.voxel), index);
    Window w;
    w.load(values_, index, up_, back_);
    mix(w, x.around(p.x, step.x, size_.x), y.around(p.y, step.y, size_.y), z.around(p.z, step.z, size_.z),
        out);
    return inside;
  }

 private:
  using Place = typename Filter::Place;
  using Share = typename Filter::Share;    // of the farther of two voxels
  using Number = typename Filter::Number;  // of one ray

  static HWY_ATTR Share mixed(Share a, Share b, Share share) { return Filter::mixed(a, b, share); }
  /// Of the four rows around a sample: two along y, two along z.
  struct RowValues {
    Share value[4];
  };
  static HWY_ATTR Share sheet(const RowValues& r, Share y, Share z) {
    return mixed(mixed(r.value[0], r.value[1], y), mixed(r.value[2], r.value[3], y), z);
  }

  /// Pairs of neighbours along x in the rows around samples.
  struct Rows {
    alignas(64) Number pairs[4][2 * kRays];

    HWY_ATTR void load(const Stored* values, const int32_t* index, ptrdiff_t up, ptrdiff_t back,
                       bool pairwise) {
      alignas(64) Stored stored[4][2 * kRays];
      const ptrdiff_t rows[] = {0, up, back, back + up};
      for (size_t i = 0; i < kRays; ++i) {
        const Stored* const p = values + index[i];
        for (int k = 0; k < 4; ++k) std::memcpy(&stored[k][2 * i], p + rows[k], 2 * sizeof(Stored));
      }
      for (int k = 0; k < 4; ++k) {
        for (size_t i = 0; i < kRays && !pairwise; ++i) stored[k][2 * i + 1] = stored[k][2 * i];
        for (size_t i = 0; i < 2 * kRays; ++i) pairs[k][i] = static_cast<Number>(valueOf(stored[k][i]));
      }
    }
    HWY_ATTR RowValues mixed(Share share) const {
      RowValues rows;
      for (int k = 0; k < 4; ++k) {
        Share left, right;
        hn::LoadInterleaved2(typename Filter::D(), pairs[k], left, right);
        rows.value[k] = Filter::mixed(left, right, share);
      }
      return rows;
    }
  };

  /// The voxels for around(): four along x in the rows of a sample; two in the rows beside them.
  struct Window {
    alignas(64) Number quads[4][4 * kRays];
    alignas(64) Number pairs[8][2 * kRays];

    HWY_ATTR void load(const Stored* values, const int32_t* index, ptrdiff_t up, ptrdiff_t back) {
      alignas(64) Stored fours[4][4 * kRays], twos[8][2 * kRays];
      const ptrdiff_t rows[] = {0, up, back, back + up};
      const ptrdiff_t beside[] = {-up,   back - up, 2 * up,   back + 2 * up,
                                  -back, up - back, 2 * back, up + 2 * back};
      for (size_t i = 0; i < kRays; ++i) {
        const Stored* const p = values + index[i];
        for (int k = 0; k < 4; ++k) std::memcpy(&fours[k][4 * i], p + rows[k] - 1, 4 * sizeof(Stored));
        for (int k = 0; k < 8; ++k) std::memcpy(&twos[k][2 * i], p + beside[k], 2 * sizeof(Stored));
      }
      for (int k = 0; k < 4; ++k)
        for (size_t i = 0; i < 4 * kRays; ++i) quads[k][i] = static_cast<Number>(valueOf(fours[k][i]));
      for (int k = 0; k < 8; ++k)
        for (size_t i = 0; i < 2 * kRays; ++i) pairs[k][i] = static_cast<Number>(valueOf(twos[k][i]));
    }
  };

  using Shares = StepShares<Share>;
  static HWY_ATTR void mix(const Window& w, const Shares& x, const Shares& y, const Shares& z, Around& out) {
    const typename Filter::D d;
    RowValues rows, before, after;
    Share sides[8];
    for (int k = 0; k < 4; ++k) {
      Share v[4];
      hn::LoadInterleaved4(d, w.quads[k], v[0], v[1], v[2], v[3]);
      before.value[k] = mixed(v[0], v[1], x.before), rows.value[k] = mixed(v[1], v[2], x.here);
      after.value[k] = mixed(v[2], v[3], x.after);
    }
    for (int k = 0; k < 8; ++k) {
      Share left, right;
      hn::LoadInterleaved2(d, w.pairs[k], left, right);
      sides[k] = mixed(left, right, x.here);
    }
    const auto difference = [](Share a, Share b)
                                HWY_ATTR { return hn::Sub(Filter::value(a), Filter::value(b)); };
    const Share* const r = rows.value;
    out.here = Filter::value(sheet(rows, y.here, z.here));
    out.differences.x = difference(sheet(after, y.here, z.here), sheet(before, y.here, z.here));
    out.differences.y = difference(sheet({{r[1], sides[2], r[3], sides[3]}}, y.after, z.here),
                                   sheet({{sides[0], r[0], sides[1], r[2]}}, y.before, z.here));
    out.differences.z = difference(sheet({{r[2], r[3], sides[6], sides[7]}}, y.here, z.after),
                                   sheet({{sides[4], sides[5], r[0], r[1]}}, y.here, z.before));
  }

  /// Signed numbers have one more below 0 than above, which counts as the next one (OpenGL 4.6, 2.3.5.1).
  static HWY_ATTR Stored valueOf(Stored stored) {
    if constexpr (std::is_signed_v<Stored> && sizeof(Stored) < 4)
      return std::max<Stored>(stored, -std::numeric_limits<Stored>::max());
    return stored;
  }

  HWY_ATTR void indices(Ints x, Ints y, Ints z, int32_t* out) const {
    const VolumeI di;
    const Ints row = hn::Set(di, size_.x), rows = hn::Set(di, size_.y);
    hn::Store(hn::Add(hn::Mul(hn::Add(hn::Mul(z, rows), y), row), x), di, out);
  }

  const Stored* values_;
  glm::ivec3 size_;
  ptrdiff_t up_, back_;
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
