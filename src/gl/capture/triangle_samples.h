// Samples of the triangles of a surface.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "scene/mesh.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace gluray::gl {

/// Corners in object space.
using Triangle = std::array<glm::vec3, 3>;

/// A sample of triangles (about 32), evenly spread over a mesh or captured surfaces.
std::vector<Triangle> sampleTriangles(const scene::Mesh& mesh);
std::vector<Triangle> sampleTriangles(const CapturedVertices& captured);

}  // namespace gluray::gl
