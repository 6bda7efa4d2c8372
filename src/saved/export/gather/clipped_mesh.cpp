#include "saved/export/gather/clipped_mesh.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace gluray::saved {
namespace {

/// A vertex with all that a mesh may have.
struct Corner {
  glm::vec3 position{0}, normal{0, 0, 1};
  glm::vec4 color{1}, tangent{1, 0, 0, 1};
  glm::vec2 texcoord[2] = {glm::vec2(0), glm::vec2(0)};
};

glm::vec3 directionBetween(const glm::vec3& a, const glm::vec3& b, float share) {
  const glm::vec3 mixed = glm::mix(a, b, share);
  const float length = glm::length(mixed);
  return length > 0 ? mixed / length : a;
}

Corner between(const Corner& a, const Corner& b, float share) {
  Corner c;
  c.position = glm::vec3(glm::mix(glm::dvec3(a.position), glm::dvec3(b.position), double{share}));
  c.normal = directionBetween(a.normal, b.normal, share);
  c.color = glm::mix(a.color, b.color, share);
  c.tangent = {directionBetween(glm::vec3(a.tangent), glm::vec3(b.tangent), share), a.tangent.w};
  for (int k = 0; k < 2; ++k) c.texcoord[k] = glm::mix(a.texcoord[k], b.texcoord[k], share);
  return c;
}

double distance(const glm::dvec4& plane, const Corner& c) {
  return glm::dot(plane, glm::dvec4(glm::dvec3(c.position), 1));
}

using Polygon = std::vector<Corner>;

/// The part of a polygon, or if `closed` is false of a line, in front of a plane.
Polygon cut(const Polygon& polygon, const glm::dvec4& plane, bool closed) {
  Polygon out;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Corner& here = polygon[i];
    const double d = distance(plane, here);
    if (d >= 0) out.push_back(here);
    if (i + 1 == polygon.size() && !closed) break;
    const Corner& next = polygon[(i + 1) % polygon.size()];
    const double e = distance(plane, next);
    if ((d >= 0) != (e >= 0)) out.push_back(between(here, next, static_cast<float>(d / (d - e))));
  }
  return out;
}

template <class T>
std::vector<T> valuesOf(const SourcePtr& source) {
  std::vector<T> out(source ? source->count() : 0);
  if (source) readAll(*source, 0, out.size(), reinterpret_cast<std::byte*>(out.data()));
  return out;
}

std::vector<Corner> cornersOf(const ExportedMesh& mesh) {
  std::vector<Corner> out(mesh.positions->count());
  const auto set = [&](const auto& values, const auto& put) {
    for (size_t i = 0; i < values.size(); ++i) put(out[i], values[i]);
  };
  set(valuesOf<glm::vec3>(mesh.positions), [](Corner& c, const glm::vec3& v) { c.position = v; });
  set(valuesOf<glm::vec3>(mesh.normals), [](Corner& c, const glm::vec3& v) { c.normal = v; });
  set(valuesOf<glm::vec4>(mesh.tangents), [](Corner& c, const glm::vec4& v) { c.tangent = v; });
  set(valuesOf<glm::vec2>(mesh.texcoords[0]), [](Corner& c, const glm::vec2& v) { c.texcoord[0] = v; });
  set(valuesOf<glm::vec2>(mesh.texcoords[1]), [](Corner& c, const glm::vec2& v) { c.texcoord[1] = v; });
  if (mesh.colors && mesh.colors->element() == Element::bytes4)
    set(valuesOf<glm::u8vec4>(mesh.colors),
        [](Corner& c, const glm::u8vec4& v) { c.color = glm::vec4(v) / 255.0f; });
  else
    set(valuesOf<glm::vec4>(mesh.colors), [](Corner& c, const glm::vec4& v) { c.color = v; });
  return out;
}

