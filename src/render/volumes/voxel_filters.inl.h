// How textures are filtered between voxels. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_VOXEL_FILTERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_VOXEL_FILTERS_INL_H_
#undef GLURAY_RENDER_VOXEL_FILTERS_INL_H_
#else
#define GLURAY_RENDER_VOXEL_FILTERS_INL_H_
#endif

#include "render/volumes/ray_blocks.inl.h"
#include "render/volumes/volume_frame.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Three coordinates of several positions.
struct Positions {
  Floats x, y, z;
};

/// A voxel on one axis.
struct VoxelPlace {
  Ints voxel;
  /// Whether there is a voxel more on both sides of it and the next one.
  HWY_ATTR Alive isInside(int size) const {
    const VolumeI di;
    return hn::RebindMask(VolumeD(),
                          hn::And(hn::Gt(voxel, hn::Zero(di)), hn::Lt(voxel, hn::Set(di, size - 2))));
  }
};

/// Shares of the farther of two voxels: of a sample, and of those a step before and after it.
template <class Share>
struct StepShares {
  Share here, before, after;
};

/// A filter finds the voxel before a texture coordinate along one axis, at most the last but one, and the
/// share of the next one.
struct LinearFilter {
  using D = VolumeD;
  using Number = float;
  using Share = Floats;
  using Shares = StepShares<Share>;
  static constexpr bool kMixes = true;

  struct Place : VoxelPlace {
    Share share;

    HWY_INLINE HWY_ATTR Place(Floats coordinate, int size) {
      const VolumeI di;
      const Floats last = hn::Set(D(), static_cast<float>(size - 1));
      const Floats u = hn::Min(hn::Max(positionOf(coordinate, size), hn::Zero(D())), last);
      voxel = hn::Min(hn::ConvertTo(di, u), hn::Set(di, std::max(size - 2, 0)));
      share = hn::Sub(u, hn::ConvertTo(D(), voxel));
    }
    HWY_ATTR Shares around(Floats /*coordinate*/, float step, int size) const {
      const Floats beyond = hn::Set(D(), step * static_cast<float>(size) - 1);
      return {share, hn::Sub(share, beyond), hn::Add(share, beyond)};
    }
  };
  static HWY_ATTR Floats positionOf(Floats coordinate, int size) {
    return hn::MulSub(coordinate, hn::Set(D(), static_cast<float>(size)), hn::Set(D(), 0.5f));
  }
  static HWY_ATTR Share mixed(Share a, Share b, Share share) { return hn::MulAdd(hn::Sub(b, a), share, a); }
  static HWY_ATTR Floats value(Share v) { return v; }
};

/// As llvmpipe's of textures with eight bits a channel (render/local/byte_filter.h).
struct ByteFilter {
  using D = VolumeI;
  using Number = int32_t;
  using Share = Ints;  // in 256ths
  using Shares = StepShares<Share>;
  static constexpr bool kMixes = true;

  struct Place : VoxelPlace {
    Share share;

    HWY_INLINE HWY_ATTR Place(Floats coordinate, int size) {
      const Ints at = positionOf(coordinate, size), last = hn::Set(D(), std::max(size - 2, 0));
      voxel = hn::Min(hn::Max(hn::ShiftRight<8>(at), hn::Zero(D())), last);
      const Ints most = hn::Set(D(), 256);
      share = hn::Min(hn::Max(hn::Sub(at, hn::ShiftLeft<8>(voxel)), hn::Zero(D())), most);
    }
    HWY_ATTR Shares around(Floats coordinate, float step, int size) const {
      const Floats by = hn::Set(VolumeD(), step);
      const Ints one = hn::Set(D(), 1);
      const auto shareOf = [&](Floats at, Ints first)
                               HWY_ATTR { return hn::Sub(positionOf(at, size), hn::ShiftLeft<8>(first)); };
      return {share, shareOf(hn::Sub(coordinate, by), hn::Sub(voxel, one)),
              shareOf(hn::Add(coordinate, by), hn::Add(voxel, one))};
    }
  };
  static HWY_ATTR Ints positionOf(Floats coordinate, int size) {
    const Floats position = hn::Mul(coordinate, hn::Set(VolumeD(), static_cast<float>(size * 256)));
    return hn::Sub(hn::NearestInt(position), hn::Set(D(), 128));
  }
  static HWY_ATTR Share mixed(Share a, Share b, Share share) {
    return hn::Add(a, hn::ShiftRight<8>(hn::Add(hn::Mul(hn::Sub(b, a), share), hn::Set(D(), 128))));
  }
  static HWY_ATTR Floats value(Share v) { return hn::ConvertTo(VolumeD(), v); }
};

struct NearestFilter {
  using D = VolumeD;
  using Number = float;
  using Share = Floats;
  static constexpr bool kMixes = false;

  struct Place : VoxelPlace {
    Share share;

    HWY_INLINE HWY_ATTR Place(Floats coordinate, int size) {
      const VolumeI di;
      const Floats u = hn::Floor(hn::Mul(coordinate, hn::Set(D(), static_cast<float>(size))));
      const Ints nearest = hn::Min(hn::Max(hn::ConvertTo(di, u), hn::Zero(di)), hn::Set(di, size - 1));
      voxel = hn::Min(nearest, hn::Set(di, std::max(size - 2, 0)));
      share = hn::ConvertTo(D(), hn::Sub(nearest, voxel));
    }
  };
  static HWY_ATTR Share mixed(Share a, Share b, Share share) {
    return hn::IfThenElse(hn::Gt(share, hn::Zero(D())), b, a);
  }
  static HWY_ATTR Floats value(Share v) { return v; }
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
