// Where the hits of a group are: points and normals in eye space, and origins for rays that leave them.
// Compiled once for each instruction set.
#if defined(GLURAY_RENDER_INTEGRATORS_POINTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_INTEGRATORS_POINTS_INL_H_
#undef GLURAY_RENDER_INTEGRATORS_POINTS_INL_H_
#else
#define GLURAY_RENDER_INTEGRATORS_POINTS_INL_H_
#endif

#include "render/integrators/integrator.h"
#include "render/integrators/metric.h"
#include "render/integrators/solid_points.h"
#include "render/integrators/surface_points.h"
#include "render/shading/fragment_inputs.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

HWY_INLINE void store3(const Float3& v, Row (&rows)[3], int i) {
  store(v.x, rows[0] + i), store(v.y, rows[1] + i), store(v.z, rows[2] + i);
}

HWY_INLINE Float largestSize(const Float3& v) {
  return hn::Max(hn::Abs(v.x), hn::Max(hn::Abs(v.y), hn::Abs(v.z)));
}

/// Unit length for vectors of any length that a float can have; `otherwise` for those without one.
HWY_INLINE Float3 direction(const Float3& v, const Float3& otherwise) {
  const Float largest = largestSize(v);
  const Float inverse = hn::Div(splat(1), largest);
  const auto usable = hn::And(hn::Ge(largest, splat(1e-37f)), hn::Le(largest, splat(1e37f)));
  const Float3 u = unit(scaled(v, inverse));
  return {hn::IfThenElse(usable, u.x, otherwise.x), hn::IfThenElse(usable, u.y, otherwise.y),
          hn::IfThenElse(usable, u.z, otherwise.z)};
}

/// `v`, or its opposite where it points to the other side than `side`.
HWY_INLINE Float3 facing(const Float3& v, const Float3& side) {
  const auto turned = hn::Lt(dot(v, side), hn::Zero(FloatTag()));
  const Float sign = hn::IfThenElse(turned, splat(-1), splat(1));
  return scaled(v, sign);
}

/// Puts the origin above a point in eye space: by what rounding may have moved the point, and by `lift`.
HWY_INLINE void placeOrigin(const Metric& metric, const Surface& s, const Float3& eye, const Float3& normal,
                            const Float3& lift, SurfacePoints& out, int i) {
  // Coordinates in the world are rounded by 2^-24 of their size, in the point as in what the ray meets.
  constexpr float kRounded = 6e-7f;
  const Float3 world = transformPoint(metric.worldFromEye, eye);
  const glm::vec3 place =
      glm::abs(glm::vec3(s.instance->worldFromObject[3])) + glm::abs(glm::vec3(metric.worldFromEye[3]));
  const auto along = [&](Float coordinate, int axis) HWY_ATTR {
    return hn::Mul(hn::Add(hn::Abs(coordinate), splat(place[axis])), splat(kRounded * metric.axes[axis]));
  };
  const Float error = hn::Add(along(world.x, 0), hn::Add(along(world.y, 1), along(world.z, 2)));
  const Float3 above = add(add(eye, scaled(normal, error)), lift);
  store3(transformPoint(metric.worldFromEye, above), out.origin, i);
  store3(above, out.eye, i);
  const Float height = largestSize(lift);
  store(hn::IfThenElseZero(hn::Gt(height, error), height), out.lift + i);
}

/// Where smooth normals stand for a curved surface: the way from the triangle to that surface, so that rays
/// along it are not cut off by the triangle's neighbours (J. Hanika, "Hacking the Shadow Terminator", 2021).
HWY_INLINE Float3 towardsSmooth(const Surface& s, const Group& group, const Weights& weights,
                                const Float3& object, const Float3 (&normals)[3], const Float3& side, int i) {
  const glm::mat3 linear(s.eyeFromObject);
  const Float3 n0 = facing(normals[0], side), n1 = facing(normals[1], side), n2 = facing(normals[2], side);
  // The curve is in what the normals differ by. What they lean to together is none: rays must not leave a
  // flat triangle from far above it.
  const Float3 lean = sub(scaled(add(n0, add(n1, n2)), splat(1.0f / 3)), side);
  const Float3 curved[] = {sub(n0, lean), sub(n1, lean), sub(n2, lean)};
  Float3 lift[3];
  for (int k = 0; k < 3; ++k) {
    const Float3 n = curved[k];
    const Float3 from = transform(linear, sub(object, load3(group.position[k], i)));
    const Float rounded = hn::Mul(largestSize(from), splat(1e-5f));
    lift[k] = scaled(n, hn::Neg(hn::Min(hn::Add(dot(from, n), rounded), hn::Zero(FloatTag()))));
  }
  return weights(lift[0], lift[1], lift[2]);
}

