#include "gl/culled/constant_attributes.h"

#include "gl/arrays/array_indices.h"
#include "gl/arrays/assembly.h"
#include "gl/culled/instances/instance_arrays.h"

#include <algorithm>
#include <array>
#include <optional>

namespace gluray::gl {
namespace {

constexpr size_t kMaxKnown = 1024;

/// Whether component `c` of all elements from `range.lower` to `range.upper` is 1.
bool areOnes(const ArrayReader& reader, const Range& range, size_t c) {
  if (!reader.data() || range.upper > reader.available()) return false;
  std::array<float, 4> element{};
  for (uint32_t i = range.lower; i < range.upper; ++i) {
    reader.read(i, element.data());
    if (element[c] != 1) return false;
  }
  return true;
}

}  // namespace

bool ConstantAttributes::areOnes(ShadowState& shadow, const Program& program,
                                 std::span<const AttributeComponent> components, GLenum mode,
                                 const Elements& e) {
  return std::ranges::all_of(components, [&](const AttributeComponent& component) {
    return isOne(shadow, program, component, mode, e);
  });
}

bool ConstantAttributes::isOne(ShadowState& shadow, const Program& program, const AttributeComponent& of,
                               GLenum mode, const Elements& e) {
  std::array<GLfloat, 4> current{};
  const auto c = static_cast<size_t>(of.component);
  if (of.attribute == "gl_Color") {
    if (shadow.arrays().color.enabled) return isOne(shadow, shadow.arrays().color, of.component, mode, e);
    return shadow.real.GetFloatv(GL_CURRENT_COLOR, current.data()), current[c] == 1;
  }
  const ProgramAttribute* const attribute = program.attribute(of.attribute);
  if (!attribute || attribute->location < 0) return false;
  if (const ArraySource* const array = arrayOf(shadow.attributes(), attribute->location))
    return isOne(shadow, *array, of.component, mode, e);
  // Attribute 0 is the vertex itself if there is fixed function.
  if (attribute->location == 0 && !shadow.info.core) return false;
  shadow.real.GetVertexAttribfv(static_cast<GLuint>(attribute->location), GL_CURRENT_VERTEX_ATTRIB,
                                current.data());
  return current[c] == 1;
}

bool ConstantAttributes::isOne(ShadowState& shadow, const ArraySource& array, int component, GLenum mode,
                               const Elements& e) {
  // A missing component is 1 if it is the fourth.
  if (component >= array.size) return component == 3;
  if (!isReadable(array) || isForeign(array)) return false;
  ArrayState content;
  content.vertex = array;
  content.elements = shadow.attributes().elements;
  if (foreignReason(content) != Reason::traced) return false;
  const std::optional<uint32_t> restart =
      assemblyOf(shadow.real, shadow.raster().firstVertexProvokes, mode, e).restart;
  const int64_t form[] = {component,   array.divisor,       e.baseInstance,
                          e.repeats(), restart.has_value(), restart.value_or(0)};
  const Hash128 name = hashBytes(form, sizeof form, contentOf(shadow.real, content, mode, e));
  const auto found = known_.find(name);
  if (found != known_.end()) return found->second;
  if (known_.size() >= kMaxKnown) known_.clear();
  const ArrayReader reader(shadow.real, array);
  Range range{e.baseInstance, e.baseInstance + (e.repeats() + array.divisor) / std::max(array.divisor, 1u)};
  if (array.divisor == 0)
    range = restart ? rangeWithout(shadow.real, content, e, *restart)
                    : orderOf(shadow.real, content, mode, e, {}).range;
  return known_[name] = gl::areOnes(reader, range, static_cast<size_t>(component));
}

}  // namespace gluray::gl
