#include "cluster/stream/mesh_formats.h"

#include "cluster/stream/byte_stream.h"

#include <algorithm>
#include <cstring>

namespace gluray::cluster {

using scene::Format;

uint32_t largest(const scene::Attribute& a, uint32_t count) {
  uint32_t most = 0;
  for (uint32_t i = 0; i < count; ++i) {
    uint32_t element;
    std::memcpy(&element, a.data + size_t{4} * i, sizeof element);
    most = std::max(most, element);
  }
  return most;
}

void checkFormat(const scene::Attribute& a, std::initializer_list<Format> formats) {
  if (a && std::find(formats.begin(), formats.end(), a.format) == formats.end())
    throw Malformed("an attribute has the wrong format");
}

void checkPageFormats(const scene::Mesh& page, const TriangleArrays& ofTriangles) {
  if (!page.positions) throw Malformed("a mesh has no positions");
  if (!page.indices && page.vertexCount < 3 * page.triangleCount)
    throw Malformed("a triangle has a vertex that does not exist");
  checkFormat(page.positions, {Format::float3});
  checkFormat(page.indices, {Format::uint32});
  checkFormat(page.normals, {Format::float3});
  checkFormat(page.colors, kColorFormats);
  checkFormat(page.texcoords, kTexcoordFormats);
  checkFormat(page.secondaryColors, {Format::float3, Format::float4});
  checkFormat(page.fogCoords, {Format::float1});
  checkFormat(page.materials, {Format::uint32});
  checkFormat(page.triangleNumbers, {Format::uint32});
  for (const scene::Attribute& a : page.texcoordsAbove) checkFormat(a, kTexcoordFormats);
  checkFormat(ofTriangles[0], {Format::float4, Format::unorm8x4});
  checkFormat(ofTriangles[1], {Format::float3, Format::float4});
  checkFormat(ofTriangles[2], {Format::bits8});
}

}  // namespace gluray::cluster
