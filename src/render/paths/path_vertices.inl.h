// Makes vertices of paths: where they are, and the colours that the local look gives them. Compiled once for
// each instruction set.
#if defined(GLURAY_RENDER_PATHS_PATH_VERTICES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_PATHS_PATH_VERTICES_INL_H_
#undef GLURAY_RENDER_PATHS_PATH_VERTICES_INL_H_
#else
#define GLURAY_RENDER_PATHS_PATH_VERTICES_INL_H_
#endif

#include "render/integrators/altered_look.h"
#include "render/integrators/points.inl.h"
#include "render/paths/path.h"
#include "render/paths/path_vertex.h"
#include "render/paths/ray_cone.h"
#include "render/shading/shade.inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Rows that become vertices.
struct VertexRows {
  alignas(64) Row point[3], geometric[3], shading[3], lift[3], error;
  uint32_t ccw = 0;  // bit i: the path comes from the side that sees corners in counterclockwise order
};

/// Bound of the rounding errors of points, as in placeOrigin (points.inl.h).
HWY_INLINE Float errorAt(const Metric& metric, const Surface& s, const Float3& eye) {
  constexpr float kRounded = 6e-7f;
  const Float3 world = transformPoint(metric.worldFromEye, eye);
  const glm::vec3 place =
      glm::abs(glm::vec3(s.instance->worldFromObject[3])) + glm::abs(glm::vec3(metric.worldFromEye[3]));
  const auto along = [&](Float coordinate, int axis) HWY_ATTR {
    return hn::Mul(hn::Add(hn::Abs(coordinate), splat(place[axis])), splat(kRounded * metric.axes[axis]));
  };
  return hn::Add(along(world.x, 0), hn::Add(along(world.y, 1), along(world.z, 2)));
}

/// `from`: rows of directions back along the paths.
HWY_ATTR inline void locateOnTriangles(const Metric& metric, const Surface& s, const Group& group,
                                       const Row (&from)[3], VertexRows& out) {
  const bool smooth = s.mesh->normals && s.lighting->shading->smooth;
  alignas(64) Row normal[3][3];
  if (smooth)
    for (int k = 0; k < 3; ++k) loadVec3(s.mesh->normals, s.mesh->vertexCount, group.vertex[k], normal[k]);
  const glm::mat3 linear(s.eyeFromObject);
  alignas(64) Row faces;
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    Weights weights(group, i);
    weights.clampToTriangle();
    const Float3 corner[] = {load3(group.position[0], i), load3(group.position[1], i),
                             load3(group.position[2], i)};
    const Float3 object = weights(corner[0], corner[1], corner[2]);
    const Float3 eye = transformPoint(s.eyeFromObject, object), back = load3(from, i);
    const Float3 edge0 = direction(transform(linear, sub(corner[1], corner[0])), back),
                 edge1 = direction(transform(linear, sub(corner[2], corner[0])), back);
    const Float3 winding = direction(cross(edge0, edge1), back);
    store(dot(winding, back), faces + i);
    const Float3 flat = facing(winding, back);
    Float3 shading = flat, lift = splat(glm::vec3(0));
    if (smooth) {
      Float3 corners[3];
      for (int k = 0; k < 3; ++k)
        corners[k] = direction(transform(s.eyeFromVertexNormal, load3(normal[k], i)), flat);
      shading = facing(direction(weights(corners[0], corners[1], corners[2]), flat), flat);
      lift = towardsSmooth(s, group, weights, object, corners, flat, i);
    }
    store3(eye, out.point, i), store3(flat, out.geometric, i), store3(shading, out.shading, i);
    store3(lift, out.lift, i);
    store(errorAt(metric, s, eye), out.error + i);
  }
  out.ccw = 0;
  for (int i = 0; i < kLanes; ++i) out.ccw |= static_cast<uint32_t>(faces[i] >= 0) << i;
}

