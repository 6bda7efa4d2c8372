#include "gl/culled/instances/instance_arrays.h"

#include "gl/programs/uniforms.h"
#include "gl/state/extensions.h"

#include <algorithm>
#include <bitset>

namespace gluray::gl {
namespace {

template <class Each>
void forEnabled(const ArrayState& arrays, const Each& each) {
  const auto look = [&](const ArraySource& a) {
    if (a.enabled) each(a);
  };
  arrays.forEach(look);
  for (const ArraySource& a : arrays.generic) look(a);
}

bool hasBaseInstance(const RealGl& real) {
  if (!isPresent(real.DrawArraysInstancedBaseInstance)) return false;
  const int version = versionOf(real);
  return version >= 42 || hasExtension(real, version, "GL_ARB_base_instance");
}

/// Numbers of the instance that terms have.
std::bitset<256> numbersIn(const LinearPosition& position) {
  std::bitset<256> used;
  for (const InstanceColumnTerm& term : position.terms)
    for (int shift = 0; shift < 32; shift += 8) used.set((term.product >> shift) & 0xFF);
  return used;
}

/// Whether its elements are read as the real OpenGL does. Versions of OpenGL differ in signed fractions.
bool isRead(const ArraySource& array) {
  const bool isSigned = array.type == GL_BYTE || array.type == GL_SHORT || array.type == GL_INT;
  return array.buffer && isReadable(array) && !(array.normalized && isSigned);
}

}  // namespace

const ArraySource* arrayOf(const ArrayState& arrays, GLint location) {
  const ArraySource* found = nullptr;
  forEnabled(arrays, [&](const ArraySource& a) {
    if (a.location == location) found = &a;
  });
  return found;
}

InstanceAttributes instanceAttributes(const Program& program, const ArrayState& arrays) {
  InstanceAttributes names;
  bool any = false;
  forEnabled(arrays, [&](const ArraySource& a) { any = any || a.divisor > 0; });
  if (!any) return names;
  for (const auto& [name, attribute] : program.attributes) {
    bool all = attribute.location >= 0;
    for (int c = 0; all && c < std::max(shapeOf(attribute.type).columns, 1); ++c) {
      const ArraySource* const array = arrayOf(arrays, attribute.location + c);
      all = array && array->divisor > 0;
    }
    if (all) names.insert(name);
  }
  return names;
}

Reason instanceRange(const RealGl& real, const ArrayState& arrays, const Elements& e,
                     Instances::Range& range) {
  range = {e.baseInstance, e.repeats(), 0};
  bool same = true;
  forEnabled(arrays, [&](const ArraySource& a) {
    if (a.divisor == 0) return;
    same = same && (range.divisor == 0 || range.divisor == a.divisor);
    range.divisor = a.divisor;
  });
  range.divisor = std::max(range.divisor, uint32_t{1});
  if (range.instances == 1) range.divisor = 1;
  const bool inParts = range.instances == 1 || same;
  const bool based = range.instances > 1 || e.baseInstance != 0;
  return inParts && (!based || hasBaseInstance(real)) ? Reason::traced : Reason::instanceArrays;
}

Reason instanceColumns(const RealGl& real, const Program& program, const ArrayState& arrays,
                       const LinearPosition& position, const Instances::Range& range,
                       std::vector<Instances::Column>& columns) {
  if (arrays.reason == Reason::deletedBuffer) return Reason::deletedBuffer;
  const std::bitset<256> used = numbersIn(position);
  int first = 1;
  for (const InstanceColumn& column : position.columns) {
    bool any = false;
    for (int r = 0; r < column.rows; ++r) any = any || used[static_cast<size_t>(first + r)];
    const auto attribute = program.attributes.find(column.attribute);
    if (any && attribute == program.attributes.end()) return Reason::instanceArrays;
    const ArraySource* const array =
        any ? arrayOf(arrays, attribute->second.location + column.column) : nullptr;
    if (any && (!array || !isRead(*array)))
      return array && isForeign(*array) ? Reason::foreignBuffer : Reason::instanceArrays;
    if (any) columns.push_back({ArrayReader(real, *array), first, column.rows});
    if (any && uint64_t{range.first} + range.units() > columns.back().array.available())
      return Reason::instanceArrays;
    first += column.rows;
  }
  return Reason::traced;
}

}  // namespace gluray::gl
