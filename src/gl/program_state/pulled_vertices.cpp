#include "gl/program_state/pulled_vertices.h"

#include "gl/capture/mesh_builder.h"
#include "gl/program_state/program_reader.h"
#include "gl/programs/vertex_inputs.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>

namespace gluray::gl {

std::optional<Elements> elementsOf(const PulledVertices& pulled, const Elements& drawn) {
  constexpr GLsizei kTwoTriangles = 6, kLine = 2;
  if (pulled.lines && (pulled.indexed || drawn.count % kTwoTriangles != 0)) return std::nullopt;
  if (pulled.indexed) return drawn;
  if (drawn.type || drawn.first != pulled.firstVertex) return std::nullopt;
  Elements elements = drawn;
  if (pulled.lines) elements.count = drawn.count / kTwoTriangles * kLine;
  elements.first = 0;
  elements.type = GL_UNSIGNED_INT;
  elements.indices =
      reinterpret_cast<const void*>(pulled.idsOffset + static_cast<size_t>(drawn.first) * sizeof(GLuint));
  return elements;
}

std::optional<GLenum> modeOf(const PulledVertices& pulled, GLenum mode) {
  if (!pulled.lines) return mode;
  return mode == GL_TRIANGLES ? std::optional<GLenum>(GL_LINES) : std::nullopt;
}

namespace {

std::optional<scene::Attribute> gather(const PulledVertices& pulled, const scene::Attribute& elements,
                                       uint32_t count, uint32_t triangles) {
  const size_t each = pulled.primitivesPerCell;
  if (pulled.cells && triangles > pulled.cellCount * each) return std::nullopt;
  const auto values = makePadded<uint32_t>(size_t{elements.stride} / sizeof(uint32_t) * triangles);
  auto* const data = reinterpret_cast<std::byte*>(values.get());
  for (size_t i = 0; i < triangles; ++i) {
    auto cell = static_cast<int32_t>(i / each);
    if (pulled.cells) std::memcpy(&cell, pulled.cells.data + i / each * pulled.cells.stride, sizeof cell);
    if (cell < 0 || static_cast<uint32_t>(cell) >= count) return std::nullopt;
    std::memcpy(data + i * elements.stride, elements.data + static_cast<size_t>(cell) * elements.stride,
                elements.stride);
  }
  return scene::Attribute{values, data, elements.stride, elements.format};
}

}  // namespace

std::optional<scene::Attribute> ValuesOfCells::take(const PulledVertices& pulled,
                                                    const scene::Attribute& elements, uint32_t count,
                                                    uint32_t triangles) {
  for (const Known& k : known_)
    if (k.count == count && k.triangles == triangles && k.elements == elements && k.cells == pulled.cells &&
        k.each == pulled.primitivesPerCell)
      return k.values;
  std::optional<scene::Attribute> values = gather(pulled, elements, count, triangles);
  if (!values) return values;
  add({elements, pulled.cells, count, triangles, pulled.primitivesPerCell, *values});
  return values;
}

void ValuesOfCells::add(Known known) {
  bytes_ += known.bytes();
  known_.push_back(std::move(known));
  while (known_.size() > kMost || (known_.size() > 1 && bytes_ > kMostBytes)) {
    bytes_ -= known_.front().bytes();
    known_.pop_front();
  }
}

namespace {

/// The format of a buffer texture, and the array elements that its texels make up.
struct Texels {
  GLenum format;
  GLint size;
  GLenum type;
  GLsizei stride;
};
constexpr Texels kVectors[] = {{GL_R32F, 3, GL_FLOAT, 12}, {GL_RGB32F, 3, GL_FLOAT, 12}};
constexpr Texels kTexcoords[] = {{GL_RG32F, 2, GL_FLOAT, 8}};
constexpr Texels kColors[] = {{GL_RGBA8UI, 4, GL_UNSIGNED_BYTE, 4}};

ArraySource arrayOf(const BufferTexture& texture, const Texels& texels) {
  ArraySource source;
  source.enabled = true;
  source.size = texels.size;
  source.type = texels.type;
  source.normalized = texels.type == GL_UNSIGNED_BYTE;
  source.stride = texels.stride;
  source.pointer = reinterpret_cast<const std::byte*>(texture.offset);
  source.buffer = texture.buffer;
  return source;
}

}  // namespace

/// `integers`: of 32 bits.
Reason ProgramReader::readPulledIntegers(const std::string& name, BufferTexture& integers) {
  const ProgramUniform* sampler = samplerNamed(name);
  if (!sampler) return Reason::program;
  const Reason reason = textures_.buffer(real_, group_, unitOf(*sampler), integers);
  if (reason != Reason::traced) return reason;
  return integers.format == GL_R32I || integers.format == GL_R32UI ? reason : Reason::textureFormat;
}

Reason ProgramReader::readPulledArrays(ArrayState& arrays) {
  arrays.shape = family_.impostors.shape;
  const bool two = hasTwoTexcoords(program_, family_);
  const bool mapped = two || !hasVertexInput(program_, family_, family_.texcoord);
  if (two) arrays.texcoordsAbove.resize(1);
  const struct {
    const std::string& name;
    std::span<const Texels> forms;
    ArraySource* source;
  } inputs[] = {{family_.position, kVectors, &arrays.vertex},
                {family_.normal, kVectors, &arrays.normal},
                {family_.color, kColors, &arrays.color},
                {mapped ? mapTexcoord(program_, family_) : family_.texcoord, kTexcoords, &arrays.texcoord},
                {family_.texcoord, kTexcoords, two ? &arrays.texcoordsAbove.front() : nullptr}};
  const GLint shift = uniforms_.integer(family_.pulling.pointOffset);
  if (shift < 0) return refuse("uniform \"" + family_.pulling.pointOffset + "\" is negative");
  for (const auto& [name, forms, source] : inputs) {
    const ProgramUniform* sampler = source ? samplerNamed(name) : nullptr;
    if (!sampler) continue;
    BufferTexture texture;
    const Reason reason = textures_.buffer(real_, group_, unitOf(*sampler), texture);
    if (reason != Reason::traced) return reason;
    const auto form = std::ranges::find(forms, texture.format, &Texels::format);
    if (form == forms.end()) return Reason::textureFormat;
    *source = arrayOf(texture, *form);
    source->pointer += static_cast<size_t>(shift) * static_cast<size_t>(form->stride);
  }
  if (const Reason reason = foreignReason(arrays); reason != Reason::traced) return reason;
  return arrays.vertex.enabled ? Reason::traced : Reason::arrayState;
}

Reason ProgramReader::readPulledCells(PulledVertices& pulled) {
  const FamilyPulling& names = family_.pulling;
  if (uniforms_.integer(names.cellsIf) == 0) return Reason::traced;
  BufferTexture cells;
  if (const Reason reason = readPulledIntegers(names.cells, cells); reason != Reason::traced)
    return reason == Reason::program ? Reason::traced : reason;  // nothing depends on cells
  const auto storage = cells.buffer->read(real_);
  const GLint shift = uniforms_.integer(names.cellsOffset);
  const size_t skipped = sizeof(GLint) * static_cast<size_t>(std::max(shift, 0));
  if (!storage || shift < 0 || skipped > cells.size) return Reason::arrayState;
  pulled.cells = {storage, storage->data + cells.offset + skipped, sizeof(GLint), scene::Format::uint32};
  pulled.cellCount = static_cast<uint32_t>((cells.size - skipped) / sizeof(GLint));
  return Reason::traced;
}

Reason ProgramReader::readPulled() {
  const FamilyPulling& names = family_.pulling;
  if (!names.given()) return Reason::traced;
  PulledVertices& pulled = out_.pulled.emplace();
  pulled.firstVertex = uniforms_.integer(names.firstVertex);
  pulled.indexed = uniforms_.integer(names.indexedIf) != 0;
  pulled.lines = names.lines;
  pulled.primitivesPerCell = static_cast<uint32_t>(std::max(names.verticesPerCell, 1));
  BufferTexture ids;
  if (const Reason reason = readPulledIntegers(names.pointIds, ids); reason != Reason::traced) return reason;
  pulled.idsOffset = ids.offset;
  if (!pulled.indexed) pulled.arrays.elements = ids.buffer;
  if (const Reason reason = readPulledArrays(pulled.arrays); reason != Reason::traced) return reason;
  return readPulledCells(pulled);
}

Reason ProgramReader::shiftTriangles(const std::string& offset, scene::Attribute& attribute,
                                     uint32_t& count) {
  if (!out_.pulled) return Reason::traced;
  if (out_.pulled->indexed)
    return refuse("its vertices are numbered by points, which do not count triangles");
  if (attribute.format == scene::Format::float1)
    attribute.format = scene::Format::float3, attribute.stride *= 3, count /= 3;
  const GLint shift = uniforms_.integer(offset);
  if (shift < 0 || static_cast<uint32_t>(shift) > count) return Reason::arrayState;
  attribute.data += size_t{attribute.stride} * static_cast<size_t>(shift);
  count -= static_cast<uint32_t>(shift);
  return Reason::traced;
}

}  // namespace gluray::gl
