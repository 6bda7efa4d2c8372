// How far figures that are so many pixels wide reach in space, for every turn of the camera.
#include "accel/pixel_figure.h"

#include <algorithm>
#include <cmath>

namespace gluray::accel {

FigureReach reachInPixels(const scene::Instance& instance, const scene::Camera& camera) {
  const scene::Mesh& mesh = *instance.mesh;
  const scene::Figures& f = instance.figures;
  const bool tubes = mesh.shape == scene::Shape::tubes;
  const glm::dmat4 lightingFromObject(instance.lightingFromObject);
  const glm::dmat4 clipFromLighting =
      camera.clipFromEye * instance.eyeFromObject * glm::inverse(lightingFromObject);
  const glm::dmat4 lightingFromClip = glm::inverse(clipFromLighting);
  const glm::dvec3 middle(lightingFromObject * glm::dvec4(0.5f * (mesh.lower + mesh.upper), 1));
  double radius = 0;  // of a sphere about all vertices, in lighting space
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner(i & 1 ? mesh.upper.x : mesh.lower.x, i & 2 ? mesh.upper.y : mesh.lower.y,
                            i & 4 ? mesh.upper.z : mesh.lower.z);
    radius = std::max(radius, glm::distance(middle, glm::dvec3(lightingFromObject * glm::dvec4(corner, 1))));
  }
  const glm::dmat4 rows = glm::transpose(clipFromLighting);
  const double farthest =
      std::abs(glm::dot(rows[3], glm::dvec4(middle, 1))) + glm::length(glm::dvec3(rows[3])) * radius;
  // In the window: half a card, and what lines grow by at their ends.
  const glm::dvec2 size(f.size);
  const glm::dvec2 unit(glm::length(glm::dvec3(lightingFromClip[0])),
                        glm::length(glm::dvec3(lightingFromClip[1])));
  const double aside = farthest * std::max(unit.x * size.x, unit.y * size.y) * 0.5;
  const double grown = f.grows ? farthest * std::max(unit.x, unit.y) * glm::length(size) * 0.25 : 0.0;
  // Towards the viewer: most in the middle, where nothing is aside.
  const glm::dvec3 z(lightingFromClip[2]);
  const double scale = 0.5 * std::abs(double{camera.depthFar} - camera.depthNear),
               bulge = (tubes ? 2 : 1) * double{f.bulge};
  double out = 0, moved = 0;
  if (f.parallelView) {
    out = std::abs(bulge * f.bulgeDepth) / scale * glm::length(z);
    moved = std::abs(f.depthBias) / scale * glm::length(z);
  } else {
    const glm::dvec3 viewer = z / lightingFromClip[2].w, depthRow(rows[2]), wRow(rows[3]);
    const double a = glm::dot(depthRow, wRow) / glm::dot(wRow, wRow);
    const double b = rows[2].w - a * rows[3].w;  // NDC depth is a + b/w
    const double away = glm::distance(middle, viewer) + radius;
    out = bulge * away;
    moved = away * farthest * std::abs(f.depthBias) / (scale * std::max(std::abs(b), 1e-30));
  }
  double reach = std::max(aside, out) + 0.05 * std::min(aside, out) + grown + moved;
  FigureReach result;
  const glm::dmat3 inverseRows = glm::transpose(glm::inverse(glm::dmat3(lightingFromObject)));
  // As the camera comes nearer, structures are built anew at every such step, and serve all turns between.
  constexpr double kStepsAnOctave = 4;
  reach = std::exp2(std::ceil(std::log2(reach * (1 + 1e-3)) * kStepsAnOctave) / kStepsAnOctave);
  for (int c = 0; c < 3; ++c) result.perRadius[c] = roundedUp(glm::length(inverseRows[c]) * reach);
  return result;
}

}  // namespace gluray::accel
