// Values that functions of a shader compute with (shader_functions.h). Any thread.
#pragma once
#include <glm/glm.hpp>

#include <array>
#include <stdexcept>
#include <string_view>

namespace gluray::gl::glsl {

[[noreturn]] inline void refuseFunction() { throw std::runtime_error("a function is not understood"); }

/// A number that may depend linearly on the function's argument, a vector of four components.
struct FunctionNumber {
  double constant = 0;
  glm::dvec4 factors{0};  // of the components
  bool isConstant() const { return factors == glm::dvec4(0); }
};

/// The number; refuses one that depends on the argument.
inline double numberOf(const FunctionNumber& v) {
  return v.isConstant() ? v.constant : (refuseFunction(), 0.0);
}

/// A number, a vector or a matrix of four columns and rows.
struct FunctionValue {
  int size = 1;          // components of the vector; 16: a matrix
  bool integer = false;  // int or bool
  std::array<FunctionNumber, 4> parts;
  glm::dmat4 matrix{1};

  static FunctionValue number(double v) {
    FunctionValue value;
    value.parts[0].constant = v;
    return value;
  }
  static FunctionValue truth(bool v) {
    FunctionValue value = number(v ? 1 : 0);
    value.integer = true;
    return value;
  }
  static FunctionValue vector(const glm::dvec4& v, int size) {
    FunctionValue value;
    value.size = size;
    for (int i = 0; i < size; ++i) value.parts[static_cast<size_t>(i)].constant = v[i];
    return value;
  }
  static constexpr int kMatrix = 16;
  bool isMatrix() const { return size == kMatrix; }
  /// Component i; that of a number counts for all.
  const FunctionNumber& at(int i) const { return parts[static_cast<size_t>(size == 1 ? 0 : i)]; }
  bool isTrue() const { return size == 1 ? numberOf(parts[0]) != 0 : (refuseFunction(), false); }
};

/// left op right, for + - * / and comparisons. Refuses what is not linear, and divisions of integers.
FunctionValue combined(std::string_view op, const FunctionValue& left, const FunctionValue& right);

/// A built-in function of numbers and vectors that do not depend on the argument; refuses unknown ones.
FunctionValue builtIn(std::string_view name, const FunctionValue* arguments, size_t count);

}  // namespace gluray::gl::glsl
