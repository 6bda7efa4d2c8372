#include "saved/export/arrays/mesh_arrays.h"

#include "parallel/loops.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

namespace gluray::saved {
namespace {

using scene::Attribute;
using scene::Format;

bool isSame(Format format, Element element) {
  return (format == Format::float2 && element == Element::float2) ||
         (format == Format::float3 && element == Element::float3) ||
         (format == Format::float4 && element == Element::float4) ||
         (format == Format::unorm8x4 && element == Element::bytes4);
}

/// An attribute, element by element.
class AttributeArray final : public ArraySource {
 public:
  AttributeArray(size_t count, const Attribute& attribute, Element element, CornersPtr corners, Pick pick,
                 uint32_t offset)
      : ArraySource(element, count),
        attribute_(attribute),
        corners_(std::move(corners)),
        pick_(pick),
        offset_(offset),
        same_(isSame(attribute.format, element)) {}

  void read(size_t first, size_t count, std::byte* out) const override {
    const size_t each = bytesOf(element());
    for (size_t i = 0; i < count; ++i, out += each) copy(indexOf(first + i), each, out);
  }
  const std::byte* inPlace() const override {
    return same_ && !corners_ && attribute_.stride == bytesOf(element()) ? attribute_.data : nullptr;
  }

 private:
  uint32_t indexOf(size_t vertex) const {
    if (!corners_) return static_cast<uint32_t>(vertex);
    if (pick_ == Pick::vertex) return corners_->vertexOf(vertex);
    const uint32_t primitive = corners_->primitiveOf(vertex);
    return pick_ == Pick::primitive ? offset_ + primitive : corners_->mesh->corner(primitive, 2);
  }
  void copy(uint32_t index, size_t each, std::byte* out) const {
    if (same_) {
      std::memcpy(out, attribute_.data + static_cast<size_t>(index) * attribute_.stride, each);
    } else {
      const glm::vec4 value = scene::fetch(attribute_, index);
      std::memcpy(out, &value, each);
    }
  }

  Attribute attribute_;
  CornersPtr corners_;
  Pick pick_;
  uint32_t offset_;
  bool same_;
};

/// Indices of a mesh.
class PlainIndices final : public ArraySource {
 public:
  PlainIndices(scene::MeshPtr mesh, const std::byte* data, size_t count)
      : ArraySource(Element::uint32, count), mesh_(std::move(mesh)), data_(data) {}
  void read(size_t first, size_t count, std::byte* out) const override {
    std::memcpy(out, data_ + 4 * first, 4 * count);
  }
  const std::byte* inPlace() const override { return data_; }

 private:
  scene::MeshPtr mesh_;
  const std::byte* data_;
};

/// Indices of triangles, whose second and third corners change places. Of consecutive ones without a source.
class ReversedIndices final : public ArraySource {
 public:
  ReversedIndices(SourcePtr indices, size_t count)
      : ArraySource(Element::uint32, count), indices_(std::move(indices)) {}
  void read(size_t first, size_t count, std::byte* out) const override {
    const auto* indices = indices_ ? reinterpret_cast<const uint32_t*>(indices_->inPlace()) : nullptr;
    auto* values = reinterpret_cast<uint32_t*>(out);
    for (size_t i = first; i < first + count; ++i) {
      const size_t at = i % 3 == 0 ? i : i % 3 == 1 ? i + 1 : i - 1;
      if (indices)
        *values++ = indices[at];
      else if (indices_)
        indices_->read(at, 1, reinterpret_cast<std::byte*>(values++));
      else
        *values++ = static_cast<uint32_t>(at);
    }
  }