/// Points and normals of impostors are in `out` already.
HWY_ATTR inline void finishSolids(const Metric& metric, const Surface& s, VertexRows& out) {
  out.ccw = s.frontIsCcw ? ~0u : 0;
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    store3(load3(out.geometric, i), out.shading, i);
    store3(splat(glm::vec3(0)), out.lift, i);
    store(errorAt(metric, s, load3(out.point, i)), out.error + i);
  }
}

/// A shading normal that the path's way back sees as well.
inline glm::vec3 seenNormal(const glm::vec3& normal, const glm::vec3& back) {
  constexpr float kMin = 1e-3f;
  const float cosine = glm::dot(normal, back);
  return cosine >= kMin ? normal : glm::normalize(normal + (kMin - cosine) * back);
}

/// What a physically based material's textures change at the group's vertices.
inline void applyPbrTexels(const Path& path, const Surface& s, const Group& group, const float* x,
                           const float* y, PathVertices& out) {
  const scene::PbrSurface& pbr = s.lighting->shading->fragment.pbr;
  PbrTextures textures(s, path.frame.snapshot->camera);
  for (uint32_t lanes = group.lanes; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    PathVertex& v = out.lane[i];
    const PbrTexels t = textures.at(group.primitive[i], group.u[i], group.v[i], {x[i], y[i]},
                                    group.steps ? group.steps + i : nullptr);
    v.metallic *= t.metallic, v.roughness *= t.roughness;
    if (pbr.normal < 0) continue;
    const glm::vec3 bent = mappedNormal(v.shading, s.eyeFromVertexNormal * t.tangent, t.normal);
    if (!(glm::dot(bent, bent) > 0)) continue;  // no tangent
    v.shading = bent;
  }
}

/// The specular colour of a program's surface with this albedo, the product of diffuse and base colour.
inline glm::vec3 specularOf(const scene::FragmentShading& f, const scene::Material& m,
                            const glm::vec3& albedo) {
  using Color = scene::FragmentShading::HighlightColor;
  const glm::vec3 specular(m.specular), diffuse(m.diffuse);
  if (f.highlightColor == Color::material) return specular;
  const glm::vec3 base = glm::clamp(albedo / glm::max(diffuse, glm::vec3(1e-6f)), 0.0f, 1.0f);
  return specular * (f.highlightColor == Color::base ? base : 1.0f - base);
}

/// Writes the vertices of the group's lanes. `x`, `y`: window positions, for textures.
HWY_ATTR inline void colorVertices(const Path& path, const SurfaceColors& colors, uint32_t instance,
                                   const Group& group, const Row (&from)[3], const VertexRows& rows,
                                   const float* x, const float* y, PathVertices& out) {
  const Surface& s = path.frame.surfaces[instance];
  const bool mirrored = path.mirrored;
  const uint32_t ccw = mirrored ? ~rows.ccw : rows.ccw, back = (s.frontIsCcw ? ~ccw : ccw) & group.lanes;
  LitRows albedo, emission;
  const bool captured = path.captured && path.captured->has(instance);
  if (!captured) shade(path.frame, (*colors.albedo)[instance], group, back, x, y, albedo);
  const MaterialModel& model = path.materials[instance];
  const scene::Shading& shading = *s.lighting->shading;
  const bool program = shading.fragment.model != scene::FragmentShading::Model::off;
  const bool sided = program ? shading.fragment.backMaterial : shading.twoSided;
  const bool unlit = !isLit(shading) && model.isProgram();
  const bool emits = colors.emission && isLit(shading);
  const scene::PbrSurface& pbr = shading.fragment.pbr;
  if (emits) shade(path.frame, (*colors.emission)[instance], group, back, x, y, emission);
  const auto at = [](const Row* r, int i) { return glm::vec3(r[0][i], r[1][i], r[2][i]); };
  for (uint32_t lanes = group.lanes; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    PathVertex& v = out.lane[i];
    v.point = at(rows.point, i), v.geometric = at(rows.geometric, i), v.lift = at(rows.lift, i);
    v.shading = at(rows.shading, i), v.metallic = pbr.metallic, v.roughness = pbr.roughness;
    v.error = rows.error[i];
    const glm::vec3 color = captured ? path.captured->at(instance, v.point) : at(albedo.value, i);
    v.albedo = unlit ? glm::vec3(0) : glm::clamp(color, 0.0f, 1.0f);
    v.emission = unlit ? color : emits ? at(emission.value, i) : glm::vec3(0);
    if (model.isEmissive()) v.albedo = glm::vec3(0), v.emission = model.emission * color;
    v.opacity = captured ? 1 : albedo.value[3][i];
    const bool backMaterial = sided && (back >> i & 1);
    const scene::Material& m = faceOf(s.materials[materialIndex(s, group.vertex[2][i])], backMaterial);
    v.specular = model.isProgram() ? specularOf(shading.fragment, m, v.albedo) : glm::vec3(0);
    v.shininess = m.shininess;
    v.instance = instance;
    v.front = !(back >> i & 1);
  }
  if (!pbr.textures.empty() && model.isProgram()) applyPbrTexels(path, s, group, x, y, out);
  for (uint32_t lanes = group.lanes; lanes; lanes &= lanes - 1) {
    PathVertex& v = out.lane[std::countr_zero(lanes)];
    v.shading = seenNormal(v.shading, at(from, std::countr_zero(lanes)));
  }
}

