#include "render/moving/collector.h"

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/moving/collector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "render/integrators/points.inl.h"
#include "render/moving/history.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Lanes that trace rays in this frame.
HWY_ATTR inline uint32_t tracedLanes(const MovingFrame& moving, uint32_t lanes, const Known& known) {
  if (moving.rays.perPixel == 0) return 0;
  if (!moving.rays.quarter) return lanes;
  constexpr uint32_t kOneOfEachQuad = 0x1111;
  constexpr uint32_t kTurns[] = {0, 3, 1, 2};
  uint32_t traced = kOneOfEachQuad << kTurns[moving.index & 3];
  for (int i = 0; i < kLanes; ++i)
    if (known.samples[i] == 0) traced |= 1u << i;
  return traced & lanes;
}

/// Adds this frame's samples to what is known.
HWY_ATTR inline void accumulate(const MovingFrame& moving, uint32_t traced, const Factors& fresh,
                                Known& known) {
  const FloatTag d;
  const auto rays = static_cast<float>(moving.rays.perPixel);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float before = load(known.samples + i);
    const Float added = hn::IfThenElseZero(lanesAt(traced, i), splat(rays));
    const Float sum = hn::Add(before, added);
    const Float share = hn::IfThenElseZero(hn::Gt(sum, hn::Zero(d)), hn::Div(added, sum));
    for (int f = 0; f < moving.channels.count(); ++f) {
      const Float old = load(moving.channels.of(known.factors, f) + i),
                  now = load(moving.channels.of(fresh, f) + i);
      store(hn::IfThenElse(lanesAt(traced, i), hn::MulAdd(share, hn::Sub(now, old), old), old),
            moving.channels.of(known.factors, f) + i);
    }
    store(hn::Min(sum, splat(static_cast<float>(FactorFilm::kMostSamples))), known.samples + i);
  }
}

HWY_ATTR inline void storePixels(const MovingFrame& moving, const ColoredHits& hits,
                                 const SurfacePoints& points, const scene::Region& region,
                                 const Known& known) {
  FactorFilm& film = *moving.film;
  const FilmSpace& space = moving.space;
  alignas(64) uint32_t word0[kLanes], word1[kLanes];
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float depth =
        hn::Add(dot(splat(glm::vec3(space.depth)), load3(points.eye, i)), splat(space.depth.w));
    const Float second = film.factors > 1 ? load(moving.channels.of(known.factors, 1) + i) : splat(0);
    const FactorPixels pixels{depth, load(known.samples + i), load(moving.channels.of(known.factors, 0) + i),
                              second, load3(points.shading, i)};
    hn::Store(pixels.word0(), WordTag(), word0 + i), hn::Store(pixels.word1(), WordTag(), word1 + i);
  }
  for (uint32_t lanes = hits.group.lanes; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const int x = static_cast<int>(hits.x[i] - static_cast<float>(region.x)),
              y = static_cast<int>(hits.y[i] - static_cast<float>(region.y));
    const size_t at = static_cast<size_t>(y) * static_cast<size_t>(film.width) + static_cast<size_t>(x);
    film.words[2 * at] = word0[i], film.words[2 * at + 1] = word1[i];
    for (int f = 2; f < film.factors; ++f)
      film.more[static_cast<size_t>(f - 2)][at] = static_cast<uint16_t>(
          std::clamp(moving.channels.of(known.factors, f)[i], 0.0f, 1.0f) * FactorFilm::kLargestMore + 0.5f);
  }
}

HWY_ATTR void collect(const Collector& c, const ColoredHits& hits) {
  SurfacePoints points;
  makePoints(c.metric, c.frame, hits, points);
  Known known;
  if (c.moving.earlier && c.moving.reprojection.stayed(hits.instance)) {
    lookUp(c.moving, points.eye, points.shading, known);
  } else {
    for (float& samples : known.samples) samples = 0;
    for (int f = 0; f < c.moving.channels.count(); ++f)
      std::fill_n(c.moving.channels.of(known.factors, f), kLanes, 0.0f);
  }
  const uint32_t traced = tracedLanes(c.moving, hits.group.lanes, known);
  if (traced) {
    Group group = hits.group;
    group.lanes = traced;
    Factors fresh{};
    c.factors.estimate({hits.surface, hits.instance, group, hits.back, hits.sample, hits.x, hits.y}, fresh);
    accumulate(c.moving, traced, fresh, known);
  }
  storePixels(c.moving, hits, points, c.frame.snapshot->region, known);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(collect);

void Collector::light(const ColoredHits& hits, ColorRows&) const noexcept {
  HWY_DYNAMIC_DISPATCH(collect)(*this, hits);
}

}  // namespace gluray::render
#endif
