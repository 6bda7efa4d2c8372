#include "gl/draws/sampled_surfaces.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <limits>

namespace gluray::gl {
namespace {

constexpr uint32_t kSamples = 32;

}  // namespace

std::vector<Triangle> sampleTriangles(const CapturedVertices& captured) {
  const std::vector<uint32_t> corners = triangulate(captured);
  const size_t step = std::max<size_t>(corners.size() / 3 / kSamples, 1) * 3;
  const auto position = [&](uint32_t i) {
    const float* v = captured.vertex(i);
    return glm::vec3(v[0], v[1], v[2]);
  };
  std::vector<Triangle> triangles;
  for (size_t at = 0; at + 2 < corners.size(); at += step)
    triangles.push_back({position(corners[at]), position(corners[at + 1]), position(corners[at + 2])});
  return triangles;
}

std::vector<Triangle> sampleTriangles(const scene::Mesh& mesh) {
  std::vector<Triangle> triangles;
  const uint32_t step = std::max(mesh.triangleCount / kSamples, 1u);
  for (uint32_t t = 0; t < mesh.triangleCount; t += step)
    triangles.push_back({mesh.position(mesh.corner(t, 0)), mesh.position(mesh.corner(t, 1)),
                         mesh.position(mesh.corner(t, 2))});
  return triangles;
}

Hash128 hashOf(const glm::dmat4& matrix) {
  const glm::dmat4 m = matrix + 0.0;  // -0 is 0
  return hashBytes(glm::value_ptr(m), sizeof m);
}

void SampledSurfaces::add(const glm::dmat4& eyeFromObject, std::vector<Triangle> triangles,
                          const DepthStamp& at, bool pushedBack) {
  if (triangles.empty()) return;
  constexpr float kFar = std::numeric_limits<float>::max();
  Box box{glm::vec3(kFar), glm::vec3(-kFar), pushedBack, at};
  for (const Triangle& t : triangles)
    for (const glm::vec3& p : t) box.lower = glm::min(box.lower, p), box.upper = glm::max(box.upper, p);
  Group& group = groups_[hashOf(eyeFromObject)];
  group.triangles.push_back(std::move(triangles));
  group.boxes.push_back(box);
  ++size_;
}

bool SampledSurfaces::Box::meetsBoxOf(const scene::Mesh& mesh) const {
  return glm::all(glm::lessThanEqual(lower, mesh.upper)) && glm::all(glm::lessThanEqual(mesh.lower, upper));
}

}  // namespace gluray::gl
