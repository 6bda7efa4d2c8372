// Evaluates functions of a shader that compute a vector from their argument and uniforms: without loops,
// arrays and writes to variables of others. Numbers are doubles. Any thread.
#pragma once
#include "gl/glsl/functions/function_values.h"
#include "gl/glsl/parser/glsl_tree.h"

#include <glm/glm.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace gluray::gl::glsl {

/// What functions read beside their argument.
struct FunctionInputs {
  /// The value of a uniform; nullopt: it is not known.
  std::function<std::optional<FunctionValue>(std::string_view name)> uniform;
  /// What texture2D() returns.
  std::function<std::optional<glm::dvec4>(std::string_view sampler, const glm::dvec2& at)> texture;
};

class ShaderFunctions {
 public:
  /// `source`: a shader's text. Throws std::runtime_error if it cannot be parsed.
  explicit ShaderFunctions(std::string source);
  ShaderFunctions(const ShaderFunctions&) = delete;
  ShaderFunctions& operator=(const ShaderFunctions&) = delete;

  bool has(std::string_view name) const;
  /// The matrix of a linear function, "vec4 name(vec4)". Throws std::runtime_error if it is not understood or
  /// not linear.
  glm::dmat4 matrixOf(std::string_view name, const FunctionInputs& inputs) const;
  /// What "vec4 name(float)" returns. Throws std::runtime_error if it is not understood.
  glm::dvec4 colorOf(std::string_view name, double at, const FunctionInputs& inputs) const;

 private:
  const std::string source_;  // the tree refers to it
  const Tree tree_;
};

}  // namespace gluray::gl::glsl
