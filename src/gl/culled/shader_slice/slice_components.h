// GLSL's component-wise built-in functions on linear values and on ranges. Any thread.
#pragma once
#include "gl/culled/shader_slice/linear_value.h"

#include <string_view>
#include <vector>

namespace gluray::gl::glsl {

/// Component `i` of an argument that may be a scalar for all.
inline const Linear& spread(const Value& v, size_t i) { return v.components[v.isScalar() ? 0 : i]; }

/// The result of function `name`, which changes nothing else; opaque: not of type `shape`, or not known.
/// `arguments` have that type, or are scalars.
Value callByComponents(std::string_view name, const Shape& shape, const std::vector<Value>& arguments);
/// Without the part behind the point.
Linear truncated(const Linear& l);

}  // namespace gluray::gl::glsl
