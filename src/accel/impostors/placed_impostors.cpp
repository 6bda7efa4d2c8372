#include "accel/impostors/placed_impostors.h"

#include <algorithm>
#include <cmath>

namespace gluray::accel {
namespace {

float radiusOf(const scene::Mesh& mesh, uint32_t vertex) {
  return mesh.radii ? scene::fetch(mesh.radii, vertex).x : mesh.radius;
}

glm::vec3 axisOf(const scene::Mesh& mesh, uint32_t vertex) {
  return mesh.axes ? glm::vec3(scene::fetch(mesh.axes, vertex)) : glm::vec3(0, 0, 1);
}

/// Half the sides of Billboards::square. The silhouette is wider than the sphere, by an angle whose sine is
/// radius / distance; the square, by the angle of that tangent. So it cuts a little off spheres that are near
/// and far from the middle of the view.
glm::vec2 squareAbout(const glm::vec3& center, float radius, bool parallelView) {
  if (parallelView) return glm::vec2(radius);
  const glm::vec2 distance(std::hypot(center.x, center.z), std::hypot(center.y, center.z));
  glm::vec2 half;
  for (int c = 0; c < 2; ++c) {
    const float cosA = std::clamp(center.z / distance[c], -1.0f, 1.0f);
    const float cosB = distance[c] / std::sqrt(radius * radius + distance[c] * distance[c]);
    const float cosAB = cosA * cosB + std::sqrt((1 - cosA * cosA) * (1 - cosB * cosB));
    constexpr float kMax = 10;
    half[c] = radius * std::min(1 / std::abs(cosAB), kMax);
  }
  return half;
}

}  // namespace

Box boundsOfImpostor(const scene::Mesh& mesh, const ImpostorReach& reach, uint32_t primitive) {
  const uint32_t vertex = mesh.corner(primitive, 0);
  const float radius = radiusOf(mesh, vertex);
  const glm::vec3 center = mesh.position(vertex);
  glm::vec3 half = radius * reach.perRadius;
  if (mesh.shape == scene::Shape::cylinders) {
    const glm::vec3 axis = axisOf(mesh, vertex);
    half += 0.5f * glm::abs(reach.alongAxis * axis) + glm::length(axis) * reach.perLength;
  }
  half += reach.further + 1e-6f * glm::abs(center);
  const glm::vec3 other = mesh.position(mesh.corner(primitive, 1));  // of tubes
  half += 1e-6f * glm::abs(other);
  const Box box{glm::min(center, other) - half, glm::max(center, other) + half};
  const glm::vec3 sum = box.lower + box.upper + center + other;
  if (!std::isfinite(sum.x + sum.y + sum.z) || !(radius > 0))
    return {glm::vec3(INFINITY), glm::vec3(-INFINITY)};
  return box;
}

PlacedImpostors::PlacedImpostors(const scene::Instance& instance, const scene::Camera& camera)
    : mesh(instance.mesh),
      look(instance.impostors),
      lightingFromObject(instance.lightingFromObject),
      clipFromObject(camera.clipFromEye * instance.eyeFromObject) {
  lightingFromEye = glm::mat4(glm::dmat4(lightingFromObject) * glm::inverse(instance.eyeFromObject));
  const glm::dmat4 rows = glm::transpose(camera.clipFromEye);
  clipZ = rows[2], clipW = rows[3];
  windowHalf = 0.5 * glm::dvec2(camera.viewport.z, camera.viewport.w);
  windowCenter = glm::dvec2(camera.viewport.x, camera.viewport.y) + windowHalf;
  depthScale = 0.5 * (double{camera.depthFar} - camera.depthNear);
  depthOffset = 0.5 * (double{camera.depthFar} + camera.depthNear);
  if (look.hemispheres) {
    const glm::dmat4 rowsOfLighting =
        glm::transpose(camera.clipFromEye * glm::inverse(glm::dmat4(lightingFromEye)));
    lightingNear = glm::vec4(rowsOfLighting[2] + rowsOfLighting[3]);
  }
  if (!scene::isSizedInPixels(mesh->shape) && !scene::isSolid(mesh->shape)) return;
  const glm::dmat4 lightingFromClip = glm::dmat4(lightingFromEye) * glm::inverse(camera.clipFromEye);
  const double x = look.size.x * glm::length(glm::dvec3(lightingFromClip[0])),
               y = look.size.y * glm::length(glm::dvec3(lightingFromClip[1]));
  const double half = 0.5 * std::sqrt(x * y);
  halfWidthPerW = std::isfinite(half) ? half : 0;
  const glm::dmat4 objectRows = glm::transpose(clipFromObject);
  objectW = glm::vec4(objectRows[3]), objectNear = glm::vec4(objectRows[2] + objectRows[3]);
  viewer = glm::vec4(-lightingFromClip[2]);
  boundRadius();
}

void PlacedImpostors::boundRadius() {
  constexpr float kRounding = 4e-6f;
  const glm::dmat3 linear{glm::mat3(lightingFromObject)};
  const auto stretch = static_cast<float>(largestStretch(glm::inverse(linear)));
  float largest = 0, offset = 0;
  for (int r = 0; r < 3; ++r) {
    offset += std::abs(lightingFromObject[3][r]);
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(lightingFromObject[c][r]));
  }
  objectError = kRounding * stretch * offset, objectRounding = kRounding * (1 + 3 * stretch * largest);
  objectRadius = look.radius > 0 ? glm::vec4(0, 0, 0, look.radius * stretch)
                                 : objectW * (static_cast<float>(halfWidthPerW) * stretch);
}

