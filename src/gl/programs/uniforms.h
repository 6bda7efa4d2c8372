// Values of a program's uniforms, asked of the real OpenGL, which has them whichever way they were set. GL
// thread, context current.
#pragma once
#include "gl/families/family.h"
#include "gl/programs/program.h"

#include <glm/glm.hpp>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace gluray::gl {

/// One element of a uniform: its bits column by column, as glGetUniform answers them.
struct UniformValue {
  GLint location = -1;  // -1: in a block
  GLenum type = 0;
  std::array<GLfloat, 16> floats{};
  std::array<GLint, 16> integers{};
};
using UniformValues = std::vector<UniformValue>;
using UniformValuesPtr = std::shared_ptr<const UniformValues>;

/// Columns and rows of a uniform type, and whether its values are whole numbers (samplers and booleans are).
struct UniformShape {
  int columns = 1, rows = 1;
  bool integers = false;
};
UniformShape shapeOf(GLenum type);

/// Numbers as the user is told them: "2" or "(1, 0.5)".
std::string inWords(const std::vector<float>& numbers);

/// Every element of every active uniform, in the order of Program::uniforms.
UniformValuesPtr readUniforms(const RealGl& real, const Program& program);

/// Finds values by name.
class UniformReader {
 public:
  UniformReader(const Program& program, const UniformValues& values) : program_(program), values_(values) {}

  /// Names may end with the number of an element: "lightColor[2]".
  bool has(const std::string& name) const { return find(name, 0) != nullptr; }
  /// Components of element `element`, integers and booleans as numbers; 0 where it is not active.
  glm::vec4 vector(const std::string& name, int element = 0) const;
  float number(const std::string& name, int element = 0) const { return vector(name, element).x; }
  int integer(const std::string& name) const;
  /// A matrix, filled up with the identity; that where it is not active.
  glm::mat4 matrix4(const std::string& name) const;
  glm::mat3 matrix3(const std::string& name) const;
  /// Product from left to right; nullopt where one is not active.
  std::optional<glm::dmat4> product(const std::vector<std::string>& names) const;
  /// A constant or a uniform; `otherwise` where the family has none or it is not active. A single number
  /// fills all components.
  glm::vec4 value(const FamilyValue& value, const glm::vec4& otherwise) const;
  /// What `name` is, in words, where that is not `neutral` (Family::neutral); empty where it is or not
  /// active.
  std::string unlike(const std::string& name, const std::vector<float>& neutral) const;
  float number(const FamilyValue& v, float otherwise) const { return value(v, glm::vec4(otherwise)).x; }

 private:
  const UniformValue* find(const std::string& name, int element) const;
  const Program& program_;
  const UniformValues& values_;
};

}  // namespace gluray::gl
