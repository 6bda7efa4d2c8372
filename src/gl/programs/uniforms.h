// Queries the values of a shader program's uniforms from the real OpenGL. GL thread, context current.
#pragma once
#include "gl/families/family.h"
#include "gl/glsl/program.h"

#include <glm/glm.hpp>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace gluray::gl {

/// One element of a uniform: its components column by column, as glGetUniform returns them.
struct UniformValue {
  GLint location = -1;  // -1: in a block
  GLenum type = 0;
  std::array<GLfloat, 16> floats{};
  std::array<GLint, 16> integers{};
};
using UniformValues = std::vector<UniformValue>;
using UniformValuesPtr = std::shared_ptr<const UniformValues>;

/// Columns and rows of a uniform type, and whether its values are integers (samplers and booleans are).
struct UniformShape {
  int columns = 1, rows = 1;
  bool integers = false;
};
UniformShape shapeOf(GLenum type);

/// Numbers as shown to the user: "2" or "(1, 0.5)".
std::string inWords(const std::vector<float>& numbers);

/// Element `element` of the active uniform `name`.
UniformValue readUniform(const RealGl& real, const Program& program, std::string_view name,
                         const ProgramUniform& uniform, int element);

/// Every element of every active uniform, in the order of Program::uniforms.
UniformValuesPtr readUniforms(const RealGl& real, const Program& program);

/// Finds values of uniforms by name.
class UniformReader {
 public:
  /// `placeholders`: numbers in the program's statements. Everything must outlive the reader.
  UniformReader(const Program& program, const UniformValues& values, const PlaceholderValues& placeholders)
      : program_(program), values_(values), placeholders_(placeholders) {}

  /// Whether the uniform is active. Here and below, a name may end with an array index, "lightColor[2]", or
  /// with a component of a vector, "ambient.r", which is a number, or a column of a matrix, "colors.2".
  bool has(const std::string& name) const { return find(name, 0).value != nullptr; }
  /// Components of array element `element`; integers and booleans become numbers. 0 if the uniform is not
  /// active.
  glm::vec4 vector(const std::string& name, int element = 0) const;
  float number(const std::string& name, int element = 0) const { return vector(name, element).x; }
  int integer(const std::string& name) const;
  /// The texture unit of a sampler; -1 if it is not active.
  int unit(const std::string& sampler) const { return has(sampler) ? integer(sampler) : -1; }
  /// A matrix, extended by the identity; the identity if the uniform is not active.
  glm::mat4 matrix4(const std::string& name) const;
  glm::mat3 matrix3(const std::string& name) const;
  /// Product of matrices from left to right; nullopt if there are no names or one is not active.
  std::optional<glm::dmat4> product(const std::vector<std::string>& names) const;
  /// The value of a constant, a uniform or a placeholder; `otherwise` if the family specifies none of them,
  /// or the uniform is not active, or no statement has the placeholder. A single number fills all components.
  /// Factors that are not active do not count.
  glm::vec4 value(const FamilyValue& value, const glm::vec4& otherwise) const;
  /// The value of `name` in the form of inWords(). Empty if it is `neutral` (Family::neutral) or not active.
  std::string unlike(const std::string& name, const std::vector<float>& neutral) const;
  float number(const FamilyValue& v, float otherwise) const { return value(v, glm::vec4(otherwise)).x; }

 private:
  struct Found {
    const UniformValue* value = nullptr;  // null: not active
    int component = -1;                   // that the name ends with; -1: none
  };
  Found find(const std::string& name, int element) const;
  /// The value without its factors.
  glm::vec4 first(const FamilyValue& value, const glm::vec4& otherwise) const;
  const UniformValue* findWhole(std::string_view name, int element) const;
  const Program& program_;
  const UniformValues& values_;
  const PlaceholderValues& placeholders_;
};

}  // namespace gluray::gl
