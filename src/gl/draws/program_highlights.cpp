// Highlights of programs that interpolate the vertices' directions to the viewer
// (FamilyLights::viewerAtVertices).
#include "gl/draws/program_draws.h"

#include <algorithm>
#include <cmath>

namespace gluray::gl {
namespace {

/// Upper bound of the factor by which the matrix stretches.
double stretchOf(const glm::dmat3& m) {
  double most = 0, sum = 0, skew = 0;
  for (int c = 0; c < 3; ++c) {
    most = std::max(most, glm::length(m[c])), sum += glm::dot(m[c], m[c]);
    skew = std::max(skew, std::abs(glm::dot(m[c], m[(c + 1) % 3])));
  }
  return skew <= 1e-6 * sum ? most : std::sqrt(sum);  // of columns at right angles, the longest one
}

/// Lower bound of the distance of the mesh's points from the origin of the space to which the matrix leads.
double distanceOf(const scene::Mesh& mesh, const glm::dmat4& m) {
  const glm::dvec3 half = 0.5 * (glm::dvec3(mesh.upper) - glm::dvec3(mesh.lower)),
                   middle = 0.5 * (glm::dvec3(mesh.upper) + glm::dvec3(mesh.lower));
  glm::dvec3 reach(0);
  for (int c = 0; c < 3; ++c) reach += glm::abs(glm::dvec3(m[c])) * half[c];
  const glm::dvec3 away = glm::abs(glm::dvec3(m * glm::dvec4(middle, 1))) - reach;
  return glm::length(glm::max(away, glm::dvec3(0)));
}

/// Largest change of a highlight when its half vector turns by a small angle: the steepest slope of a power
/// of the cosine.
double changeOf(const scene::FragmentLight& light, double angle) {
  constexpr double kSteepest = 0.607;  // exp(-1/2), times the root of the exponent
  const float most = std::max({light.highlight.r, light.highlight.g, light.highlight.b, 0.0f});
  return kSteepest * std::sqrt(std::max(1.0f, light.shininess)) * angle * most;
}

}  // namespace

bool ProgramDraws::movesHighlights(const scene::Mesh& mesh) const {
  const ProgramState& program = p_.shadow.program();
  const scene::FragmentShading& f = program.shading.fragment;
  if (!program.known->family->lights.viewerAtVertices || f.infiniteViewer || mesh.triangleCount == 0)
    return false;
  const double distance = distanceOf(mesh, *program.eyeFromObject),
               edge = stretchOf(glm::dmat3(*program.eyeFromObject)) * p_.surfaces.precision.longestEdge(mesh);
  // The interpolated direction differs from that of the point by the covariance of the corners' directions
  // and relative distances, each of which varies by at most half its range; the half vector turns by half of
  // that.
  const double angle = 0.5 * (edge / distance) * (edge / distance) / 8;
  constexpr double kMost = 0.5 / 255;
  return std::ranges::any_of(f.lights, [&](const scene::FragmentLight& light) {
    return light.highlight != glm::vec3(0) && !(changeOf(light, angle) <= kMost);
  });
}

}  // namespace gluray::gl
