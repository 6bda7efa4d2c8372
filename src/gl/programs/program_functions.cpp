#include "gl/programs/program_functions.h"

#include <GL/glext.h>

#include <algorithm>
#include <stdexcept>

namespace gluray::gl {
namespace {

std::optional<glsl::FunctionValue> uniformValue(const Program& program, const UniformReader& uniforms,
                                                const std::string& name) {
  const ProgramUniform* const uniform = program.uniform(name);
  if (!uniform) return std::nullopt;
  const auto vector = [&](int size) {
    return glsl::FunctionValue::vector(glm::dvec4(uniforms.vector(name)), size);
  };
  switch (uniform->type) {
    case GL_FLOAT: return vector(1);
    case GL_FLOAT_VEC2: return vector(2);
    case GL_FLOAT_VEC3: return vector(3);
    case GL_FLOAT_VEC4: return vector(4);
    case GL_FLOAT_MAT4: {
      glsl::FunctionValue value;
      value.size = glsl::FunctionValue::kMatrix, value.matrix = glm::dmat4(uniforms.matrix4(name));
      return value;
    }
    default: return std::nullopt;
  }
}

}  // namespace

NamedFunction functionOf(const KnownProgram& known, const std::string& placeholder) {
  const auto name = known.functionNames.find(placeholder);
  if (name == known.functionNames.end()) return {};
  const auto found =
      std::ranges::find_if(known.functions, [&](const auto& shader) { return shader->has(name->second); });
  return found == known.functions.end() ? NamedFunction{} : NamedFunction{*found, name->second};
}

std::optional<glm::dmat4> matrixOf(const KnownProgram& known, const UniformReader& uniforms,
                                   const std::string& placeholder) {
  const NamedFunction function = functionOf(known, placeholder);
  if (!function.shader) return std::nullopt;
  glsl::FunctionInputs inputs;
  inputs.uniform = [&](std::string_view name) {
    return uniformValue(known.program, uniforms, std::string(name));
  };
  inputs.texture = [](std::string_view, const glm::dvec2&) { return std::optional<glm::dvec4>(); };
  try {
    return function.shader->matrixOf(function.name, inputs);
  } catch (const std::runtime_error&) { return std::nullopt; }
}

std::optional<glm::dmat4> productOf(const KnownProgram& known, const UniformReader& uniforms,
                                    const std::vector<std::string>& names) {
  if (names.empty()) return std::nullopt;
  glm::dmat4 product(1);
  for (const std::string& name : names) {
    const auto matrix = name.starts_with('$') ? matrixOf(known, uniforms, name) : uniforms.product({name});
    if (!matrix) return std::nullopt;
    product = product * *matrix;
  }
  return product;
}

}  // namespace gluray::gl
