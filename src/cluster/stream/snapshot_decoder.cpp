#include "cluster/stream/snapshot_decoder.h"

#include "cluster/stream/archive.h"
#include "cluster/stream/mesh_formats.h"
#include "cluster/stream/settings_codec.h"
#include "cluster/stream/snapshot_checks.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <initializer_list>
#include <utility>

namespace gluray::cluster {
namespace {

using scene::Format;
using Formats = std::initializer_list<Format>;

constexpr size_t kMaxUnits = scene::kTextureUnits;

class Decoding : public ReadArchive<Decoding> {
 public:
  Decoding(std::span<const std::byte> message, const FindArray& arrays, PageSource* pages,
           DecodedParts& parts)
      : ReadArchive(message), arrays_(arrays), pages_(pages), parts_(parts) {}
  using ReadArchive::value;

  void value(scene::MeshPtr& mesh);
  void value(scene::Instance& instance);
  void value(std::shared_ptr<const scene::TextureImage>& image);
  void value(Settings& settings) { settings = readSettings(in_); }
  bool atEnd() const { return in_.left() == 0; }

 private:
  /// Absent, or of one of the formats and of `count` elements.
  scene::Attribute attribute(uint32_t count, Formats formats);
  Array array(size_t bytes);
  scene::MeshPtr readMesh(DecodedParts::Mesh& made);
  scene::MeshPtr readPage(DecodedParts::Mesh& made);
  PageName readPageName();
  /// The mesh of this identity; null: it is new.
  scene::MeshPtr known(DecodedParts::Mesh& made) const;
  void readAttributes(scene::Mesh& mesh);
  void checkInstance(const scene::Instance& i) const;
  void readGrid(scene::TexelGrid& grid);
  /// Mixes what identifies a mesh or an image: the names of its arrays and `bytes` of the message.
  void identify(const void* bytes, size_t count) { identity_ = hashBytes(bytes, count, identity_); }

