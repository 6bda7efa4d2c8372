// The plane of a planar mesh. Any thread.
#pragma once
#include "scene/mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>

namespace gluray::gl {

/// Corner k of a triangle, object space.
glm::dvec3 cornerOf(const scene::Mesh& mesh, uint32_t triangle, uint32_t k);

/// The plane that contains all corners, within the rounding of their coordinates; nullopt if there is none.
std::optional<glm::dvec4> planeOfMesh(const scene::Mesh& mesh);

/// The two axes along which the plane extends most, that is without the axis closest to its normal.
glm::ivec2 axesOfPlane(const glm::dvec4& plane);

/// The matrix from (s, t, 1) to clip x, y and w of the point of `plane` with coordinates s, t along `axes`.
glm::dmat3 clipFromPlane(const glm::dmat4& clipFromObject, const glm::dvec4& plane, const glm::ivec2& axes);

}  // namespace gluray::gl
