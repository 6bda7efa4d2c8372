// Parts of GLSL's operators that its functions share. Private to slice_functions.cpp and slice_operators.cpp.
// Any thread.
#pragma once
#include "gl/culled/shader_slice/linear_value.h"

#include <string_view>
#include <vector>

namespace gluray::gl::glsl {

Linear boolean(bool b);
/// Compares numbers; unknown if rounding could change the result.
Linear compared(std::string_view op, const Linear& a, const Linear& b);
/// Whether all components, or any, are certainly true.
Value reduced(const Value& v, bool all);
/// Common shape of the values, ignoring scalars. Opaque: incompatible shapes.
Shape commonShape(const std::vector<Value>& values);

}  // namespace gluray::gl::glsl
