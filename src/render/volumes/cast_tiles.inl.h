// Casts the rays of a tile through a volume. Part of volume_kernels.cpp (compiled once for
// each instruction set).
#if defined(GLURAY_RENDER_CAST_TILES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_CAST_TILES_INL_H_
#undef GLURAY_RENDER_CAST_TILES_INL_H_
#else
#define GLURAY_RENDER_CAST_TILES_INL_H_
#endif

#include "render/volumes/cast_levels.inl.h"
#include "render/volumes/cast_rays.inl.h"
#include "render/volumes/with_samples.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// A block of pixels whose rays are cast together.
constexpr int kBlockWidth = kRays >= 8   ? 4
                            : kRays >= 4 ? 2
                                         : 1,
              kBlockHeight = static_cast<int>(kRays) / kBlockWidth;
constexpr int columnOf(size_t ray) { return static_cast<int>(ray) % kBlockWidth; }
constexpr int rowOf(size_t ray) { return static_cast<int>(ray) / kBlockWidth; }

struct RayBlock {
  alignas(64) float values[10][kRays];
  float depths[kRays], coverages[kRays];
  bool any = false;

  RayBlock(const TileRays& rays, int x, int y, const Tile& tile) {
    for (size_t i = 0; i < kRays; ++i) {
      const int column = x + columnOf(i), row = y + rowOf(i);
      const VolumeRay ray = column < tile.x1 && row < tile.y1 ? rays.at(column, row) : VolumeRay{};
      for (int axis = 0; axis < 3; ++axis) {
        values[axis][i] = ray.first[axis], values[3 + axis][i] = ray.step[axis];
        values[6 + axis][i] = ray.towardsViewer[axis];
      }
      values[9][i] = static_cast<float>(ray.samples), depths[i] = ray.depth, coverages[i] = ray.coverage;
      any |= ray.samples > 0;
    }
  }
  HWY_ATTR Rays rays() const {
    const VolumeD d;
    const auto get = [&](int i) HWY_ATTR { return hn::Load(d, values[i]); };
    return {{get(0), get(1), get(2)}, {get(3), get(4), get(5)}, {get(6), get(7), get(8)}, get(9)};
  }
};

/// Makes all pixels of the tile misses.
inline void clearTile(const Tile& tile, Image& image) {
  const auto width = static_cast<size_t>(tile.x1 - tile.x0);
  for (int y = tile.y0; y < tile.y1; ++y) {
    const size_t first =
        static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(tile.x0);
    std::fill_n(image.wideColor.begin() + static_cast<std::ptrdiff_t>(4 * first), 4 * width, 0.0f);
    std::fill_n(image.depth.begin() + static_cast<std::ptrdiff_t>(first), width, Image::kMiss);
  }
}

/// Writes the colours that cast(block, shown) makes of the rays of all blocks, and the depths that it leaves
/// in the block.
template <class Cast>
HWY_ATTR void eachBlock(const VolumeFrame& frame, const Tile& tile, const Cast& cast) {
  const VolumeD d;
  Image& image = *frame.image;
  clearTile(tile, image);
  const TileRays rays(*frame.rays, tile);
  for (int y = tile.y0; y < tile.y1; y += kBlockHeight)
    for (int x = tile.x0; x < tile.x1; x += kBlockWidth) {
      RayBlock block(rays, x, y, tile);
      if (!block.any) continue;
      Alive shown;
      const Colors c = cast(block, shown);
      alignas(64) float colors[4 * kRays];
      alignas(64) float shows[kRays];
      hn::StoreInterleaved4(c.r, c.g, c.b, c.a, d, colors);
      hn::Store(hn::IfThenElseZero(shown, hn::Set(d, 1.0f)), d, shows);
      for (size_t i = 0; i < kRays; ++i) {
        if (shows[i] == 0) continue;
        const size_t pixel = static_cast<size_t>(y + rowOf(i)) * static_cast<size_t>(image.width) +
                             static_cast<size_t>(x + columnOf(i));
        for (size_t c = 0; c < 4; ++c)
          image.wideColor[4 * pixel + c] = colors[4 * i + c] * block.coverages[i];
        image.depth[pixel] = std::min(block.depths[i], 1.0f);
      }
    }
}

/// The depths of places on rays: numbers of samples.
HWY_ATTR inline void findDepths(const scene::VolumeView& view, bool atFront, Floats place, RayBlock& block) {
  const scene::VolumeSpan& span = *view.span;
  alignas(64) float places[kRays];
  hn::Store(place, VolumeD(), places);
  for (size_t i = 0; i < kRays; ++i) {
    glm::dvec3 p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = double{block.values[axis][i]} + double{places[i]} * double{block.values[3 + axis][i]};
    p *= span.size;
    if (atFront) p -= span.shift;
    const glm::dvec4 at = span.depthFromData * glm::dvec4(p, 1);
    block.depths[i] = std::max(static_cast<float>((at.z / at.w + 1) / 2), 0.0f);
  }
}

template <class Samples>
HWY_ATTR void castBlocks(const VolumeFrame& frame, const Samples* samples, const Tile& tile) {
  using Blend = scene::VolumeBlend;
  const Blend blend = frame.volume->blend;
  if (!takesLevels(blend)) {
    const Caster<Samples> caster(frame, samples);
    return eachBlock(frame, tile, [&](const RayBlock& block, Alive& shown) HWY_ATTR {
      return caster.cast(block.rays(), shown);
    });
  }
  const LevelCaster<Samples> caster(frame, samples);
  const bool whole = blend == Blend::over || blend == Blend::screened || blend == Blend::mean;
  eachBlock(frame, tile, [&](RayBlock& block, Alive& shown) HWY_ATTR {
    Floats place;
    const Colors colors = caster.cast(block.rays(), shown, place);
    const scene::VolumeView& view = frame.rays->view();
    if (view.span && view.span->showsDepth) findDepths(view, whole, place, block);
    return colors;
  });
}

struct CastTile {
  const Tile& tile;
  template <class Samples>
  HWY_ATTR void visit(const VolumeFrame& frame, const Samples* samples) const {
    castBlocks(frame, samples, tile);
  }
};

HWY_ATTR void castTile(const VolumeFrame& frame, const Tile& tile) { withSamples(frame, CastTile{tile}); }

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#endif
