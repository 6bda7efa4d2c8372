// Matrices of linear values. Any thread.
#pragma once
#include "gl/culled/shader_slice/linear_value.h"

#include <utility>
#include <vector>

namespace gluray::gl::glsl {

inline Value valueOf(const Shape& shape, std::vector<Linear> components) {
  Value v;
  v.shape = shape, v.components = std::move(components);
  return v;
}
inline const Linear& elementOf(const Value& m, int column, int row) {
  return m.components[static_cast<size_t>(column * m.shape.rows + row)];
}

/// Matrix times matrix or vector, vector times matrix; opaque: incompatible shapes.
Value multiplied(const Value& a, const Value& b);
Value transposed(const Value& m);
/// Inverse matrix; unknown if the matrix is unknown or singular.
Value inverted(const Value& m);

}  // namespace gluray::gl::glsl
