#include "render/moving/narrow_lanes.h"

#include "accel/impostors/solid_guess.h"

#include <algorithm>
#include <bit>

namespace gluray::render {
namespace {

/// Widest radius. Normals of wider surfaces hardly differ from pixel to pixel.
constexpr float kWidest = 8;  // pixels

glm::vec3 laneOf(const Row (&rows)[3], int i) { return {rows[0][i], rows[1][i], rows[2][i]}; }

void put(const glm::vec3& v, Row (&rows)[3], int i) { rows[0][i] = v.x, rows[1][i] = v.y, rows[2][i] = v.z; }

/// The point of the line between two points that is nearest to a third one.
glm::vec3 nearest(const glm::vec3 (&end)[2], const glm::vec3& point) {
  const glm::vec3 line = end[1] - end[0];
  const float square = glm::dot(line, line);
  if (!(square > 0)) return end[0];
  return end[0] + std::clamp(glm::dot(point - end[0], line) / square, 0.0f, 1.0f) * line;
}

}  // namespace

void findNarrow(const FrameData& frame, const PixelSpace& space, const ColoredHits& hits,
                const SurfacePoints& points, NarrowLanes& out) {
  out.any = false;
  if (hits.surface.mesh->shape == scene::Shape::triangles) return;
  const accel::PlacedImpostors& placed = frame.world->impostorsOf(hits.instance);
  const glm::mat4 eyeFromLighting(glm::inverse(glm::dmat4(placed.lightingFromEye)));
  std::fill_n(out.radius, kLanes, 0.0f);
  for (uint32_t lanes = hits.group.lanes; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const auto hull = accel::hullOf(placed, hits.group.primitive[i]);
    if (!hull) continue;
    const glm::vec3 end[2] = {glm::vec3(eyeFromLighting * glm::vec4(hull->end[0], 1)),
                              glm::vec3(eyeFromLighting * glm::vec4(hull->end[1], 1))};
    const glm::vec3 point = laneOf(points.eye, i), center = nearest(end, point), line = end[1] - end[0];
    const float depth = glm::dot(glm::vec3(space.depth), point) + space.depth.w;
    const float radius = glm::distance(point, center), length = glm::length(line);
    if (!(radius <= kWidest * (space.pixel + depth * space.perDepth))) continue;
    put(center, out.center, i), put(length > 0 ? line / length : glm::vec3(0), out.axis, i);
    out.radius[i] = radius, out.any = true;
  }
}

}  // namespace gluray::render