 private:
  SourcePtr indices_;
};

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

struct MakeUnit {
  void operator()(const glm::vec3* in, glm::vec3* out) const {
    const glm::dvec3 v(*in);
    const double length = std::sqrt(glm::dot(v, v));
    *out = length > 0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0, 0, 1);
  }
};

template <int parts>
void extend(const float* values, size_t count, Extent& extent) {
  float lower[parts], upper[parts], sum = 0;  // times 0: NaN if any value is not finite
  for (int c = 0; c < parts; ++c) lower[c] = extent.lower[c], upper[c] = extent.upper[c];
  for (size_t i = 0; i < count; ++i, values += parts)
    for (int c = 0; c < parts; ++c) {
      const float v = values[c];
      lower[c] = v < lower[c] ? v : lower[c], upper[c] = v > upper[c] ? v : upper[c];
      sum += v * 0;
    }
  for (int c = 0; c < parts; ++c) extent.lower[c] = lower[c], extent.upper[c] = upper[c];
  extent.finite &= sum == 0;
}

template <int parts>
Extent extentOfParts(const ArraySource& source) {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  constexpr size_t kGrain = size_t{1} << 16, kFew = 1024;
  const Extent none{true, glm::vec4(kInfinite), glm::vec4(-kInfinite)};
  const auto add = [&](size_t first, size_t last, Extent extent) {
    const auto* values = reinterpret_cast<const float*>(source.inPlace());
    if (values) {
      extend<parts>(values + first * parts, last - first, extent);
      return extent;
    }
    for (float copy[kFew * parts]; first < last; first += std::min(kFew, last - first)) {
      const size_t count = std::min(kFew, last - first);
      source.read(first, count, reinterpret_cast<std::byte*>(copy));
      extend<parts>(copy, count, extent);
    }
    return extent;
  };
  const auto join = [](const Extent& a, const Extent& b) {
    return Extent{a.finite && b.finite, glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)};
  };
  return reducePieces(source.count(), kGrain, none, add, join);
}

}  // namespace

SourcePtr attributeArray(const scene::MeshPtr& mesh, const Attribute& attribute, Element element,
                         const CornersPtr& corners, Pick pick, uint32_t offset) {
  const size_t count = corners ? corners->count() : mesh->vertexCount;
  return std::make_shared<AttributeArray>(count, attribute, element, corners, pick, offset);
}

SourcePtr indexArray(const scene::MeshPtr& mesh, const CornersPtr& corners) {
  if (corners || !mesh->indices) return nullptr;
  const scene::Attribute& all = mesh->indices;
  const size_t count = static_cast<size_t>(mesh->triangleCount) * cornersOf(mesh->shape);
  return std::make_shared<PlainIndices>(mesh, all.data, count);
}

SourcePtr reversedIndices(const SourcePtr& indices, size_t count) {
  return std::make_shared<ReversedIndices>(indices, count);
}

SourcePtr unitArray(SourcePtr source) {
  return changedArray<glm::vec3, glm::vec3>(std::move(source), Element::float3, MakeUnit());
}

Extent extentOf(const ArraySource& source) {
  switch (bytesOf(source.element()) / sizeof(float)) {
    case 2: return extentOfParts<2>(source);
    case 3: return extentOfParts<3>(source);
    default: return extentOfParts<4>(source);
  }
}

std::vector<uint32_t> finitePrimitives(const scene::Mesh& mesh) {
  std::vector<uint32_t> found;
  for (uint32_t t = 0; t < mesh.triangleCount; ++t) {
    bool finite = true;
    for (uint32_t k = 0; k < cornersOf(mesh.shape); ++k) finite &= isFinite(mesh.position(mesh.corner(t, k)));
    if (finite) found.push_back(t);
  }
  return found;
}

bool isInsideOut(const scene::Mesh& mesh) {
  if (!mesh.normals || mesh.triangleCount == 0) return false;
  constexpr uint32_t kSamples = 1024;
  const uint32_t step = std::max(1u, mesh.triangleCount / kSamples);
  int balance = 0;
  for (uint32_t t = 0; t < mesh.triangleCount && t < kSamples * step; t += step) {
    glm::vec3 p[3], n(0);
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t vertex = mesh.corner(t, k);
      p[k] = mesh.position(vertex), n += glm::vec3(scene::fetch(mesh.normals, vertex));
    }
    const float agreement = glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), n);
    balance += agreement > 0 ? 1 : agreement < 0 ? -1 : 0;
  }
  return balance < 0;
}

}  // namespace gluray::saved