class Cutter {
 public:
  Cutter(const ExportedMesh& mesh, const std::vector<glm::dvec4>& planes)
      : planes_(planes), given_(cornersOf(mesh)), places_(given_.size(), kNew), outside_(given_.size()) {
    for (size_t i = 0; i < given_.size(); ++i)
      for (size_t k = 0; k < planes.size(); ++k)
        outside_[i] |= distance(planes[k], given_[i]) < 0 ? 1u << std::min<size_t>(k, 31) : 0;
  }

  void add(const uint32_t* corners, size_t count) {
    uint32_t any = 0;
    for (size_t k = 0; k < count; ++k) any |= outside_[corners[k]];
    if (any == 0) {
      for (size_t k = 0; k < count; ++k) indices_.push_back(placeOf(corners[k]));
      return;
    }
    Polygon polygon;
    for (size_t k = 0; k < count; ++k) polygon.push_back(given_[corners[k]]);
    for (const glm::dvec4& plane : planes_) polygon = cut(polygon, plane, count == 3);
    if (polygon.size() < count) return;
    const auto first = static_cast<uint32_t>(kept_.size());
    kept_.insert(kept_.end(), polygon.begin(), polygon.end());
    for (uint32_t k = 0; k + count <= polygon.size(); ++k) {
      indices_.push_back(first);
      for (uint32_t c = 1; c < count; ++c) indices_.push_back(first + k + c);
    }
  }

  std::optional<ExportedMesh> result(ExportedMesh mesh) const {
    if (indices_.empty()) return {};
    mesh.indices = ownArray(Element::uint32, indices_);
    mesh.positions = arrayOf<glm::vec3>(Element::float3, [](const Corner& c) { return c.position; });
    const auto replace = [&](SourcePtr& source, Element element, auto get) {
      if (source) source = arrayOf<decltype(get(Corner()))>(element, get);
    };
    replace(mesh.normals, Element::float3, [](const Corner& c) { return c.normal; });
    replace(mesh.tangents, Element::float4, [](const Corner& c) { return c.tangent; });
    replace(mesh.colors, Element::float4, [](const Corner& c) { return c.color; });
    replace(mesh.texcoords[0], Element::float2, [](const Corner& c) { return c.texcoord[0]; });
    replace(mesh.texcoords[1], Element::float2, [](const Corner& c) { return c.texcoord[1]; });
    return mesh;
  }

 private:
  static constexpr uint32_t kNew = ~0u;
  uint32_t placeOf(uint32_t vertex) {
    if (places_[vertex] == kNew) {
      places_[vertex] = static_cast<uint32_t>(kept_.size());
      kept_.push_back(given_[vertex]);
    }
    return places_[vertex];
  }
  template <class Value, class Get>
  SourcePtr arrayOf(Element element, Get get) const {
    std::vector<Value> values(kept_.size());
    std::transform(kept_.begin(), kept_.end(), values.begin(), get);
    return ownArray(element, std::move(values));
  }

  const std::vector<glm::dvec4>& planes_;
  std::vector<Corner> given_, kept_;
  std::vector<uint32_t> places_;   // of given vertices among those that are kept
  std::vector<uint32_t> outside_;  // of each vertex: bits of the planes that it is behind
  std::vector<uint32_t> indices_;
};

}  // namespace

std::optional<ExportedMesh> clipped(const ExportedMesh& mesh, const std::vector<glm::dvec4>& planes) {
  const size_t corners = mesh.mode == MeshMode::triangles ? 3 : mesh.mode == MeshMode::lines ? 2 : 1;
  Cutter cutter(mesh, planes);
  const std::vector<uint32_t> indices = valuesOf<uint32_t>(mesh.indices);
  uint32_t element[3];
  for (size_t i = 0; i + corners <= mesh.elementCount(); i += corners) {
    for (size_t k = 0; k < corners; ++k)
      element[k] = mesh.indices ? indices[i + k] : static_cast<uint32_t>(i + k);
    cutter.add(element, corners);
  }
  return cutter.result(mesh);
}

}  // namespace gluray::saved
