#include "gl/capture/triangle_samples.h"

#include <algorithm>

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

}  // namespace gluray::gl
