#include "render/local/lighting_space.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using scene::FragmentShading;

bool usesNormalMatrix(const scene::Instance& instance, const scene::Shading& shading) {
  return instance.mesh && instance.mesh->shape == scene::Shape::triangles &&
         shading.fragment.normals != FragmentShading::Normals::triangles;
}

/// Without its size.
glm::dmat3 turnOf(const glm::dmat3& m) {
  const double size = std::cbrt(std::abs(glm::determinant(m)));
  return size > 0 ? m * (1 / size) : m;
}

/// Whether normals are turned as points are.
bool agree(const glm::dmat3& points, const glm::dmat3& normals) {
  constexpr double kRounded = 1e-3;
  const glm::dmat3 a = turnOf(glm::transpose(glm::inverse(points))), b = turnOf(normals);
  for (int c = 0; c < 3; ++c)
    if (!(glm::length(a[c] - b[c]) <= kRounded * glm::length(a[c]))) return false;
  return true;
}

/// What each axis of object space is multiplied by, so that points are turned as normals are: their sizes,
/// relative to each other; exactly 1 where they are equal up to rounding.
glm::dvec3 scalesOfAxes(const glm::dmat3& points, const glm::dmat3& normals) {
  constexpr double kRounded = 1e-4;
  const glm::dmat3 turned = glm::transpose(glm::inverse(normals));
  glm::dvec3 scales(1);
  for (int c = 0; c < 3; ++c) scales[c] = glm::length(turned[c]) / glm::length(points[c]);
  scales /= std::cbrt(scales.x * scales.y * scales.z);
  const glm::dvec3 off = glm::abs(scales - 1.0);
  const double most = std::max(off.x, std::max(off.y, off.z));
  return most > kRounded && std::isfinite(most) ? scales : glm::dvec3(1);
}

glm::dmat3 scaledAxes(const glm::dmat3& m, const glm::dvec3& scales) {
  return {m[0] * scales.x, m[1] * scales.y, m[2] * scales.z};
}

/// A point from which everything is seen as the viewer sees it, object space: not so far away that floats
/// lose what is near.
glm::dvec3 viewpoint(const scene::Instance& instance, const Viewer& away) {
  constexpr double kNearlyInfinite = 1e3;  // in diagonals of the mesh
  const glm::dmat4 objectFromEye = glm::inverse(instance.eyeFromObject);
  const glm::dvec3 lower(instance.mesh->lower), upper(instance.mesh->upper), middle = 0.5 * (lower + upper);
  const double reach = kNearlyInfinite * glm::length(upper - lower);
  if (away.w != 0) {
    const glm::dvec3 viewer(objectFromEye * glm::dvec4(glm::dvec3(away) / away.w, 1));
    if (glm::length(viewer - middle) < reach || reach == 0) return viewer;
  }
  // Where the mesh is, the direction away from the viewer is the same everywhere.
  const glm::dvec3 eye(instance.eyeFromObject * glm::dvec4(middle, 1));
  const glm::dvec3 direction = glm::dmat3(objectFromEye) * (glm::dvec3(away) - away.w * eye);
  return middle - glm::normalize(direction) * reach;
}

bool isFinite(const glm::dmat4& m) {
  double sum = 0;
  for (int c = 0; c < 4; ++c) sum += glm::dot(m[c], glm::dvec4(1));
  return std::isfinite(sum);
}

}  // namespace

glm::dmat4 lightingFromObject(const scene::Instance& instance, const scene::Shading& shading,
                              const Viewer& away) {
  const glm::dmat4 given(instance.lightingFromObject);
  if (!usesNormalMatrix(instance, shading)) return given;
  const glm::dmat3 normals(instance.normalMatrix);
  if (given != glm::dmat4(1)) return given;
  const glm::dvec3 scales = scalesOfAxes(glm::dmat3(instance.eyeFromObject), normals);
  if (scales == glm::dvec3(1) && agree(glm::dmat3(given), normals)) return given;
  glm::dmat4 found(scaledAxes(glm::transpose(glm::inverse(normals)), 1.0 / scales));
  found[3] = glm::dvec4(-(glm::dmat3(found) * viewpoint(instance, away)), 1);
  return isFinite(found) ? found : given;
}

glm::dmat4 eyeFromLighting(const scene::Instance& instance, const scene::Shading& shading,
                           const Viewer& away) {
  if (shading.fragment.model == FragmentShading::Model::off) return glm::dmat4(1);
  const glm::dmat4 lighting = lightingFromObject(instance, shading, away);
  if (isNearly(instance.eyeFromObject, lighting, 0)) return glm::dmat4(1);
  return instance.eyeFromObject * glm::inverse(lighting);
}

std::optional<glm::dmat3> eyeFromVertexNormal(const scene::Instance& instance,
                                              const scene::Shading& shading) {
  if (shading.fragment.model == FragmentShading::Model::off || !usesNormalMatrix(instance, shading))
    return std::nullopt;
  const glm::dmat3 points(instance.eyeFromObject);
  const glm::dvec3 scales = scalesOfAxes(points, glm::dmat3(instance.normalMatrix));
  if (scales == glm::dvec3(1)) return std::nullopt;
  return glm::transpose(glm::inverse(scaledAxes(points, scales)));
}

bool isNearly(const glm::dmat4& a, const glm::dmat4& b, double reach) {
  constexpr double kRounded = 1e-5;
  for (int c = 0; c < 4; ++c) {
    const double size = glm::length(glm::dvec3(a[c])) + (c == 3 ? reach : 0);
    if (glm::length(glm::dvec3(a[c] - b[c])) > kRounded * size) return false;
  }
  return true;
}

}  // namespace gluray::render
