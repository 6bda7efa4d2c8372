// Values of a program's uniforms, asked of the real OpenGL, which has them whichever way they were set. GL thread,
// context current.
#pragma once
#include "gl/programs/family.h"
#include "gl/programs/program.h"

#include <glm/glm.hpp>

#include <optional>

namespace gluray::gl {

class UniformReader {
 public:
  UniformReader(const RealGl& real, const Program& program) : real_(real), program_(program) {}

  bool has(const std::string& name) const { return !name.empty() && program_.uniform(name); }
  /// Components of element `element`, integers and booleans as numbers; 0 where it is not active.
  glm::vec4 vector(const std::string& name, int element = 0) const;
  float number(const std::string& name, int element = 0) const { return vector(name, element).x; }
  int integer(const std::string& name) const;
  /// A 4x4 or 3x3 matrix; the identity where it is not active.
  glm::mat4 matrix4(const std::string& name) const;
  glm::mat3 matrix3(const std::string& name) const;
  /// Product from left to right; nullopt where one is not active.
  std::optional<glm::dmat4> product(const std::vector<std::string>& names) const;
  /// A constant or a uniform; `otherwise` where the family has none or it is not active. A single number fills
  /// all components.
  glm::vec4 value(const FamilyValue& value, const glm::vec4& otherwise) const;
  float number(const FamilyValue& v, float otherwise) const { return value(v, glm::vec4(otherwise)).x; }

 private:
  /// Up to 16 floats, column by column. False where it is not active.
  bool read(const std::string& name, int element, float* out, int& columns, int& rows) const;
  bool readBlock(const ProgramUniform& u, int element, float* out, int columns, int rows) const;
  const RealGl& real_;
  const Program& program_;
};

}  // namespace gluray::gl