/// Vertices of hits that the camera sees.
HWY_ATTR inline void cameraVertices(const Path& path, const ColoredHits& hits, Row (&from)[3],
                                    PathVertices& out) {
  VertexRows rows;
  const bool triangles = hits.surface.mesh->shape == scene::Shape::triangles;
  if (!triangles) solidPoints(path.metric, path.frame, hits, rows.point, rows.geometric);
  const glm::vec3 away(path.metric.away);
  const float perspective = static_cast<float>(path.metric.away.w);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    Float3 eye;
    if (triangles) {
      const Weights weights(hits.group, i);
      eye = transformPoint(hits.surface.eyeFromObject,
                           weights(load3(hits.group.position[0], i), load3(hits.group.position[1], i),
                                   load3(hits.group.position[2], i)));
    } else {
      eye = load3(rows.point, i);
    }
    const Float3 toViewer = sub(scaled(eye, splat(perspective)), splat(away));
    store3(direction(toViewer, splat(glm::vec3(0, 0, 1))), from, i);
  }
  if (triangles)
    locateOnTriangles(path.metric, hits.surface, hits.group, from, rows);
  else
    finishSolids(path.metric, hits.surface, rows);
  colorVertices(path, path.seen, hits.instance, hits.group, from, rows, hits.x, hits.y, out);
}

/// The lanes among `lanes` that hit the same instance as the first of them.
inline void gatherBounced(const FrameData& frame, const accel::RayPacket& packet, uint32_t lanes,
                          Group& group) {
  const int leader = std::countr_zero(lanes);
  const scene::Mesh& mesh = *frame.surfaces[packet.instance[leader]].mesh;
  group.lanes = 0;
  for (int i = 0; i < kLanes; ++i) {
    const bool member = (lanes >> i & 1) && packet.instance[i] == packet.instance[leader];
    const int lane = member ? i : leader;
    group.lanes |= static_cast<uint32_t>(member) << i;
    group.primitive[i] = packet.primitive[lane];
    for (uint32_t k = 0; k < 3; ++k) group.vertex[k][i] = mesh.corner(packet.primitive[lane], k);
    group.u[i] = packet.u[lane], group.v[i] = packet.v[lane];
    group.fade[i] = group.alpha[i] = 1;
  }
}

