// GLSL's built-in functions and operators on linear values. Any thread.
#pragma once
#include "gl/culled/shader_slice/linear_value.h"

#include <optional>
#include <string_view>
#include <vector>

namespace gluray::gl::glsl {

/// Whether GLSL has a pure built-in function of this name.
bool isBuiltInFunction(std::string_view name);
/// The result of the built-in function; opaque if unknown.
Value callBuiltIn(std::string_view name, const std::vector<Value>& arguments);
/// Calls the constructor of a built-in type.
Value construct(const Shape& shape, const std::vector<Value>& arguments);
/// Binary operators except assignments; && and || evaluate both sides here.
Value binaryOperator(std::string_view op, const Value& a, const Value& b);
Value unaryOperator(std::string_view op, const Value& a);
/// Components of a swizzle; empty: not a swizzle.
std::vector<size_t> swizzled(std::string_view field, size_t components);
/// Whether a boolean is certainly true or false.
std::optional<bool> truth(const Value& v);
/// The value of a known integer.
std::optional<long> integerOf(const Value& v);

}  // namespace gluray::gl::glsl
