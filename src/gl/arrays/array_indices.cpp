#include "gl/arrays/array_indices.h"

#include "parallel/loops.h"

#include <algorithm>
#include <limits>

namespace gluray::gl {
namespace {

/// `upper` is one past the largest number, which does not fit for the largest uint32_t; that is never a
/// vertex.
Range rangeOf(const Extremes& e) {
  constexpr uint32_t kMax = std::numeric_limits<uint32_t>::max();
  return e.least > e.most ? Range{} : Range{e.least, e.most == kMax ? kMax : e.most + 1};
}

/// Removes primitives of `each` corners that use a vertex from number `available` on.
void dropMissing(std::vector<uint32_t>& corners, uint32_t available, size_t each) {
  size_t kept = 0;
  for (size_t t = 0; t + each <= corners.size(); t += each) {
    const auto first = corners.begin() + static_cast<ptrdiff_t>(t);
    if (*std::max_element(first, first + static_cast<ptrdiff_t>(each)) >= available) continue;
    std::copy_n(first, each, corners.begin() + static_cast<ptrdiff_t>(kept));
    kept += each;
  }
  corners.resize(kept);
}

std::vector<uint32_t> cornersOf(std::vector<uint32_t> numbers, GLenum mode) {
  CapturedVertices draw;
  draw.primitives.push_back({mode, 0, static_cast<uint32_t>(numbers.size())});
  draw.indices.resize(numbers.size());
  copyLarge(draw.indices.data(), numbers.data(), numbers.size() * sizeof(uint32_t));
  numbers = {};
  return triangulate(draw);
}

}  // namespace

PlainIndices plainIndices(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& e) {
  if (mode != GL_TRIANGLES || e.type != GL_UNSIGNED_INT || e.base != 0 || e.count < 0) return {};
  PlainIndices plain;
  auto address = reinterpret_cast<uintptr_t>(e.indices);
  plain.count = static_cast<size_t>(e.count);
  if (arrays.elements) {
    plain.storage = arrays.elements->read(real);
    if (!plain.storage || address > plain.storage->size) return {};
    plain.count = std::min(plain.count, (plain.storage->size - address) / sizeof(uint32_t));
    address += reinterpret_cast<uintptr_t>(plain.storage->data);
  }
  plain.count -= plain.count % 3;
  if (address % alignof(uint32_t) != 0 || address == 0 || plain.count == 0) return {};
  plain.data = reinterpret_cast<const uint32_t*>(address);
  return plain;
}

Triangles trianglesOf(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& e,
                      uint32_t available) {
  Triangles result;
  result.plain = plainIndices(real, arrays, mode, e);
  if (result.plain.data) {
    result.range = rangeOf(extremesOf(result.plain.data, result.plain.count));
    result.corners = result.plain.count;
    if (result.range.upper != 0 && result.range.upper <= available) return result;
    result.plain = {};
  }
  if (!e.type && mode == GL_TRIANGLES) {
    const auto first = static_cast<uint32_t>(e.first);
    const uint32_t count =
        std::min(static_cast<uint32_t>(e.count), available > first ? available - first : 0);
    result.range = {first, first + count - count % 3};
    result.corners = result.range.count();
    result.inOrder = true;
    return result;
  }
  result.numbers = cornersOf(vertexNumbers(real, arrays, e), mode);
  dropMissing(result.numbers, available, 3);
  result.range = rangeOf(extremesOf(result.numbers.data(), result.numbers.size()));
  result.corners = result.numbers.size();
  return result;
}

Taken takenBy(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& e,
              uint32_t available) {
  Taken taken;
  if (!e.type) {
    const auto first = static_cast<uint32_t>(e.first);
    taken.range = {
        first, first + std::min(static_cast<uint32_t>(e.count), available > first ? available - first : 0)};
    return taken;
  }
  const PlainIndices plain = plainIndices(real, arrays, mode, e);
  std::vector<uint32_t> read;
  const uint32_t* numbers = plain.data;
  size_t count = plain.count;
  if (plain.data) taken.range = rangeOf(extremesOf(plain.data, plain.count));
  if (!plain.data || taken.range.upper == 0 || taken.range.upper > available) {
    read = vertexNumbers(real, arrays, e);
    if (mode == GL_LINES)
      dropMissing(read, available, 2);
    else
      std::erase_if(read, [&](uint32_t i) { return i >= available; });
    numbers = read.data(), count = read.size();
    taken.range = rangeOf(extremesOf(numbers, count));
  }
  taken.numbers.resize(count);
  copyNumbers(taken.numbers.data(), numbers, count, taken.range.lower);
  return taken;
}

Order orderOf(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& e, Hash128 seed) {
  if (!e.type) {
    const auto first = static_cast<uint32_t>(e.first);
    auto count = static_cast<uint32_t>(e.count);
    if (arrays.vertex.buffer) {  // vertices beyond the buffer draw nothing
      const uint32_t available = ArrayReader(real, arrays.vertex).available();
      count = std::min(count, available > first ? available - first : 0);
    }
    return {{first, first + count}, seed};
  }
  if (const PlainIndices plain = plainIndices(real, arrays, mode, e); plain.data)
    return {rangeOf(extremesOf(plain.data, plain.count)),
            hashLarge(plain.data, plain.count * sizeof(uint32_t), seed)};
  const std::vector<uint32_t> numbers = vertexNumbers(real, arrays, e);
  return {rangeOf(extremesOf(numbers.data(), numbers.size())),
          hashLarge(numbers.data(), numbers.size() * sizeof(uint32_t), seed)};
}

Range rangeWithout(const RealGl& real, const ArrayState& arrays, const Elements& e, uint32_t restart) {
  std::vector<uint32_t> numbers = vertexNumbers(real, arrays, e);
  std::erase(numbers, restart);
  return rangeOf(extremesOf(numbers.data(), numbers.size()));
}

std::vector<Triangle> sampleTriangles(const RealGl& real, const ArrayState& arrays, GLenum mode,
                                      const Elements& e) {
  constexpr GLsizei kSamples = 32;
  const GLsizei corners = mode == GL_QUADS ? 4 : 3;
  const GLsizei step = std::max(e.count / corners / kSamples, 1) * corners;
  const size_t indexBytes = e.type == GL_UNSIGNED_INT ? 4 : e.type == GL_UNSIGNED_SHORT ? 2 : 1;
  const ArrayReader reader(real, arrays.vertex);
  std::vector<Triangle> triangles;
  // In 64 bits: counts reach up to the largest GLsizei.
  for (int64_t at = 0; at + 2 < e.count; at += step) {
    if (!e.type && e.first + at > std::numeric_limits<GLint>::max()) break;
    Elements three = e;
    three.count = 3;
    if (e.type)
      three.indices = static_cast<const std::byte*>(e.indices) + static_cast<size_t>(at) * indexBytes;
    else
      three.first = static_cast<GLint>(e.first + at);
    Triangle triangle;
    bool exists = true;
    const std::vector<uint32_t> numbers = vertexNumbers(real, arrays, three);
    for (size_t k = 0; k < 3; ++k) {
      float v[4] = {};
      exists = exists && k < numbers.size() && numbers[k] < reader.available();
      if (exists) reader.read(numbers[k], v);
      triangle[k] = {v[0], v[1], v[2]};
    }
    if (exists) triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace gluray::gl
