// Small scenes for the tests of accel/, render/ and frame/.
#pragma once
#include "scene/snapshot.h"

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace gluray::test {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// An attribute over a copy of `values`, padded by the readable bytes that positions and indices need.
template <class T>
scene::Attribute makeAttribute(std::vector<T> values, scene::Format format) {
  if (values.empty()) return {};
  const auto stride = static_cast<uint32_t>(sizeof(T));
  values.resize(values.size() + 16 / sizeof(T) + 1);
  const auto owner = std::make_shared<const std::vector<T>>(std::move(values));
  return {owner, reinterpret_cast<const std::byte*>(owner->data()), stride, format};
}

/// Vertex data of a mesh; empty `indices`: triangle soup.
struct MeshData {
  std::vector<glm::vec3> positions, normals;
  std::vector<uint32_t> indices;
  std::vector<glm::vec4> colors, texcoords;
  std::vector<uint32_t> materials;
};

inline std::shared_ptr<scene::Mesh> makeMesh(const MeshData& data) {
  auto mesh = std::make_shared<scene::Mesh>();
  const Hash128 seed = hashBytes(data.positions.data(), data.positions.size() * sizeof(glm::vec3));
  mesh->geometryId = hashBytes(data.indices.data(), data.indices.size() * 4, seed);
  mesh->vertexCount = static_cast<uint32_t>(data.positions.size());
  mesh->triangleCount =
      static_cast<uint32_t>(data.indices.empty() ? data.positions.size() : data.indices.size()) / 3;
  mesh->positions = makeAttribute(data.positions, scene::Format::float3);
  mesh->indices = makeAttribute(data.indices, scene::Format::uint32);
  mesh->normals = makeAttribute(data.normals, scene::Format::float3);
  mesh->colors = makeAttribute(data.colors, scene::Format::float4);
  mesh->texcoords = makeAttribute(data.texcoords, scene::Format::float4);
  mesh->materials = makeAttribute(data.materials, scene::Format::uint32);
  return mesh;
}

/// Two triangles a, b, c and a, c, d, with the winding of the quad a, b, c, d.
inline MeshData quadData(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
  MeshData data;
  data.positions = {a, b, c, d};
  data.indices = {0, 1, 2, 0, 2, 3};
  return data;
}

/// The square [-1, 1]^2 at height z, facing +z.
inline MeshData squareData(float z = 0) { return quadData({-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}); }

/// A soup of small triangles at pseudo-random places in [-1, 1]^2.
inline scene::MeshPtr scatteredTriangles(int count) {
  MeshData data;
  for (int i = 0; i < count; ++i) {
    const float x = std::sin(static_cast<float>(7 * i)), y = std::cos(static_cast<float>(11 * i));
    data.positions.insert(data.positions.end(), {{x, y, 0}, {x + 0.01f, y, 0}, {x, y + 0.01f, 0.01f}});
  }
  return makeMesh(data);
}

/// A parallelogram about `center`.
inline scene::MeshPtr parallelogram(const glm::vec3& center, const glm::vec3& a, const glm::vec3& b) {
  return makeMesh(quadData(center - a - b, center + a - b, center + a + b, center - a + b));
}

/// An unlit snapshot of `size` x `size` pixels with an identity camera (clip = eye = object space) and one
/// white instance per mesh.
inline scene::Snapshot makeSnapshot(const std::vector<scene::MeshPtr>& meshes, int size = 16) {
  scene::Snapshot s;
  s.frame = 1;
  s.camera.clipFromEye[2][2] = -1;
  s.camera.viewport = {0, 0, size, size};
  s.region = {0, 0, size, size};
  s.shadings.resize(1);
  s.settings.threads = 2;
  for (const scene::MeshPtr& mesh : meshes) {
    scene::Instance instance;
    instance.mesh = mesh;
    instance.materials.resize(1);
    s.instances.push_back(instance);
  }
  return s;
}

}  // namespace gluray::test
