// Meshes cut by clip planes. Any thread.
#pragma once
#include "saved/export/gather/exported_scene.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace gluray::saved {

/// The part of a mesh where dot(plane, point) >= 0 for every plane; none if nothing is left. `planes`: in the
/// space of the mesh. Attributes are interpolated along edges that are cut (Sutherland and Hodgman,
/// "Reentrant Polygon Clipping", 1974).
std::optional<ExportedMesh> clipped(const ExportedMesh&, const std::vector<glm::dvec4>& planes);

}  // namespace gluray::saved