  const FindArray& arrays_;
  PageSource* const pages_;
  DecodedParts& parts_;
  Hash128 identity_;  // of the part that is being read
  std::vector<DecodedParts::Mesh> meshes_;
  std::vector<scene::MeshPtr> kept_;
  std::vector<std::shared_ptr<const scene::TextureImage>> images_;
};

Array Decoding::array(size_t bytes) {
  const auto name = in_.get<Hash128>();
  identify(&name, sizeof name);
  Array found = arrays_(name);
  if (!found.owner) throw Malformed("an array is not known");
  if (found.bytes.size() != bytes) throw Malformed("an array has another size");
  return found;
}

scene::Attribute Decoding::attribute(uint32_t count, Formats formats) {
  scene::Attribute a;
  (*this)(a.format);
  identify(&a.format, sizeof a.format);
  if (!a) return a;
  checkFormat(a, formats);
  const uint32_t element = bytesOf(a.format);
  const Array found = array(size_t{count} * element);
  a.owner = found.owner, a.data = found.bytes.data(), a.stride = element;
  return a;
}

void Decoding::readAttributes(scene::Mesh& mesh) {
  const uint32_t count = mesh.vertexCount;
  mesh.radii = attribute(count, {Format::float1});
  mesh.axes = attribute(count, {Format::float3});
  mesh.ends = attribute(count, {Format::uint32});
  mesh.normals = attribute(count, {Format::float3});
  mesh.colors = attribute(count, kColorFormats);
  mesh.texcoords = attribute(count, kTexcoordFormats);
  mesh.secondaryColors = attribute(count, {Format::float3, Format::float4});
  mesh.fogCoords = attribute(count, {Format::float1});
  mesh.materials = attribute(count, {Format::uint32});
  const size_t above = in_.count(1);
  if (above >= kMaxUnits) throw Malformed("too many texture units");
  for (size_t i = 0; i < above; ++i) mesh.texcoordsAbove.push_back(attribute(count, kTexcoordFormats));
}

scene::MeshPtr Decoding::readMesh(DecodedParts::Mesh& made) {
  identity_ = {};
  bool isPage = false;
  (*this)(isPage);
  if (isPage) return readPage(made);
  auto read = std::make_shared<scene::Mesh>();
  scene::Mesh& mesh = *read;
  (*this)(mesh.shape, mesh.triangleCount, mesh.vertexCount, mesh.radius, mesh.lower, mesh.upper,
          mesh.opaqueColors);
  const uint64_t corners = uint64_t{mesh.triangleCount} * scene::cornersOf(mesh.shape);
  if (corners > UINT32_MAX) throw Malformed("a mesh is too large");
  const std::array<uint32_t, 3> shape = {static_cast<uint32_t>(mesh.shape), mesh.triangleCount,
                                         mesh.vertexCount};
  identify(shape.data(), sizeof shape);
  mesh.positions = attribute(mesh.vertexCount, {Format::float3});
  mesh.indices = attribute(static_cast<uint32_t>(corners), {Format::uint32});
  if (!mesh.positions) throw Malformed("a mesh has no positions");
  mesh.geometryId = identity_;
  readAttributes(mesh);
  const std::array<float, 8> rest = {
      mesh.radius,  mesh.lower.x, mesh.lower.y, mesh.lower.z,
      mesh.upper.x, mesh.upper.y, mesh.upper.z, mesh.opaqueColors ? 1.0f : 0.0f};
  identify(rest.data(), sizeof rest);
  if (scene::MeshPtr same = known(made)) return same;
  const bool inside =
      mesh.indices ? corners == 0 || largest(mesh.indices, static_cast<uint32_t>(corners)) < mesh.vertexCount
                   : corners <= mesh.vertexCount;
  if (!inside) throw Malformed("a triangle has a vertex that does not exist");
  made.materials = mesh.materials && mesh.vertexCount > 0 ? largest(mesh.materials, mesh.vertexCount) : 0;
  made.mesh = read;
  parts_.meshes[identity_] = made;
  return read;
}

scene::MeshPtr Decoding::known(DecodedParts::Mesh& made) const {
  const auto found = parts_.meshes.find(identity_);
  scene::MeshPtr same = found == parts_.meshes.end() ? nullptr : found->second.mesh.lock();
  if (same) made = found->second;
  return same;
}

PageName Decoding::readPageName() {
  PageName name;
  bool isFirst = false;
  name.id = in_.get<Hash128>();
  (*this)(name.owner, name.mostMaterial, isFirst);
  if (isFirst) name.whole = in_.get<scene::Residence::Whole>();
  return name;
}

scene::MeshPtr Decoding::readPage(DecodedParts::Mesh& made) {
  if (!pages_) throw Malformed("there are no pages here");
  auto read = std::make_shared<scene::Mesh>();
  scene::Mesh& mesh = *read;
  (*this)(mesh.triangleCount, mesh.vertexCount, mesh.lower, mesh.upper, mesh.opaqueColors);
  constexpr uint32_t kMax = 1 << 26;  // far above what pages have, far below what overflows
  if (mesh.triangleCount > kMax || mesh.vertexCount > 3 * kMax) throw Malformed("a page is too large");
  const PageName name = readPageName();
  const size_t above = in_.count(1);
  if (above >= kMaxUnits) throw Malformed("too many texture units");
  mesh.texcoordsAbove.resize(above);
  TriangleArrays ofTriangles;
  identify(&name.id, sizeof name.id);
  eachArray(mesh, ofTriangles, [&](scene::Attribute& a, uint32_t) {
    (*this)(a.format);
    identify(&a.format, sizeof a.format);
  });
  checkPageFormats(mesh, ofTriangles);
  const std::array<uint32_t, 4> counts = {mesh.triangleCount, mesh.vertexCount, name.mostMaterial,
                                          static_cast<uint32_t>(name.owner)};
  const std::array<glm::vec3, 2> bounds = {mesh.lower, mesh.upper};
  identify(counts.data(), sizeof counts), identify(bounds.data(), sizeof bounds);
  if (scene::MeshPtr same = known(made)) return same;
  mesh.geometryId = identity_;
  const PageSource::Made page = pages_->make(identity_, name, pageBytes(mesh, ofTriangles));
  layOut(mesh, ofTriangles, page.memory);
  page.page->ofTriangles = ofTriangles;
  pages_->limit(*page.page, {mesh.indices, mesh.materials, 3 * mesh.triangleCount, mesh.vertexCount});
  mesh.residence = page.page;
  made.materials = name.mostMaterial, made.mesh = read;
  parts_.meshes[identity_] = made;
  return read;
}

void Decoding::value(scene::MeshPtr& mesh) {
  const auto index = in_.get<uint32_t>();
  if (index > kept_.size()) throw Malformed("there is no such mesh");
  if (index == kept_.size()) {
    DecodedParts::Mesh made;
    scene::MeshPtr read = readMesh(made);
    kept_.push_back(std::move(read)), meshes_.push_back(std::move(made));
  }
  mesh = kept_[index];
}

void Decoding::value(scene::Instance& i) {
  auto& [mesh, eyeFromObject, worldFromObject, shading, order, object, color, normal, secondaryColor,
         fogCoord, texcoord, texcoordsAbove, materials, lightingFromObject, normalMatrix, triangleColors,
         triangleNormals, triangleEdges, triangleOffset, impostors, cull, frontFaceCcw, clipPlanes, ground] =
      i;
  (*this)(mesh, eyeFromObject, worldFromObject, shading, order, object, color, normal, secondaryColor,
          fogCoord, texcoord, texcoordsAbove, materials, lightingFromObject, normalMatrix, impostors, cull,
          frontFaceCcw, clipPlanes, ground);
  triangleOffset = 0;
  if (mesh->residence) {
    const TriangleArrays& arrays = static_cast<const PageResidence&>(*mesh->residence).ofTriangles;
    triangleColors = arrays[0], triangleNormals = arrays[1], triangleEdges = arrays[2];
    return checkInstance(i);
  }
  triangleColors = attribute(mesh->triangleCount, {Format::float4, Format::unorm8x4});
  triangleNormals = attribute(mesh->triangleCount, {Format::float3, Format::float4});
  triangleEdges = attribute(mesh->triangleCount, {Format::bits8});
  checkInstance(i);
}

void Decoding::checkInstance(const scene::Instance& i) const {
  const auto known = std::find(kept_.begin(), kept_.end(), i.mesh) - kept_.begin();
  if (i.materials.size() <= meshes_[static_cast<size_t>(known)].materials)
    throw Malformed("a material does not exist");
  if (i.texcoordsAbove.size() >= kMaxUnits) throw Malformed("too many texture units");
}

void Decoding::readGrid(scene::TexelGrid& grid) {
  bool isFloats = false;
  (*this)(grid.width, grid.height, grid.depth, isFloats);
  const std::array<int, 4> shape = {grid.width, grid.height, grid.depth, isFloats};
  identify(shape.data(), sizeof shape);
  constexpr int kMax = 1 << 16;
  if (std::min({grid.width, grid.height, grid.depth}) < 0 ||
      std::max({grid.width, grid.height, grid.depth}) > kMax)
    throw Malformed("an image has no such size");
  const size_t count =
      static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height) * static_cast<size_t>(grid.depth);
  const Array found = array(count * (isFloats ? sizeof(glm::vec4) : sizeof(uint32_t)));
  if (count == 0) return;
  isFloats ? grid.floats.resize(count) : grid.texels.resize(count);
  std::memcpy(isFloats ? static_cast<void*>(grid.floats.data()) : grid.texels.data(), found.bytes.data(),
              found.bytes.size());
}

void Decoding::value(std::shared_ptr<const scene::TextureImage>& image) {
  const auto index = in_.get<uint32_t>();
  if (index > images_.size()) throw Malformed("there is no such image");
  if (index < images_.size()) {
    image = images_[index];
    return;
  }
  bool exists = false;
  (*this)(exists);
  if (exists) {
    identity_ = {};
    auto read = std::make_shared<scene::TextureImage>();
    (*this)(read->baseFormat, read->opaque);
    const std::array<int, 2> kind = {static_cast<int>(read->baseFormat), read->opaque};
    identify(kind.data(), sizeof kind);
    readGrid(*read);
    for (size_t levels = in_.count(1); levels > 0; --levels) readGrid(read->mipmaps.emplace_back());
    std::weak_ptr<const scene::TextureImage>& known = parts_.images[identity_];
    image = known.lock();
    if (!image) known = image = read;
  }
  images_.push_back(image);
}

}  // namespace

void DecodedParts::forgetGone() {
  std::erase_if(meshes, [](const auto& entry) { return entry.second.mesh.expired(); });
  std::erase_if(images, [](const auto& entry) { return entry.second.expired(); });
}

std::shared_ptr<scene::Snapshot> SnapshotDecoder::decode(std::span<const std::byte> message) {
  const size_t parts = parts_.meshes.size() + parts_.images.size();
  if (parts > 2 * partsAfterForgetting_ + 64) {
    parts_.forgetGone();
    partsAfterForgetting_ = parts_.meshes.size() + parts_.images.size();
  }
  Decoding decoding(message, arrays_, pages_, parts_);
  auto snapshot = std::make_shared<scene::Snapshot>();
  decoding(*snapshot);
  if (!decoding.atEnd()) throw Malformed("it goes on after its end");
  check(*snapshot);
  return snapshot;
}

}  // namespace gluray::cluster
