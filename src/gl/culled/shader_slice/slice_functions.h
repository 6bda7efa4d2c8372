// GLSL's built-in functions and operators on linear values. Any thread.
#pragma once
#include "gl/culled/shader_slice/linear_value.h"

#include <optional>
#include <string_view>
#include <vector>

namespace gluray::gl::glsl {

/// Whether the language has a function of this name that changes nothing but its result.
bool isBuiltInFunction(std::string_view name);
/// Its result; opaque where it is not known.
Value callBuiltIn(std::string_view name, const std::vector<Value>& arguments);
/// The constructor of a built-in type.
Value construct(const Shape& shape, const std::vector<Value>& arguments);
/// Operators but assignments and those that end early (&& and || get both sides here).
Value binaryOperator(std::string_view op, const Value& a, const Value& b);
Value unaryOperator(std::string_view op, const Value& a);
/// Components that a swizzle names; empty: it is none.
std::vector<size_t> swizzled(std::string_view field, size_t components);
/// Whether a boolean is certainly true or false.
std::optional<bool> truth(const Value& v);
/// A known integer.
std::optional<long> integerOf(const Value& v);

}  // namespace gluray::gl::glsl
