// Finds where a toolkit shows the contents of framebuffer objects in its window: it draws a rectangle with
// the framebuffer's texture. GL thread, active on demand (DrawnObjects).
#pragma once
#include "gl/real/elements.h"
#include "gl/shadow/shadow_state.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::gl {

/// Rectangles of the window that a draw of a shader program may fill: x and y from the lower left corner,
/// width and height in pixels. One for each of its arrays, untransformed and transformed by each of its
/// matrices, if the results are the corners of a rectangle. Empty for draws with other than four or six
/// vertices, and for draws into framebuffer objects.
std::vector<glm::ivec4> placesOf(ShadowState& shadow, const Elements& elements);

/// The rectangle filled by four or six points in clip space, each of which must be at one of its corners; {0,
/// 0, 0, 0} if there is none.
glm::ivec4 rectangleOf(const std::vector<glm::vec4>& points, const glm::ivec4& viewport);

}  // namespace gluray::gl
