#include "bench/light/lines.h"

#include "bench/paper/paper_data.h"

#include <memory>

namespace gluray::bench {

scene::MeshPtr fieldLines(int count) {
  constexpr double kStep = 3;
  constexpr int kPieces = 60;
  auto points = std::make_shared<std::vector<glm::vec3>>();
  for (const Line& line : starLines(count, kStep, kPieces))
    for (size_t i = 1; i < line.size(); ++i)
      for (const Point& p : {line[i - 1], line[i]}) points->emplace_back(p[0], p[1], p[2]);
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->shape = scene::Shape::capsules;
  mesh->geometryId = {2, points->size()};
  mesh->vertexCount = static_cast<uint32_t>(points->size()), mesh->triangleCount = mesh->vertexCount / 2;
  mesh->lower = glm::vec3(1e30f), mesh->upper = glm::vec3(-1e30f);
  for (const glm::vec3& p : *points)
    mesh->lower = glm::min(mesh->lower, p), mesh->upper = glm::max(mesh->upper, p);
  mesh->positions = {points, reinterpret_cast<const std::byte*>(points->data()), sizeof(glm::vec3),
                     scene::Format::float3};
  return mesh;
}

}  // namespace gluray::bench