/// Points of triangles.
HWY_ATTR inline void pointsOfTriangles(const Metric& metric, const ColoredHits& hits, SurfacePoints& out) {
  const Surface& s = hits.surface;
  const Group& group = hits.group;
  const scene::Shading& how = *s.lighting->shading;
  const bool smooth = s.mesh->normals && how.smooth;
  const bool knowsSide = smooth && how.fragment.model == scene::FragmentShading::Model::off;
  alignas(64) Row normal[3][3];
  if (smooth)
    for (int k = 0; k < 3; ++k) loadVec3(s.mesh->normals, s.mesh->vertexCount, group.vertex[k], normal[k]);
  const glm::vec3 away(metric.away);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    Weights weights(group, i);
    // The pixel's point may lie beside the triangle that its ray met, there behind another surface.
    weights.clampToTriangle();
    const Float3 corner[] = {load3(group.position[0], i), load3(group.position[1], i),
                             load3(group.position[2], i)};
    const Float3 object = weights(corner[0], corner[1], corner[2]);
    const Float3 eye = transformPoint(s.eyeFromObject, object);
    const Float3 toViewer = sub(scaled(eye, splat(static_cast<float>(metric.away.w))), splat(away));
    const Float3 viewer = direction(toViewer, splat(glm::vec3(0, 0, 1)));
    const glm::mat3 linear(s.eyeFromObject);
    const Float3 edge0 = direction(transform(linear, sub(corner[1], corner[0])), viewer),
                 edge1 = direction(transform(linear, sub(corner[2], corner[0])), viewer);
    const Float3 flat = facing(direction(cross(edge0, edge1), viewer), viewer);
    Float3 shading = flat, lift = splat(glm::vec3(0));
    Float turned = hn::Zero(FloatTag());
    if (smooth) {
      Float3 corners[3];
      for (int k = 0; k < 3; ++k)
        corners[k] = direction(transform(s.eyeFromVertexNormal, load3(normal[k], i)), flat);
      const Float3 given = direction(weights(corners[0], corners[1], corners[2]), flat);
      if (knowsSide) turned = hn::IfThenElseZero(hn::Lt(dot(given, flat), hn::Zero(FloatTag())), splat(1));
      shading = facing(given, flat);
      lift = towardsSmooth(s, group, weights, object, corners, flat, i);
    }
    store3(flat, out.geometric, i), store3(shading, out.shading, i);
    store(turned, out.turned + i);
    placeOrigin(metric, s, eye, flat, lift, out, i);
  }
  if (!knowsSide || !how.twoSided) return;
  for (uint32_t lanes = group.lanes; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    if (s.isCcw(group.primitive[i]) != s.frontIsCcw) out.turned[i] = 1 - out.turned[i];
  }
}

/// Points of impostors, on the solids that other rays meet.
HWY_ATTR inline void pointsOfImpostors(const Metric& metric, const FrameData& frame, const ColoredHits& hits,
                                       SurfacePoints& out) {
  alignas(64) Row point[3];
  solidPoints(metric, frame, hits, point, out.geometric);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const Float3 normal = load3(out.geometric, i);
    store3(normal, out.shading, i);
    store(hn::Zero(FloatTag()), out.turned + i);
    placeOrigin(metric, hits.surface, load3(point, i), normal, splat(glm::vec3(0)), out, i);
  }
}

HWY_ATTR inline void makePoints(const Metric& metric, const FrameData& frame, const ColoredHits& hits,
                                SurfacePoints& out) {
  if (hits.surface.mesh->shape == scene::Shape::triangles)
    pointsOfTriangles(metric, hits, out);
  else
    pointsOfImpostors(metric, frame, hits, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
