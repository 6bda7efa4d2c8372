// The colours that surfaces have without light (render/local/honest_look.h), at vertices. Any thread.
#pragma once
#include "render/local/surface.h"
#include "saved/export/arrays/mesh_arrays.h"
#include "saved/export/gather/scene_parts.h"

#include <glm/glm.hpp>

#include <set>
#include <string>
#include <vector>

namespace gluray::saved {

using Notes = std::set<std::string>;

/// Displayed colours of the vertices: `factor` times those of `colors`, or alone if that is null.
struct ShownColors {
  glm::vec4 factor{1};
  SourcePtr colors;  // float4 or bytes4, components in 0 .. 1
  glm::vec4 at(size_t vertex) const;
};

/// `surface` has been changed by HonestLook. Its colours before textures and colour maps.
/// `corners`: null, or those that the vertices are; not null if colours change from triangle to triangle.
ShownColors shownColors(const render::Surface& surface, const CornersPtr& corners, SceneParts&, Notes&);

/// Whether colours change from triangle to triangle, so that triangles cannot share vertices.
bool changeByTriangle(const render::Surface& surface);

/// The colours after textures, at the vertices. `map`: of the program's colour map; otherwise of the textures
/// of the units.
ShownColors texturedColors(const render::Surface&, const scene::Camera&,
                           const std::vector<scene::Texture>& textures, bool map, const ShownColors& before,
                           const CornersPtr& corners);

/// Values that `keep` owns as an attribute.
template <class T>
scene::Attribute ownAttribute(std::vector<T> values, scene::Format format) {
  const auto keep = std::make_shared<const std::vector<T>>(std::move(values));
  return {keep, reinterpret_cast<const std::byte*>(keep->data()), static_cast<uint32_t>(sizeof(T)), format};
}

}  // namespace gluray::saved
