// Points, normals and depths of impostors at pixels (scene/impostors.h). Part of kernels.cpp (compiled once
// for each instruction set).
#if defined(GLURAY_RENDER_IMPOSTOR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_IMPOSTOR_INL_H_
#undef GLURAY_RENDER_IMPOSTOR_INL_H_
#else
#define GLURAY_RENDER_IMPOSTOR_INL_H_
#endif

#include "accel/impostors/pixel_impostor.h"
#include "render/hit_points/depth.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

HWY_INLINE Double splatDouble(double v) { return hn::Set(DoubleTag(), v); }

struct Double3 {
  Double x, y, z;
};
HWY_INLINE Double dot(const Double3& a, const Double3& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE Double dot(const glm::dvec4& a, const Double3& b) {
  const Double3 xyz{splatDouble(a.x), splatDouble(a.y), splatDouble(a.z)};
  return hn::Add(dot(xyz, b), splatDouble(a.w));
}
HWY_INLINE Double3 scaled(const Double3& a, Double s) {
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
HWY_INLINE Double3 sub(const Double3& a, const Double3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
/// a + s*b
HWY_INLINE Double3 along(const Double3& a, Double s, const Double3& b) {
  return {hn::MulAdd(s, b.x, a.x), hn::MulAdd(s, b.y, a.y), hn::MulAdd(s, b.z, a.z)};
}
HWY_INLINE Double3 unit(const Double3& a) {
  return scaled(a, hn::Div(splatDouble(1), hn::Sqrt(hn::Max(dot(a, a), splatDouble(1e-200)))));
}
HWY_INLINE Double3 blend(hn::Mask<DoubleTag> m, const Double3& yes, const Double3& no) {
  return {hn::IfThenElse(m, yes.x, no.x), hn::IfThenElse(m, yes.y, no.y), hn::IfThenElse(m, yes.z, no.z)};
}

/// The lines of sight in lighting space, relative to the impostors' centres; they point away from the viewer.
struct Lines {
  Double3 center, org, dir;  // dir: unit length
};

template <class Bend>
HWY_INLINE Lines linesThrough(const Surface& s, const Group& group, const Bend& lens, Double x, Double y,
                              int i) {
  const ImpostorSpace& space = s.impostors;
  Double h[4];
  for (int c = 0; c < 4; ++c)
    h[c] = hn::MulAdd(x, splatDouble(space.startX[c]),
                      hn::MulAdd(y, splatDouble(space.startY[c]), splatDouble(space.start[c])));
  const Double w = hn::Div(splatDouble(1), h[3]);
  const Double stepW = splatDouble(space.step.w);
  DoubleRays r;
  for (int c = 0; c < 3; ++c) {
    r.org[c] = hn::Mul(h[c], w);
    r.dir[c] = hn::NegMulAdd(r.org[c], stepW, splatDouble(space.step[c]));
  }
  lens.bend(r, i);
  const Double3 start{r.org[0], r.org[1], r.org[2]};
  Lines lines;
  lines.dir = unit({r.dir[0], r.dir[1], r.dir[2]});
  lines.center = {loadDouble(group.point[0] + i), loadDouble(group.point[1] + i),
                  loadDouble(group.point[2] + i)};
  lines.org = sub(start, lines.center);
  return lines;
}

/// Visible points of impostors, relative to their centres.
struct Seen {
  Double3 point, normal;
  Double fade, alpha;
};

HWY_INLINE Double3 towardsViewer(const Surface& s, const Lines& lines) {
  if (!s.instance->impostors.parallelView) return unit(scaled(lines.center, splatDouble(-1)));
  return {splatDouble(0), splatDouble(0), splatDouble(1)};
}

HWY_INLINE Seen seeSphere(const Surface& s, const Lines& l, Double radius) {
  const Double zero = splatDouble(0);
  const Double to = hn::Neg(dot(l.org, l.dir));
  const Double3 nearest = along(l.org, to, l.dir);
  const Double chord = hn::Sqrt(hn::Max(hn::MulSub(radius, radius, dot(nearest, nearest)), zero));
  const bool inside = s.instance->impostors.inside;
  const Double3 normal = unit(along(nearest, inside ? chord : hn::Neg(chord), l.dir));
  return {scaled(normal, radius), inside ? scaled(normal, splatDouble(-1)) : normal, splatDouble(1),
          splatDouble(1)};
}

/// A point of the disc at the half sphere's z, on the line of sight.
HWY_INLINE Seen seeHemisphere(const Lines& l, Double radius) {
  const Double zero = splatDouble(0), one = splatDouble(1);
  const Double3 on = along(l.org, hn::Neg(hn::Div(l.org.z, l.dir.z)), l.dir);
  const Double x = hn::Div(on.x, radius), y = hn::Div(on.y, radius);
  const Double z = hn::Sqrt(hn::Max(hn::Sub(one, hn::MulAdd(x, x, hn::Mul(y, y))), zero));
  const Double height = hn::Mul(z, radius);
  return {along(l.org, hn::Div(hn::Sub(height, l.org.z), l.dir.z), l.dir), {x, y, z}, one, one};
}

/// exp(-v / 2)
HWY_INLINE Double fallOff(Double v) {
  alignas(64) double values[hn::MaxLanes(DoubleTag())];
  hn::Store(v, DoubleTag(), values);
  for (size_t i = 0; i < hn::Lanes(DoubleTag()); ++i) values[i] = std::exp(-0.5 * values[i]);
  return hn::Load(DoubleTag(), values);
}

HWY_INLINE Seen seeDisc(const Surface& s, const Lines& l, Double radius) {
  const Double3 n = towardsViewer(s, l);
  const Double t = hn::Neg(hn::Div(dot(n, l.org), dot(n, l.dir)));
  const Double3 point = along(l.org, t, l.dir);
  const Double share = hn::Div(dot(point, point), hn::Mul(radius, radius));
  if (s.instance->impostors.gaussian) return {point, n, splatDouble(1), fallOff(share)};
  return {point, n, s.instance->impostors.fades ? hn::Sub(splatDouble(1), share) : splatDouble(1),
          splatDouble(1)};
}

HWY_INLINE Seen seeCylinder(const Surface& s, const Group& group, const Lines& l, Double radius, int i) {
  const Double zero = splatDouble(0);
  const Double3 object{loadDouble(group.normal[0] + i), loadDouble(group.normal[1] + i),
                       loadDouble(group.normal[2] + i)};
  const Double halfLength = hn::Mul(hn::Sqrt(dot(object, object)), splatDouble(0.5));
  const glm::dmat3 m(s.instance->impostors.axisMatrix);
  const Double3 direction = unit(object);
  const auto row = [&](int r) HWY_ATTR { return dot(glm::dvec4(m[0][r], m[1][r], m[2][r], 0), direction); };
  Double3 axis{row(0), row(1), row(2)};
  axis = blend(hn::Lt(axis.z, zero), scaled(axis, splatDouble(-1)), axis);
  const Double dirZ = dot(axis, l.dir), orgZ = dot(axis, l.org);
  const Double3 d = along(l.dir, hn::Neg(dirZ), axis), o = along(l.org, hn::Neg(orgZ), axis);
  const Double a = hn::Max(dot(d, d), splatDouble(1e-30));
  const Double middle = hn::Neg(hn::Div(dot(o, d), a));
  const Double3 nearest = along(o, middle, d);
  const Double chord = hn::Sqrt(hn::Div(hn::Max(hn::MulSub(radius, radius, dot(nearest, nearest)), zero), a));
  const Double enter = hn::Sub(middle, chord);
  const auto onMantle = hn::Le(hn::Abs(hn::MulAdd(enter, dirZ, orgZ)), halfLength);
  const Double toEnd = hn::Div(hn::Sub(halfLength, orgZ), dirZ);
  const Double3 normal = blend(onMantle, scaled(along(o, enter, d), hn::Div(splatDouble(1), radius)), axis);
  return {along(l.org, hn::IfThenElse(onMantle, enter, toEnd), l.dir), normal, splatDouble(1),
          splatDouble(1)};
}

HWY_INLINE void storeRows(const Double3& v, Row (&rows)[3], int i) {
  storeFloat(v.x, rows[0] + i), storeFloat(v.y, rows[1] + i), storeFloat(v.z, rows[2] + i);
}

/// Points, normals and depths of the group's impostors at window positions x, y: programs compute them at
/// pixel centres, an open lens (in lighting space) where its rays are. Depth is the point's, which the
/// program writes, clamped to [0, 1]. All are front-facing.
template <class Bend>
HWY_ATTR inline void computeImpostors(const Surface& surface, const DepthMap& map, const Bend& lens,
                                      const float* x, const float* y, Group& group, DepthAndFacing& out) {
  const scene::Mesh& mesh = *surface.mesh;
  alignas(64) Row radius;
  for (int i = 0; i < kLanes; ++i) {
    radius[i] = mesh.radii ? scene::fetch(mesh.radii, group.vertex[0][i]).x : mesh.radius;
    const glm::vec3 object(group.position[0][0][i], group.position[0][1][i], group.position[0][2][i]);
    const glm::vec3 center = surface.centerOfImpostor(object);
    for (int c = 0; c < 3; ++c) group.point[c][i] = center[c];
  }
  if (mesh.shape == scene::Shape::cylinders)
    loadVec3(mesh.axes, mesh.vertexCount, group.vertex[0], group.normal);
  const Double zero = splatDouble(0), one = splatDouble(1);
  const Double smaller = splatDouble(1 / double{surface.instance->impostors.radiusDivisor});
  for (int i = 0; i < kLanes; i += static_cast<int>(hn::Lanes(DoubleTag()))) {
    const Double px = lens.position(loadDouble(x + i)), py = lens.position(loadDouble(y + i));
    const Lines lines = linesThrough(surface, group, lens, px, py, i);
    const Double r = hn::Mul(loadDouble(radius + i), smaller);
    Seen seen;
    if (surface.instance->impostors.hemispheres && !Bend::kOpen)
      seen = seeHemisphere(lines, r);
    else if (mesh.shape == scene::Shape::spheres)
      seen = seeSphere(surface, lines, r);
    else if (mesh.shape == scene::Shape::discs)
      seen = seeDisc(surface, lines, r);
    else
      seen = seeCylinder(surface, group, lines, r, i);
    const Double3 point = along(seen.point, one, lines.center);
    storeRows(point, group.point, i);
    storeRows(seen.normal, group.normal, i);
    storeFloat(seen.fade, group.fade + i), storeFloat(seen.alpha, group.alpha + i);
    const Double ndc = hn::Div(dot(surface.impostors.clipZ, point), dot(surface.impostors.clipW, point));
    const Double depth = hn::MulAdd(ndc, splatDouble(map.scale), splatDouble(map.offset));
    storeFloat(hn::Min(hn::Max(depth, zero), one), out.depth + i);
  }
  out.ccw = surface.frontIsCcw ? ~0u : 0;
}

/// The same for beads, tubes and splats. Attributes of a line's ends are interpolated by u.
HWY_ATTR inline void computePixelImpostors(const Surface& surface, const accel::PlacedImpostors& placed,
                                           const float* x, const float* y, Group& group,
                                           DepthAndFacing& out) {
  for (int i = 0; i < kLanes; ++i) group.fade[i] = group.alpha[i] = 1, group.u[i] = group.v[i] = 0;
  for (uint32_t lanes = group.lanes; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const accel::PixelImpostor impostor(placed, group.primitive[i]);
    accel::PixelImpostor::Shown shown;
    impostor.show({std::floor(x[i]) + 0.5, std::floor(y[i]) + 0.5}, shown);
    glm::vec3 end[2];
    for (int k = 0; k < 2; ++k)
      end[k] = surface.centerOfImpostor(
          {group.position[k][0][i], group.position[k][1][i], group.position[k][2][i]});
    const auto along = static_cast<float>(shown.along);
    const glm::vec3 point = glm::mix(end[0], end[1], along);
    for (int c = 0; c < 3; ++c) group.point[c][i] = point[c], group.normal[c][i] = shown.normal[c];
    group.u[i] = along;
    group.fade[i] = shown.fade, group.alpha[i] = shown.alpha;
    out.depth[i] = static_cast<float>(shown.depth);
  }
  for (int i = 0; i < kLanes; ++i) {
    if (group.lanes >> i & 1) continue;
    const int leader = std::countr_zero(group.lanes);
    for (int c = 0; c < 3; ++c)
      group.point[c][i] = group.point[c][leader], group.normal[c][i] = group.normal[c][leader];
    out.depth[i] = out.depth[leader];
  }
  out.ccw = surface.frontIsCcw ? ~0u : 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
