#include "gl/arrays/assembly.h"

#include "gl/arrays/primitive_restart.h"

#include <GL/glext.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace gluray::gl {
namespace {

/// Positions of the corners of triangle `i` in a strip or fan. The provoking vertex is the last or the first
/// one.
std::array<size_t, 3> placesIn(GLenum mode, bool firstProvokes, size_t i) {
  if (mode == GL_TRIANGLE_FAN)
    return firstProvokes ? std::array{i + 1, i + 2, size_t{0}} : std::array{size_t{0}, i + 1, i + 2};
  if (i % 2 == 0) return {i, i + 1, i + 2};
  return firstProvokes ? std::array{i, i + 2, i + 1} : std::array{i + 1, i, i + 2};
}

void append(std::span<const uint32_t> run, GLenum mode, bool firstProvokes, std::vector<uint32_t>& corners) {
  const size_t each = mode == GL_QUADS ? 4 : 3;
  if (mode == GL_TRIANGLES || mode == GL_QUADS) {
    const auto whole = static_cast<ptrdiff_t>(run.size() / each * each);
    corners.insert(corners.end(), run.begin(), run.begin() + whole);
    return;
  }
  for (size_t i = 0; i + 2 < run.size(); ++i)
    for (const size_t place : placesIn(mode, firstProvokes, i)) corners.push_back(run[place]);
}

}  // namespace

Hash128 Assembly::added(const Hash128& name) const {
  const bool joined = mode == GL_TRIANGLE_STRIP || mode == GL_TRIANGLE_FAN;
  if (!restart && !(joined && firstProvokes)) return name;
  const uint64_t form[] = {restart.has_value(), restart.value_or(0), joined && firstProvokes};
  return hashBytes(form, sizeof form, name);
}

std::vector<uint32_t> Assembly::corners(std::vector<uint32_t> numbers) const {
  if (!restart && (mode == GL_TRIANGLES || mode == GL_QUADS)) {
    numbers.resize(numbers.size() / (mode == GL_QUADS ? 4 : 3) * (mode == GL_QUADS ? 4 : 3));
    return numbers;
  }
  std::vector<uint32_t> corners;
  corners.reserve(mode == GL_TRIANGLES || mode == GL_QUADS ? numbers.size() : 3 * numbers.size());
  const std::span<const uint32_t> all(numbers);
  for (size_t first = 0; first < all.size();) {
    const auto from = all.begin() + static_cast<ptrdiff_t>(first);
    const auto end = restart ? std::find(from, all.end(), *restart) : all.end();
    const auto count = static_cast<size_t>(end - from);
    append(all.subspan(first, count), mode, firstProvokes, corners);
    first += count + 1;
  }
  return corners;
}

Assembly assemblyOf(const RealGl& real, bool firstProvokes, GLenum mode, const Elements& e) {
  Assembly assembly{mode, firstProvokes, std::nullopt};
  if (!e.type) return assembly;
  // Indices are compared before the base is added.
  assembly.restart = readRestart(real).indexOf(e.type);
  if (assembly.restart) *assembly.restart += static_cast<uint32_t>(e.base);
  return assembly;
}

WithoutRestart::WithoutRestart(const RealGl& real) : real_(real) {
  const PrimitiveRestart restart = readRestart(real);
  if (restart.at) off_[0] = GL_PRIMITIVE_RESTART;
  if (restart.atLargest) off_[1] = GL_PRIMITIVE_RESTART_FIXED_INDEX;
  for (const GLenum name : off_)
    if (name != 0) real.Disable(name);
}

WithoutRestart::~WithoutRestart() {
  for (const GLenum name : off_)
    if (name != 0) real_.Enable(name);
}

}  // namespace gluray::gl