/// Points on solids that rays from elsewhere met.
inline void bouncedSolids(const Path& path, const Surface& s, const accel::RayPacket& packet,
                          const Group& group, const Row (&from)[3], VertexRows& out) {
  const int leader = std::countr_zero(group.lanes);
  const glm::mat3 toEye(s.eyeFromObjectNormal);
  for (int i = 0; i < kLanes; ++i) {
    const int lane = group.lanes >> i & 1 ? i : leader;
    const glm::vec3 org(packet.orgX[lane], packet.orgY[lane], packet.orgZ[lane]),
        dir(packet.dirX[lane], packet.dirY[lane], packet.dirZ[lane]);
    const glm::dvec3 world = glm::dvec3(org) + double{packet.tFar[lane]} * glm::dvec3(dir);
    const glm::vec3 eye(path.frame.snapshot->eyeFromWorld * glm::dvec4(world, 1));
    const glm::vec3 back(from[0][lane], from[1][lane], from[2][lane]);
    const glm::dvec3 n =
        glm::dmat3(toEye) * glm::dvec3(packet.normalX[lane], packet.normalY[lane], packet.normalZ[lane]);
    const double length = glm::length(n);
    glm::vec3 normal = length > 0 ? glm::vec3(n / length) : back;
    if (glm::dot(normal, back) < 0) normal = -normal;
    for (int c = 0; c < 3; ++c) out.point[c][i] = eye[c], out.geometric[c][i] = normal[c];
  }
}

/// Places along sticks, for the colours of their two ends. `point`: eye space.
inline void placeOnSticks(const Surface& s, const Row (&point)[3], Group& group) {
  const glm::dmat4 objectFromEye = glm::inverse(s.instance->eyeFromObject);
  const auto corner = [&](int k, int i) {
    return glm::dvec3(group.position[k][0][i], group.position[k][1][i], group.position[k][2][i]);
  };
  for (int i = 0; i < kLanes; ++i) {
    const glm::dvec3 line = corner(1, i) - corner(0, i);
    const glm::dvec3 at(objectFromEye * glm::dvec4(point[0][i], point[1][i], point[2][i], 1));
    const double share = glm::dot(at - corner(0, i), line) / glm::dot(line, line);
    const bool halves = (s.mesh->endAt(group.vertex[0][i]) & scene::kTwoHalves) != 0;
    group.u[i] = static_cast<float>(halves ? (share < 0.5 ? 0.0 : 1.0) : std::clamp(share, 0.0, 1.0));
  }
}

/// How wide pixels are on the triangles of the group. `cones`: of the packet's rays.
inline void footprintsOf(const Surface& s, const Group& group, const accel::RayPacket& packet,
                         const Row (&from)[3], const RayCone (&cones)[kLanes], WeightSteps (&out)[kLanes]) {
  for (uint32_t lanes = group.lanes; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    glm::dvec3 corner[3];
    for (int k = 0; k < 3; ++k) {
      const Row(&p)[3] = group.position[k];
      corner[k] = glm::dvec3(s.eyeFromObject * glm::vec4(p[0][i], p[1][i], p[2][i], 1));
    }
    out[i] = stepsOn(corner, {from[0][i], from[1][i], from[2][i]}, double{cones[i].widthAt(packet.tFar[i])});
  }
}

/// Vertices of the lanes of a packet that hit something. `from`: back along its rays, unit length; `cones`:
/// of these rays, if textures are filtered.
HWY_ATTR inline void bouncedVertices(const Path& path, const accel::RayPacket& packet, uint32_t lanes,
                                     const Row (&from)[3], const float* x, const float* y,
                                     const RayCone (&cones)[kLanes], PathVertices& out) {
  Group group;
  VertexRows rows;
  WeightSteps steps[kLanes];
  while (lanes) {
    gatherBounced(path.frame, packet, lanes, group);
    lanes &= ~group.lanes;
    const uint32_t instance = packet.instance[std::countr_zero(group.lanes)];
    const Surface& s = path.frame.surfaces[instance];
    loadCorners(*s.mesh, group);
    if (s.mesh->shape == scene::Shape::triangles) {
      locateOnTriangles(path.metric, s, group, from, rows);
      if (path.filters) footprintsOf(s, group, packet, from, cones, steps), group.steps = steps;
    } else {
      group.steps = nullptr;
      bouncedSolids(path, s, packet, group, from, rows);
      finishSolids(path.metric, s, rows);
      if (s.mesh->shape == scene::Shape::sticks) placeOnSticks(s, rows.point, group);
    }
    colorVertices(path, path.bounced(), instance, group, from, rows, x, y, out);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
