#include "cluster/stream/snapshot_encoder.h"

#include "cluster/stream/archive.h"
#include "cluster/stream/page_layout.h"
#include "cluster/stream/settings_codec.h"

#include <algorithm>
#include <unordered_map>

namespace gluray::cluster {
namespace {

class Encoding : public WriteArchive<Encoding> {
 public:
  explicit Encoding(ArrayNames& names) : names_(names) {}
  using WriteArchive::value;

  void value(const scene::MeshPtr& mesh) {
    const auto [known, isNew] = meshes_.try_emplace(mesh.get(), static_cast<uint32_t>(meshes_.size()));
    out_.put(known->second);
    if (isNew) write(*mesh);
  }
  void value(const scene::Instance& instance);
  void value(const std::shared_ptr<const scene::TextureImage>& image);
  void value(const Settings& settings) { writeSettings(out_, settings); }

  EncodedSnapshot take() { return {out_.takeBytes(), std::move(arrays_)}; }

 private:
  void write(const scene::Mesh& mesh);
  void writePage(const scene::Mesh& mesh);
  /// `count` elements, from number `first` on.
  void write(const scene::Attribute& attribute, uint32_t count, uint32_t first = 0);
  void write(const scene::TexelGrid& grid, const std::shared_ptr<const void>& owner);
  void writeName(const ArraySource& source) {
    out_.put(source.name);
    if (sent_.try_emplace(source.name).second) arrays_.push_back(source);
  }

  ArrayNames& names_;
  std::vector<ArraySource> arrays_;
  std::unordered_map<Hash128, std::nullptr_t> sent_;
  std::unordered_map<const scene::Mesh*, uint32_t> meshes_;
  std::unordered_map<const scene::TextureImage*, uint32_t> images_;
};

void Encoding::write(const scene::Attribute& a, uint32_t count, uint32_t first) {
  (*this)(a.format);
  if (!a) return;
  const size_t offset = static_cast<size_t>(first) * a.stride;
  writeName(names_.named(a.owner, a.data + offset, count, a.stride, bytesOf(a.format)));
}

void Encoding::writePage(const scene::Mesh& mesh) {
  const auto& page = static_cast<const PageResidence&>(*mesh.residence);
  (*this)(mesh.triangleCount, mesh.vertexCount, mesh.lower, mesh.upper, mesh.opaqueColors);
  out_.put(page.name.id);
  (*this)(page.name.owner, page.name.mostMaterial, page.name.whole.has_value());
  if (page.name.whole) out_.put(*page.name.whole);
  out_.put(static_cast<uint64_t>(mesh.texcoordsAbove.size()));
  eachArray(mesh, page.ofTriangles, [&](const scene::Attribute& a, uint32_t) { (*this)(a.format); });
}

void Encoding::write(const scene::Mesh& mesh) {
  // Neither the identity of the geometry nor the bytes that it takes: the receiver has its own. Meshes that
  // are not moderate are never traced.
  auto& [geometryId, shape, triangleCount, vertexCount, positions, indices, radii, axes, ends, radius,
         normals, colors, texcoords, texcoordsAbove, secondaryColors, fogCoords, materials, triangleNumbers,
         lower, upper, opaqueColors, moderate, sizeBytes, residence] = mesh;
  (*this)(residence != nullptr);
  if (residence) return writePage(mesh);
  (*this)(shape, triangleCount, vertexCount, radius, lower, upper, opaqueColors);
  write(positions, vertexCount);
  write(indices, triangleCount * scene::cornersOf(shape));
  for (const scene::Attribute* a :
       {&radii, &axes, &ends, &normals, &colors, &texcoords, &secondaryColors, &fogCoords, &materials})
    write(*a, vertexCount);
  out_.put(static_cast<uint64_t>(texcoordsAbove.size()));
  for (const scene::Attribute& a : texcoordsAbove) write(a, vertexCount);
}

void Encoding::value(const scene::Instance& instance) {
  auto& [mesh, eyeFromObject, worldFromObject, shading, order, object, color, normal, secondaryColor,
         fogCoord, texcoord, texcoordsAbove, materials, lightingFromObject, normalMatrix, triangleColors,
         triangleNormals, triangleEdges, triangleOffset, impostors, cull, frontFaceCcw, clipPlanes, ground] =
      instance;
  (*this)(mesh, eyeFromObject, worldFromObject, shading, order, object, color, normal, secondaryColor,
          fogCoord, texcoord, texcoordsAbove, materials, lightingFromObject, normalMatrix, impostors, cull,
          frontFaceCcw, clipPlanes, ground);
  if (mesh->residence) return;  // they belong to the page
  for (const scene::Attribute* a : {&triangleColors, &triangleNormals, &triangleEdges})
    write(*a, mesh->triangleCount, triangleOffset);
}

void Encoding::write(const scene::TexelGrid& grid, const std::shared_ptr<const void>& owner) {
  auto& [width, height, depth, texels, floats] = grid;
  const bool isFloats = !floats.empty();
  (*this)(width, height, depth, isFloats);
  const auto count = static_cast<uint32_t>(isFloats ? floats.size() : texels.size());
  const auto* const data = isFloats ? reinterpret_cast<const std::byte*>(floats.data())
                                    : reinterpret_cast<const std::byte*>(texels.data());
  const uint32_t element = isFloats ? sizeof(glm::vec4) : sizeof(uint32_t);
  writeName(names_.named(owner, data, count, element, element));
}

void Encoding::value(const std::shared_ptr<const scene::TextureImage>& image) {
  const auto [known, isNew] = images_.try_emplace(image.get(), static_cast<uint32_t>(images_.size()));
  out_.put(known->second);
  if (!isNew) return;
  (*this)(image != nullptr);
  if (!image) return;
  (*this)(image->baseFormat, image->opaque);
  write(*image, image);
  out_.put(static_cast<uint64_t>(image->mipmaps.size()));
  for (const scene::TexelGrid& level : image->mipmaps) write(level, image);
}

}  // namespace

EncodedSnapshot SnapshotEncoder::encode(const scene::Snapshot& snapshot) {
  if (names_.size() > 2 * namesAfterForgetting_ + 64) {
    names_.forgetGone();
    namesAfterForgetting_ = names_.size();
  }
  Encoding encoding(names_);
  encoding(snapshot);
  return encoding.take();
}

}  // namespace gluray::cluster
