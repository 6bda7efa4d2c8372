#include "gl/culled/small/current_uniforms.h"

#include "gl/glsl/glsl_tokens.h"
#include "gl/programs/uniforms.h"

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

/// The uniform and the array element that `name` refers to; null if there is none.
std::pair<const ProgramUniform*, int> elementNamed(const Program& program, std::string_view name) {
  if (const auto it = program.uniforms.find(name); it != program.uniforms.end()) return {&it->second, 0};
  const size_t bracket = name.rfind('[');
  if (bracket == std::string_view::npos || !name.ends_with(']')) return {nullptr, 0};
  int element = 0;
  for (const char digit : name.substr(bracket + 1, name.size() - bracket - 2)) {
    if (!isDigit(digit) || element > 1 << 20) return {nullptr, 0};
    element = 10 * element + (digit - '0');
  }
  const auto it = program.uniforms.find(name.substr(0, bracket));
  const bool exists = it != program.uniforms.end() && element < it->second.count;
  return {exists ? &it->second : nullptr, element};
}

glm::dmat4 matrix(const RealGl& real, GLenum name) {
  glm::dmat4 m(1);
  real.GetDoublev(name, glm::value_ptr(m));
  return m;
}

}  // namespace

bool CurrentUniforms::find(std::string_view name, Place& place) const {
  const auto [uniform, element] = elementNamed(program_, name);
  const bool isHere = uniform && (uniform->location >= 0 || uniform->block >= 0);
  if (!isHere && (core_ || !name.starts_with("gl_"))) return false;
  place = {isHere ? uniform : nullptr, element, std::string(name)};
  return true;
}

bool CurrentUniforms::read(const Place& place, Numbers& numbers) const {
  if (!place.uniform) return readBuiltIn(place.name, numbers);
  const UniformValue value = readUniform(real_, program_, place.name, *place.uniform, place.element);
  const UniformShape shape = shapeOf(value.type);
  numbers.count = static_cast<size_t>(shape.columns * shape.rows);
  if (numbers.count == 0 || numbers.count > value.floats.size()) return false;
  for (size_t i = 0; i < numbers.count; ++i)
    numbers.values[i] = shape.integers ? value.integers[i] : double{value.floats[i]};
  return true;
}

bool CurrentUniforms::read(std::string_view name, std::vector<double>& components) const {
  Place place;
  Numbers numbers;
  if (!find(name, place) || !read(place, numbers)) return false;
  components.assign(numbers.values.begin(),
                    numbers.values.begin() + static_cast<std::ptrdiff_t>(numbers.count));
  return true;
}

bool CurrentUniforms::readBuiltIn(std::string_view name, Numbers& numbers) const {
  const auto take = [&](std::string_view start) {
    if (!name.starts_with(start)) return false;
    name.remove_prefix(start.size());
    return true;
  };
  glm::dmat4 m(1);
  if (take("gl_ModelViewProjectionMatrix"))
    m = matrix(real_, GL_PROJECTION_MATRIX) * matrix(real_, GL_MODELVIEW_MATRIX);
  else if (take("gl_ModelViewMatrix"))
    m = matrix(real_, GL_MODELVIEW_MATRIX);
  else if (take("gl_ProjectionMatrix"))
    m = matrix(real_, GL_PROJECTION_MATRIX);
  else
    return false;
  if (take("Inverse")) m = glm::inverse(m);
  if (take("Transpose")) m = glm::transpose(m);
  if (!name.empty()) return false;
  numbers.count = 16;
  std::copy_n(glm::value_ptr(m), 16, numbers.values.begin());
  return true;
}

}  // namespace gluray::gl