bool Ball::make(const PlacedImpostors& placed, uint32_t primitive, Ball& ball) {
  const scene::Mesh& mesh = *placed.mesh;
  const uint32_t vertex = mesh.corner(primitive, 0);
  const glm::vec4 position(mesh.position(vertex), 1);
  for (const glm::vec4& plane : placed.look.centerPlanes)
    if (glm::dot(plane, position) < 0) return false;
  ball.center = scene::impostorCenter(placed.lightingFromObject, position);
  ball.radius = radiusOf(mesh, vertex) / placed.look.radiusDivisor;
  const glm::vec4 nearest(ball.center + glm::vec3(0, 0, ball.radius), 1);
  return !placed.look.hemispheres || glm::dot(placed.lightingNear, nearest) > 0;
}

bool Impostor::make(const PlacedImpostors& placed, uint32_t primitive, Impostor& f) {
  const scene::Mesh& mesh = *placed.mesh;
  const uint32_t vertex = mesh.corner(primitive, 0);
  Ball ball;
  if (!Ball::make(placed, primitive, ball)) return false;
  f.shape = mesh.shape;
  f.billboards = placed.look.billboards;
  f.parallelView = placed.look.parallelView;
  f.inside = placed.look.inside;
  f.hemisphere = placed.look.hemispheres;
  f.gaussian = placed.look.gaussian;
  f.center = ball.center, f.radius = ball.radius;
  f.cardRadius = radiusOf(mesh, vertex);
  f.toViewer = f.parallelView ? glm::vec3(0, 0, 1) : glm::normalize(-f.center);
  if (f.billboards == scene::Impostors::Billboards::square) {
    f.toViewer = {0, 0, 1}, f.right = {1, 0, 0}, f.up = {0, 1, 0};
    f.square = squareAbout(f.center, f.radius, f.parallelView || f.hemisphere);
  } else if (mesh.shape == scene::Shape::cylinders) {
    const glm::vec3 axis = axisOf(mesh, vertex);
    f.halfLength = 0.5f * glm::length(axis);
    f.axis = placed.look.axisMatrix * glm::normalize(axis);
    if (f.axis.z < 0) f.axis = -f.axis;
    const bool endOn = std::abs(glm::dot(f.toViewer, f.axis)) == 1;
    f.right = glm::normalize(endOn ? glm::cross(glm::vec3(0, 1, 0), f.axis) : glm::cross(f.axis, f.toViewer));
    f.up = endOn ? glm::cross(f.right, f.axis) : glm::cross(f.axis, f.right);
  } else if (f.parallelView) {
    f.right = {1, 0, 0}, f.up = {0, 1, 0};
  } else {
    f.up = glm::normalize(glm::cross(f.toViewer, glm::vec3(1, 0, 0)));
    f.right = glm::cross(f.up, f.toViewer);
  }
  return true;
}

}  // namespace gluray::accel
