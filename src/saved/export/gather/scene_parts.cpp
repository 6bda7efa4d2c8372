#include "saved/export/gather/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

namespace gluray::saved {
namespace {

struct MovePoint {
  glm::dmat4 m;
  void operator()(const glm::vec3* in, glm::vec3* out) const {
    const glm::dvec4 p = m * glm::dvec4(*in, 1);
    *out = glm::vec3(glm::dvec3(p) / p.w);
  }
};

struct MoveDirection {
  glm::dmat3 m;
  void operator()(const glm::vec3* in, glm::vec3* out) const {
    const glm::dvec3 v = m * glm::dvec3(*in);
    const double length = glm::length(v);
    *out = length > 0 ? glm::vec3(v / length) : *in;
  }
};

struct MoveTangent {
  glm::dmat3 m;
  float side;  // of the bitangent
  void operator()(const glm::vec4* in, glm::vec4* out) const {
    glm::vec3 moved;
    const glm::vec3 tangent(*in);
    MoveDirection{m}(&tangent, &moved);
    *out = glm::vec4(moved, in->w * side);
  }
};

/// Keeps what is used, in its order. Returns the new numbers.
template <class T>
std::vector<size_t> keepUsed(std::vector<T>& all, const std::set<size_t>& used) {
  std::vector<size_t> numbers(all.size());
  std::vector<T> kept;
  for (const size_t i : used) {
    numbers[i] = kept.size();
    kept.push_back(std::move(all[i]));
  }
  all = std::move(kept);
  return numbers;
}

size_t hashOf(const glm::vec4& color) {
  return std::hash<std::string_view>()({reinterpret_cast<const char*>(&color), sizeof color});
}

}  // namespace

SourcePtr SceneParts::source(const Key& key, const std::function<SourcePtr()>& make) {
  const auto found = sources_.find(key);
  return found != sources_.end() ? found->second : sources_.emplace(key, make()).first->second;
}

CornersPtr SceneParts::corners(const scene::MeshPtr& mesh, const CornersPtr& made) {
  return corners_.emplace(mesh.get(), made).first->second;
}

const Extent& SceneParts::extent(const SourcePtr& source) {
  const auto found = extents_.find(source);
  return found != extents_.end() ? found->second : extents_.emplace(source, extentOf(*source)).first->second;
}

int SceneParts::texture(const ExportedTexture& texture) {
  const auto found = std::find(scene_.textures.begin(), scene_.textures.end(), texture);
  const auto index = found - scene_.textures.begin();
  if (found == scene_.textures.end()) scene_.textures.push_back(texture);
  return static_cast<int>(index);
}

size_t SceneParts::material(const ExportedMaterial& material) {
  const size_t hash = hashOf(material.color);
  for (auto [at, end] = materials_.equal_range(hash); at != end; ++at)
    if (scene_.materials[at->second] == material) return at->second;
  scene_.materials.push_back(material);
  return materials_.emplace(hash, scene_.materials.size() - 1)->second;
}

size_t SceneParts::mesh(ExportedMesh mesh) {
  const MeshKey key(mesh.positions.get(), mesh.indices.get(), mesh.normals.get(), mesh.tangents.get(),
                    mesh.colors.get(), mesh.texcoords[0].get(), mesh.texcoords[1].get(), mesh.material,
                    mesh.mode);
  const auto [at, fresh] = meshes_.emplace(key, scene_.meshes.size());
  if (!fresh) return at->second;
  const Extent& extent = this->extent(mesh.positions);
  mesh.lower = extent.lower, mesh.upper = extent.upper;
  scene_.meshes.push_back(std::move(mesh));
  return at->second;
}

void dropUnused(ExportedScene& scene) {
  std::set<size_t> materials, textures;
  for (const ExportedMesh& mesh : scene.meshes) materials.insert(mesh.material);
  const std::vector<size_t> material = keepUsed(scene.materials, materials);
  for (ExportedMesh& mesh : scene.meshes) mesh.material = material[mesh.material];
  const auto eachUse = [&](const auto& visit) {
    for (ExportedMaterial& m : scene.materials)
      for (TextureUse* use : {&m.base, &m.metallicRoughness, &m.normal, &m.occlusion, &m.emissionMap})
        if (*use) visit(*use);
  };
  eachUse([&](const TextureUse& use) { textures.insert(static_cast<size_t>(use.texture)); });
  const std::vector<size_t> texture = keepUsed(scene.textures, textures);
  eachUse(
      [&](TextureUse& use) { use.texture = static_cast<int>(texture[static_cast<size_t>(use.texture)]); });
}

bool isDecomposable(const glm::dmat4& m) {
  constexpr double kSquare = 1e-5, kLargest = 1e30;  // readers keep floats
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!(std::abs(m[c][r]) <= kLargest)) return false;
  if (m[0].w != 0 || m[1].w != 0 || m[2].w != 0 || m[3].w != 1) return false;
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
  const double lx = glm::length(x), ly = glm::length(y), lz = glm::length(z);
  const auto square = [](double cosine, double a, double b) { return std::abs(cosine) <= kSquare * a * b; };
  return lx > 0 && ly > 0 && lz > 0 && square(glm::dot(x, y), lx, ly) && square(glm::dot(y, z), ly, lz) &&
         square(glm::dot(z, x), lz, lx);
}

ExportedMesh moved(const ExportedMesh& mesh, const glm::dmat4& m) {
  ExportedMesh out = mesh;
  out.positions = changedArray<glm::vec3, glm::vec3>(mesh.positions, Element::float3, MovePoint{m});
  const glm::dmat3 linear(m);
  const bool mirrored = glm::determinant(linear) < 0;
  if (mirrored && mesh.mode == MeshMode::triangles)
    out.indices = reversedIndices(mesh.indices, mesh.elementCount());
  if (mesh.normals)
    out.normals = changedArray<glm::vec3, glm::vec3>(mesh.normals, Element::float3,
                                                     MoveDirection{glm::transpose(glm::inverse(linear))});
  if (mesh.tangents)
    out.tangents = changedArray<glm::vec4, glm::vec4>(mesh.tangents, Element::float4,
                                                      MoveTangent{linear, mirrored ? -1.0f : 1.0f});
  return out;
}

}  // namespace gluray::saved
