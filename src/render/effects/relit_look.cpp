#include "render/effects/relit_look.h"

#include "render/lights/form_factor.h"

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/effects/relit_look.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// What follows is included once for each instruction set, after Highway's macros.
#include "render/integrators/points.inl.h"
#include "render/shading/shade.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// In place of AllLight: shadowed lights, and light from all sides.
struct Arriving {
  const Arrival& what;
  const SurfacePoints* points;  // if some lights have an area
  int first = 0;                // lane
  static constexpr bool kHasSizes = true;

  HWY_INLINE Arriving at(int i) const { return {what, points, i}; }
  HWY_INLINE Float diffuse(size_t light, Float share, const Float3& normal) const {
    return points && light >= what.areas->first ? ofArea(light - what.areas->first, share, normal) : share;
  }
  HWY_INLINE Float3 arriving(size_t light, const Float3& color) const {
    return shared(light < what.rows.ofLight.size() ? what.rows.ofLight[light] : -1, color);
  }
  HWY_INLINE Float3 withDome(const Float3& sum, const Float3& color, const Float3& normal) const {
    if (!what.dome) return sum;
    // The cosine-weighted share of the upper hemisphere.
    const Float above = clamp01(hn::MulAdd(splat(0.5f), dot(normal, splat(what.rows.up)), splat(0.5f)));
    const Float3 dome =
        add(scaled(splat(what.dome->sky), above), scaled(splat(what.dome->ground), hn::Sub(splat(1), above)));
    return add(sum, shared(what.rows.ofDome, times(color, dome)));
  }

 private:
  HWY_ATTR HWY_NOINLINE Float ofArea(size_t source, Float share, const Float3& normal) const {
    const scene::LightSource& light = what.areas->sources[source];
    if (!isArea(light)) return share;
    alignas(64) Row n[3], result;
    store3(direction(transform(what.rows.eyeFromLighting, normal), normal), n, 0);
    for (int i = 0; i < lanesOfVector(); ++i) {
      const int lane = first + i;
      result[i] = formFactor(light, {points->eye[0][lane], points->eye[1][lane], points->eye[2][lane]},
                             {n[0][i], n[1][i], n[2][i]});
    }
    return load(result);
  }
  HWY_INLINE Float3 shared(int row, const Float3& color) const {
    return row < 0 ? color : times(color, load3(what.visibility.lights[row], first));
  }
};

HWY_ATTR void shadeArriving(const FrameData& frame, const Surface& surface, const ColoredHits& hits,
                            const Arrival& arrival, ColorRows& rows) {
  LitRows lit;
  SurfacePoints points;
  if (arrival.areas) makePoints(arrival.areas->metric, frame, hits, points);
  shade(frame, surface, hits.group, hits.back, hits.x, hits.y, lit,
        Arriving{arrival, arrival.areas ? &points : nullptr});
  rows = lit;
}

HWY_ATTR void fogBlack(const ColoredHits& hits, ColorRows& rows) {
  LitRows black{};
  applyFog(hits.surface, hits.group, black);
  rows = black;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {

HWY_EXPORT(shadeArriving);
HWY_EXPORT(fogBlack);

void shadeAgain(const FrameData& frame, const Surface& surface, const ColoredHits& hits,
                const Arrival& arrival, ColorRows& rows) {
  HWY_DYNAMIC_DISPATCH(shadeArriving)(frame, surface, hits, arrival, rows);
}

void fogAlone(const ColoredHits& hits, ColorRows& rows) { HWY_DYNAMIC_DISPATCH(fogBlack)(hits, rows); }

}  // namespace gluray::render
#endif
