// GLSL's component-wise built-in functions on linear values and on ranges. Any thread.
#pragma once
#include "gl/culled/shader_slice/linear_value.h"

#include <string_view>
#include <vector>

namespace gluray::gl::glsl {

/// Component `i` of an argument; scalars apply to all components.
inline const Linear& spread(const Value& v, size_t i) { return v.components[v.isScalar() ? 0 : i]; }

/// Result of the pure function `name`; opaque: unknown, or not of type `shape`. `arguments` have that type,
/// or are scalars.
Value callByComponents(std::string_view name, const Shape& shape, const std::vector<Value>& arguments);
/// Truncates towards zero.
Linear truncated(const Linear& l);

}  // namespace gluray::gl::glsl
