// Evaluates the functions of a shader program that stand for placeholders of its family. GL thread, context
// current.
#pragma once
#include "gl/programs/match.h"
#include "gl/programs/uniforms.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace gluray::gl {

/// The shader that has the function of a placeholder, and its name there; null: the program has none.
struct NamedFunction {
  std::shared_ptr<const glsl::ShaderFunctions> shader;
  std::string name;
};
NamedFunction functionOf(const KnownProgram& known, const std::string& placeholder);

/// The matrix of a linear function with the uniforms' values; nullopt if there is none, or if it is not
/// understood.
std::optional<glm::dmat4> matrixOf(const KnownProgram& known, const UniformReader& uniforms,
                                   const std::string& placeholder);

/// Product of matrices from left to right, each of a uniform or, where the name is a placeholder, of a
/// function. nullopt if there are no names, a uniform is not active, or a function is not understood.
std::optional<glm::dmat4> productOf(const KnownProgram& known, const UniformReader& uniforms,
                                    const std::vector<std::string>& names);

}  // namespace gluray::gl
