#include "cluster/pages/paged_mesh.h"

#include <algorithm>
#include <cstring>

namespace gluray::cluster {
namespace {

TriangleArrays arraysOf(const scene::Instance& instance) {
  TriangleArrays arrays = {instance.triangleColors, instance.triangleNormals, instance.triangleEdges};
  for (scene::Attribute& a : arrays)
    if (a) a.data += size_t{instance.triangleOffset} * a.stride;
  return arrays;
}

const scene::Attribute kTriangleNumbers = [] {
  scene::Attribute a;
  a.format = scene::Format::uint32;
  return a;
}();

void copyElements(const scene::Attribute& from, const std::vector<uint32_t>& which,
                  const scene::Attribute& to) {
  auto* out = const_cast<std::byte*>(to.data);
  const size_t size = to.stride;
  for (const uint32_t element : which) {
    std::memcpy(out, from.data + size_t{element} * from.stride, size);
    out += size;
  }
}

}  // namespace

bool PagedMesh::fits(const scene::Instance& instance, const scene::Shading& shading) {
  const bool edged = instance.triangleEdges || shading.fragment.edges;
  return instance.mesh->shape == scene::Shape::triangles && !edged && !instance.ground;
}

Hash128 PagedMesh::idOf(const scene::Instance& instance, uint32_t mostTriangles, int owner,
                        ArrayNames& names) {
  const scene::Mesh& mesh = *instance.mesh;
  const std::array<uint32_t, 4> counts = {mostTriangles, static_cast<uint32_t>(owner), mesh.triangleCount,
                                          mesh.opaqueColors};
  Hash128 id = hashBytes(counts.data(), sizeof counts);
  const auto add = [&](const scene::Attribute& a, uint32_t count) {
    id = hashBytes(&a.format, sizeof a.format, id);
    if (!a) return;
    const Hash128 name = names.named(a.owner, a.data, count, a.stride, bytesOf(a.format)).name;
    id = hashBytes(&name, sizeof name, id);
  };
  const TriangleArrays ofTriangles = arraysOf(instance);
  eachArray(*instance.mesh, ofTriangles, add);
  return id;
}

PagedMesh::PagedMesh(const Hash128& id, const scene::Instance& instance, uint32_t mostTriangles, int owner)
    : id_(id),
      mesh_(instance.mesh),
      ofTriangles_(arraysOf(instance)),
      table_(cutIntoPages(*mesh_, mostTriangles)),
      mostMaterial_(mostMaterial()) {
  for (size_t page = 0; page < table_.pages.size(); ++page) meshes_.push_back(named(page, owner));
}

uint32_t PagedMesh::mostMaterial() const {
  uint32_t most = 0;
  for (uint32_t i = 0; mesh_->materials && i < mesh_->vertexCount; ++i) {
    uint32_t material;
    std::memcpy(&material, mesh_->materials.data + size_t{i} * mesh_->materials.stride, sizeof material);
    most = std::max(most, material);
  }
  return most;
}

Hash128 PagedMesh::idOf(size_t page) const {
  const uint64_t number = page;
  return hashBytes(&number, sizeof number, id_);
}

scene::MeshPtr PagedMesh::named(size_t page, int owner) const {
  const PageRange& range = table_.pages[page];
  PageName name{idOf(page), owner, mostMaterial_, {}};
  if (page == 0) name.whole = table_.whole;
  auto residence = std::make_shared<PageResidence>(name);
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->triangleCount = range.count, mesh->vertexCount = range.vertices;
  mesh->lower = range.lower, mesh->upper = range.upper;
  mesh->opaqueColors = mesh_->opaqueColors;
  mesh->texcoordsAbove.resize(mesh_->texcoordsAbove.size());
  std::vector<scene::Format> formats;
  eachArray(*mesh_, ofTriangles_, [&](const scene::Attribute& a, uint32_t) { formats.push_back(a.format); });
  auto next = formats.begin();
  eachArray(*mesh, residence->ofTriangles, [&](scene::Attribute& a, uint32_t) { a.format = *next++; });
  mesh->triangleNumbers = kTriangleNumbers;
  mesh->residence = std::move(residence);
  return mesh;
}

std::vector<std::byte> PagedMesh::content(size_t page) const {
  const PageRange& range = table_.pages[page];
  scene::Mesh to = *meshes_[page];
  TriangleArrays toTriangles = static_cast<const PageResidence&>(*to.residence).ofTriangles;
  std::vector<std::byte> bytes(pageBytes(to, toTriangles));
  layOut(to, toTriangles, {std::shared_ptr<void>(), bytes.data()});

  const auto first = table_.triangles.begin() + static_cast<ptrdiff_t>(range.first);
  const std::vector<uint32_t> triangles(first, first + range.count);
  VertexNumbers numbers(mesh_->indices ? range.count : 1);
  std::vector<uint32_t> soup;
  auto* indices = reinterpret_cast<uint32_t*>(const_cast<std::byte*>(to.indices.data));
  for (const uint32_t t : triangles)
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t vertex = mesh_->corner(t, k);
      if (mesh_->indices)
        *indices++ = numbers.numberOf(vertex);
      else
        soup.push_back(vertex);
    }
  const std::vector<uint32_t>& vertices = mesh_->indices ? numbers.vertices() : soup;
  const auto copy = [&](const scene::Attribute& from, const std::vector<uint32_t>& which,
                        const scene::Attribute& target) {
    if (from) copyElements(from, which, target);
  };
  const scene::Mesh& m = *mesh_;
  copy(m.positions, vertices, to.positions), copy(m.normals, vertices, to.normals);
  copy(m.colors, vertices, to.colors), copy(m.texcoords, vertices, to.texcoords);
  copy(m.secondaryColors, vertices, to.secondaryColors), copy(m.fogCoords, vertices, to.fogCoords);
  copy(m.materials, vertices, to.materials);
  for (size_t i = 0; i < m.texcoordsAbove.size(); ++i)
    copy(m.texcoordsAbove[i], vertices, to.texcoordsAbove[i]);
  for (size_t i = 0; i < ofTriangles_.size(); ++i) copy(ofTriangles_[i], triangles, toTriangles[i]);
  std::memcpy(const_cast<std::byte*>(to.triangleNumbers.data), triangles.data(), triangles.size() * 4);
  return bytes;
}

}  // namespace gluray::cluster
