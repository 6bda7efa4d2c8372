#include "gl/culled/instances/instance_draws.h"

#include "gl/culled/instances/instance_arrays.h"
#include "gl/real/extensions.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <algorithm>

namespace gluray::gl {
namespace {

bool hasBaseInstance(const RealGl& real) {
  if (!isPresent(real.DrawArraysInstancedBaseInstance)) return false;
  const int version = versionOf(real);
  return version >= 42 || hasExtension(real, version, "GL_ARB_base_instance");
}

/// Whether the current vertex array object has bindings; the default one may not.
bool hasVertexBindings(const RealGl& real) {
  if (!isPresent(real.BindVertexBuffer) || integer(real, GL_VERTEX_ARRAY_BINDING) == 0) return false;
  const int version = versionOf(real);
  return version >= 43 || hasExtension(real, version, "GL_ARB_vertex_attrib_binding");
}

GLint attribute(const RealGl& real, GLuint index, GLenum name) {
  GLint value = 0;
  real.GetVertexAttribiv(index, name, &value);
  return value;
}

/// Whether the array can start at a later element, and has all elements that the draw reads. Doubles are
/// excluded because they need other commands.
bool canBegin(const RealGl& real, const ArraySource& array, const InstanceUnits& units) {
  if (!array.buffer || array.location < 0 || array.type == GL_DOUBLE || !isReadable(array)) return false;
  if (!hasVertexBindings(real) && array.binding != static_cast<GLuint>(array.location)) return false;
  return ArrayReader(real, array).available() >= units.endElement(array.divisor);
}

bool isByArrays(const RealGl& real, const InstanceUnits& units) {
  return units.areMixed() || !hasBaseInstance(real);
}

}  // namespace

CullReason findUnits(const RealGl& real, const ArrayState& arrays, const Elements& e,
                     std::optional<InstanceUnits>& units) {
  if (arrays.reason == Reason::deletedBuffer) return CullReason::deletedBuffer;
  std::vector<uint32_t> divisors;
  forEnabled(arrays, [&](const ArraySource& a) {
    if (a.divisor != 0) divisors.push_back(a.divisor);
  });
  units.emplace(e.baseInstance, e.repeats(), std::move(divisors));
  if (!isByArrays(real, *units)) return CullReason::culled;
  bool can = true;
  forEnabled(arrays,
             [&](const ArraySource& a) { can = can && (a.divisor == 0 || canBegin(real, a, *units)); });
  return can ? CullReason::culled : CullReason::instanceArrays;
}

InstanceDraws::InstanceDraws(const RealGl& real, const ArrayState& arrays, const InstanceUnits& units)
    : real_(real), byArrays_(isByArrays(real, units)), units_(units) {
  if (byArrays_) find(arrays);
}

void InstanceDraws::find(const ArrayState& arrays) {
  hasBindings_ = hasVertexBindings(real_);
  forEnabled(arrays, [&](const ArraySource& a) {
    if (a.divisor == 0) return;
    const Moved moved = hasBindings_ ? bindingOf(a) : attributeOf(a);
    if (std::ranges::find(moved_, moved.index, &Moved::index) == moved_.end()) moved_.push_back(moved);
  });
}

InstanceDraws::Moved InstanceDraws::bindingOf(const ArraySource& array) const {
  Moved moved;
  GLint64 offset = 0;
  GLint stride = 0;
  moved.index = array.binding, moved.buffer = array.buffer->name(), moved.divisor = array.divisor;
  real_.GetInteger64i_v(GL_VERTEX_BINDING_OFFSET, moved.index, &offset);
  real_.GetIntegeri_v(GL_VERTEX_BINDING_STRIDE, moved.index, &stride);
  moved.offset = static_cast<GLintptr>(offset), moved.stride = moved.distance = stride;
  return moved;
}

InstanceDraws::Moved InstanceDraws::attributeOf(const ArraySource& array) const {
  Moved moved;
  moved.index = static_cast<GLuint>(array.location);
  moved.buffer = array.buffer->name(), moved.divisor = array.divisor;
  moved.offset = static_cast<GLintptr>(reinterpret_cast<uintptr_t>(array.pointer));
  moved.stride = attribute(real_, moved.index, GL_VERTEX_ATTRIB_ARRAY_STRIDE);
  moved.distance = array.stride;
  moved.size = array.size, moved.type = array.type, moved.normalized = array.normalized;
  moved.integers = attribute(real_, moved.index, GL_VERTEX_ATTRIB_ARRAY_INTEGER) != 0;
  return moved;
}

void InstanceDraws::moveTo(uint32_t first) {
  if (first == at_ || moved_.empty()) return;
  const GLint bound = hasBindings_ ? 0 : integer(real_, GL_ARRAY_BUFFER_BINDING);
  for (const Moved& m : moved_) {
    if (first / m.divisor == at_ / m.divisor) continue;
    const GLintptr offset = m.offset + static_cast<GLintptr>(first / m.divisor) * m.distance;
    if (hasBindings_) {
      real_.BindVertexBuffer(m.index, m.buffer, offset, m.stride);
      continue;
    }
    const auto* const pointer = reinterpret_cast<const void*>(offset);
    real_.BindBuffer(GL_ARRAY_BUFFER, m.buffer);
    if (m.integers)
      real_.VertexAttribIPointer(m.index, m.size, m.type, m.stride, pointer);
    else
      real_.VertexAttribPointer(m.index, m.size, m.type, m.normalized ? GL_TRUE : GL_FALSE, m.stride,
                                pointer);
  }
  if (!hasBindings_) real_.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(bound));
  at_ = first;
}

Elements InstanceDraws::elementsOf(Elements elements, const InstancePart& part) {
  elements.instances = static_cast<GLsizei>(part.count);
  if (byArrays_) return moveTo(part.first), elements;
  elements.baseInstance = units_.base() + part.first / units_.size();
  return elements;
}

}  // namespace gluray::gl
