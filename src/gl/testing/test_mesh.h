// Meshes of separate triangles, for tests of classification.
#pragma once
#include "scene/mesh.h"

#include <memory>
#include <utility>
#include <vector>

namespace gluray::gl::test {

inline scene::MeshPtr meshOf(std::vector<glm::vec3> corners) {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->geometryId = hashBytes(corners.data(), corners.size() * sizeof(glm::vec3));
  mesh->vertexCount = static_cast<uint32_t>(corners.size());
  mesh->triangleCount = mesh->vertexCount / 3;
  mesh->lower = mesh->upper = corners.front();
  for (const glm::vec3& p : corners)
    mesh->lower = glm::min(mesh->lower, p), mesh->upper = glm::max(mesh->upper, p);
  const auto owner = std::make_shared<const std::vector<glm::vec3>>(std::move(corners));
  mesh->positions = {owner, reinterpret_cast<const std::byte*>(owner->data()), sizeof(glm::vec3),
                     scene::Format::float3};
  return mesh;
}

}  // namespace gluray::gl::test
