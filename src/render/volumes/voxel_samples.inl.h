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
    Floats value;
    at<1>(&p, &value);
    return value;
  }
  /// Of several positions of each ray. Their steps alternate, so that the processor works on all at a time.
  template <int count>
  HWY_INLINE HWY_ATTR void at(const Positions* p, Floats* values) const {
    RayNumbers first[count];
    Share x[count], y[count], z[count];
    for (int i = 0; i < count; ++i) {
      const Place px(p[i].x, size_.x), py(p[i].y, size_.y), pz(p[i].z, size_.z);
      first[i].set(indices(px.voxel, py.voxel, pz.voxel));
      x[i] = px.share, y[i] = py.share, z[i] = pz.share;
    }
    RowValues rows[count];
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < count; ++i) {
        const Columns<D> row = rowAt<2>(first[i], rowOffset(k));
        rows[i].value[k] = mixed(row.column[0], size_.x > 1 ? row.column[1] : row.column[0], x[i]);
      }
    for (int i = 0; i < count; ++i) values[i] = Filter::value(sheet(rows[i], y[i], z[i]));
  }

  /// Whether around() may be called, with four voxels or more along each axis.
  static constexpr bool kHasWindows = Filter::kMixes;

 private:
  using Place = typename Filter::Place;
  using D = typename Filter::D;
  using Share = typename Filter::Share;    // of the farther of two voxels
  using Number = typename Filter::Number;  // of one ray
  using Shares = StepShares<Share>;

  /// Of the four rows around a sample: two along y, two along z.
  struct RowValues {
    Share value[4];
  };

 public:
  /// Samples, and what differences() needs.
  struct Around {
    Alive known;  // the rays whose samples are not at the grid's border; others have no `here`
    Floats here;

   private:
    friend class VoxelSamples;
    RayNumbers first;
    Shares x, y, z;
    RowValues before, rows, after;
  };
  /// As at(). `step`: of texture coordinates, longer than a voxel by at most 0.01 voxels.
  HWY_INLINE HWY_ATTR void around(const Positions& p, const glm::vec3& step, Around& out) const {
    const VolumeI di;
    const Place x(p.x, size_.x), y(p.y, size_.y), z(p.z, size_.z);
    out.known = hn::And(x.isInside(size_.x), hn::And(y.isInside(size_.y), z.isInside(size_.z)));
    const auto kept = [&](Ints voxel) HWY_ATTR {
      return hn::IfThenElse(hn::RebindMask(di, out.known), voxel, hn::Set(di, 1));
    };
    out.first.set(indices(kept(x.voxel), kept(y.voxel), kept(z.voxel)));
    out.x = x.around(p.x, step.x, size_.x), out.y = y.around(p.y, step.y, size_.y);
    out.z = z.around(p.z, step.z, size_.z);
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
      const auto [v] = rowAt<4>(out.first, rowOffset(k) - 1);
      out.before.value[k] = mixed(v[0], v[1], out.x.before),
      out.rows.value[k] = mixed(v[1], v[2], out.x.here);
      out.after.value[k] = mixed(v[2], v[3], out.x.after);
    }
    out.here = Filter::value(sheet(out.rows, out.y.here, out.z.here));
  }
  /// The differences of the samples a step farther and a step before along each axis, from fewer loads than
  /// at() needs for them. Where a step crosses one more voxel, the values before that are continued.
  HWY_INLINE HWY_ATTR Positions differences(const Around& a) const {
    const auto difference = [](Share a, Share b)
                                HWY_ATTR { return hn::Sub(Filter::value(a), Filter::value(b)); };
    const auto side = [&](ptrdiff_t offset) HWY_ATTR {
      const Columns<D> row = rowAt<2>(a.first, offset);
      return mixed(row.column[0], row.column[1], a.x.here);
    };
    const Share* const r = a.rows.value;
    Positions out;
    out.x = difference(sheet(a.after, a.y.here, a.z.here), sheet(a.before, a.y.here, a.z.here));
    out.y = difference(sheet({{r[1], side(2 * up_), r[3], side(back_ + 2 * up_)}}, a.y.after, a.z.here),
                       sheet({{side(-up_), r[0], side(back_ - up_), r[2]}}, a.y.before, a.z.here));
    out.z = difference(sheet({{r[2], r[3], side(2 * back_), side(up_ + 2 * back_)}}, a.y.here, a.z.after),
                       sheet({{side(-back_), side(up_ - back_), r[0], r[1]}}, a.y.here, a.z.before));
    return out;
  }

 private:
  static HWY_INLINE HWY_ATTR Share mixed(Share a, Share b, Share share) { return Filter::mixed(a, b, share); }
  static HWY_INLINE HWY_ATTR Share sheet(const RowValues& r, Share y, Share z) {
    return mixed(mixed(r.value[0], r.value[1], y), mixed(r.value[2], r.value[3], y), z);
  }
  HWY_INLINE ptrdiff_t rowOffset(int k) const { return (k & 1 ? up_ : 0) + (k & 2 ? back_ : 0); }

  /// Neighbours along x from the voxels that lie `offset` after `first`. `count`: of columns.
  template <int count>
  HWY_INLINE HWY_ATTR Columns<D> rowAt(const RayNumbers& first, ptrdiff_t offset) const {
    const D d;
    const Stored* const values = values_ + offset;
    const auto from = [&](size_t ray) { return values + first[ray]; };
    return columnsOf<count>(d, numbersOf(blocksOf<0>(from)), numbersOf(blocksOf<1>(from)),
                            numbersOf(blocksOf<2>(from)), numbersOf(blocksOf<3>(from)));
  }

  using Loaded = LoadedD<Stored>;
  /// Signed numbers have one more below 0 than above, which counts as the next one (OpenGL 4.6, 2.3.5.1).
  static HWY_INLINE HWY_ATTR hn::Vec<D> numbersOf(hn::Vec<Loaded> stored) {
    if constexpr (std::is_integral_v<Stored> && std::is_signed_v<Stored>)
      stored = hn::Max(stored, hn::Set(Loaded(), -std::numeric_limits<Stored>::max()));
    if constexpr (std::is_same_v<D, Loaded>)
      return stored;
    else
      return hn::ConvertTo(D(), stored);
  }

  HWY_ATTR Ints indices(Ints x, Ints y, Ints z) const {
    const VolumeI di;
    const Ints row = hn::Set(di, size_.x), rows = hn::Set(di, size_.y);
    return hn::Add(hn::Mul(hn::Add(hn::Mul(z, rows), y), row), x);
  }

  const Stored* values_;
  glm::ivec3 size_;
  ptrdiff_t up_, back_;
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
