#include "gl/commands/shown_places.h"

#include "gl/programs/uniforms.h"

#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace gluray::gl {
namespace {

constexpr size_t kMaxMatrices = 8;

/// The identity, and the values of the program's 4x4 matrices.
std::vector<glm::mat4> matricesOf(ShadowState& shadow) {
  std::vector<glm::mat4> matrices{glm::mat4(1)};
  const ProgramState& state = shadow.program();
  if (!state.known) return matrices;
  const UniformValuesPtr values =
      state.uniforms ? state.uniforms : readUniforms(shadow.real, state.known->program);
  for (const UniformValue& value : *values)
    if (value.type == GL_FLOAT_MAT4 && matrices.size() <= kMaxMatrices)
      matrices.push_back(glm::make_mat4(value.floats.data()));
  return matrices;
}

bool isOneLine(double a, double b) { return std::abs(a - b) < 0.1; }

}  // namespace

glm::ivec4 rectangleOf(const std::vector<glm::vec4>& points, const glm::ivec4& viewport) {
  glm::dvec2 lower(HUGE_VAL), upper(-HUGE_VAL);
  std::vector<glm::dvec2> at;
  for (const glm::vec4& p : points) {
    if (!(p.w > 0)) return glm::ivec4(0);
    const glm::dvec2 ndc = glm::dvec2(p) / double{p.w};
    at.push_back(glm::dvec2(viewport.x, viewport.y) + (ndc + 1.0) / 2.0 * glm::dvec2(viewport.z, viewport.w));
    lower = glm::min(lower, at.back()), upper = glm::max(upper, at.back());
  }
  unsigned corners = 0;
  for (const glm::dvec2& p : at) {
    const bool right = isOneLine(p.x, upper.x), top = isOneLine(p.y, upper.y);
    if (!(right || isOneLine(p.x, lower.x)) || !(top || isOneLine(p.y, lower.y))) return glm::ivec4(0);
    corners |= 1u << (right + 2 * top);
  }
  constexpr double kLargest = 1 << 15;
  const bool usable = corners == 15 && upper.x - lower.x >= 1 && upper.y - lower.y >= 1 &&
                      glm::max(glm::abs(lower.x), glm::abs(upper.x)) < kLargest &&
                      glm::max(glm::abs(lower.y), glm::abs(upper.y)) < kLargest;
  if (!usable) return glm::ivec4(0);
  const glm::ivec2 from(glm::round(lower)), to(glm::round(upper));
  return {from, to - from};
}

std::vector<glm::ivec4> placesOf(ShadowState& shadow, const Elements& e) {
  std::vector<glm::ivec4> places;
  const bool quad = !e.type && e.instances < 0 && (e.count == 4 || e.count == 6);
  if (!quad || shadow.target().framebuffer != 0) return places;
  const std::vector<glm::mat4> matrices = matricesOf(shadow);
  const auto add = [&](const ArraySource& source) {
    if (!source.enabled || !isReadable(source) || source.size < 2 || isForeign(source)) return;
    const ArrayReader reader(shadow.real, source);
    const auto first = static_cast<uint32_t>(e.first), count = static_cast<uint32_t>(e.count);
    if (reader.available() < first + count) return;
    for (const glm::mat4& matrix : matrices) {
      std::vector<glm::vec4> points;
      for (uint32_t i = 0; i < count; ++i) {
        float p[4];
        reader.read(first + i, p);
        points.push_back(matrix * glm::vec4(p[0], p[1], p[2], p[3]));
      }
      const glm::ivec4 place = rectangleOf(points, shadow.viewport().box);
      if (place.z > 0 && std::find(places.begin(), places.end(), place) == places.end())
        places.push_back(place);
    }
  };
  shadow.attributes().forEach(add);
  for (const ArraySource& source : shadow.attributes().generic) add(source);
  return places;
}

}  // namespace gluray::gl
