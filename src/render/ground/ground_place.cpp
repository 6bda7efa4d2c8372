#include "render/ground/ground_place.h"

#include "scene/box_corner.h"
#include "scene/secondary_scene.h"
#include "scene/upward_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::render {
namespace {

struct Box {
  glm::dvec3 lower{std::numeric_limits<double>::infinity()}, upper{-std::numeric_limits<double>::infinity()};
  void add(const glm::dvec3& p, const glm::dvec3& around) {
    lower = glm::min(lower, p - around), upper = glm::max(upper, p + around);
  }
  bool isFinite() const {
    bool finite = true;
    for (int c = 0; c < 3; ++c) finite &= std::isfinite(lower[c]) && std::isfinite(upper[c]);
    return finite;
  }
};

/// The largest radius of figures around the mesh's vertices that does not depend on the camera, in the
/// program's eye space; 0: there is none.
double radiusOf(const scene::Instance& instance) {
  const scene::Mesh& mesh = *instance.mesh;
  const bool known = mesh.shape == scene::Shape::spheres || mesh.shape == scene::Shape::discs ||
                     mesh.shape == scene::Shape::cylinders || mesh.shape == scene::Shape::sticks;
  if (!known) return 0;
  double most = mesh.radii ? 0 : double{std::abs(mesh.radius)};
  for (uint32_t i = 0; mesh.radii && i < mesh.vertexCount; ++i) {
    const double radius = double{std::abs(scene::fetch(mesh.radii, i).x)};
    if (std::isfinite(radius)) most = std::max(most, radius);
  }
  const bool isScaled = instance.impostors.billboards == scene::Impostors::Billboards::square ||
                        mesh.shape == scene::Shape::sticks;
  return isScaled ? most / double{instance.impostors.radiusDivisor} : most;
}

glm::dvec3 axesOf(const glm::dmat4& m) {
  return {glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])), glm::length(glm::dvec3(m[2]))};
}

double stretchOf(const glm::dmat4& m) { return std::cbrt(std::abs(glm::determinant(glm::dmat3(m)))); }

/// Of all instances, in the space of the view's first object. `axes`: lengths of its axes in eye space.
Box boundsOf(const scene::Snapshot& s, const glm::dmat4& viewFromWorld, const glm::dvec3& axes) {
  Box box;
  for (size_t i = 0; i < scene::countAll(s); ++i) {
    const scene::Instance& instance = scene::instanceOf(s, i);
    const scene::Mesh& mesh = *instance.mesh;
    if (mesh.triangleCount == 0 || instance.ground) continue;
    const glm::dmat4 place = viewFromWorld * glm::dmat4(instance.worldFromObject);
    const double radius = radiusOf(instance);
    glm::dvec3 around(0);
    if (radius > 0)
      around = radius / axes *
               stretchOf(instance.eyeFromObject * glm::inverse(glm::dmat4(instance.lightingFromObject)));
    Box own;
    for (int corner = 0; corner < 8; ++corner)
      own.add(glm::dvec3(place * glm::dvec4(scene::boxCorner(mesh.lower, mesh.upper, corner), 1)), around);
    if (own.isFinite()) box.add(own.lower, glm::dvec3(0)), box.add(own.upper, glm::dvec3(0));
  }
  return box;
}

}  // namespace

std::optional<GroundPlace> placeGround(const scene::Snapshot& s) {
  const glm::dmat4 viewFromWorld = s.secondaryScene ? s.secondaryScene->viewFromWorld : glm::dmat4(1);
  const glm::dmat4 worldFromView = glm::inverse(viewFromWorld);
  const glm::dvec3 axes = axesOf(s.eyeFromWorld * worldFromView);
  const Box box = boundsOf(s, viewFromWorld, axes);
  if (!box.isFinite()) return std::nullopt;
  const int up = scene::upwardAxis(s.settings), right = (up + 1) % 3, front = (up + 2) % 3;
  const double diagonal = glm::length(axes * (box.upper - box.lower));
  const double size = double{s.settings.ground.size} * diagonal / 2;
  const double half = std::exp2(std::ceil(std::log2(size / axes[up])));
  if (!(half >= double{std::numeric_limits<float>::min()} && half <= 1e37)) return std::nullopt;
  glm::dmat4 place(0);
  place[0][right] = size / axes[right] / half, place[1][front] = size / axes[front] / half;
  place[2][up] = 1;
  place[3] = glm::dvec4(0.5 * (box.lower + box.upper), 1);
  place[3][up] = box.lower[up] - double{s.settings.ground.offset} * diagonal / axes[up];
  return GroundPlace{worldFromView * place, static_cast<float>(half)};
}

}  // namespace gluray::render
