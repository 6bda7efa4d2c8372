#include "gl/culled/instances/instance_arrays.h"

#include "gl/programs/uniforms.h"

#include <algorithm>
#include <bitset>

namespace gluray::gl {
namespace {

/// Numbers of instance values that the terms use.
std::bitset<256> numbersIn(const LinearPosition& position) {
  std::bitset<256> used;
  for (const InstanceColumnTerm& term : position.terms)
    for (int shift = 0; shift < 32; shift += 8) used.set((term.product >> shift) & 0xFF);
  return used;
}

bool isSignedFraction(const ArraySource& array) {
  return array.normalized && (array.type == GL_BYTE || array.type == GL_SHORT || array.type == GL_INT);
}

/// Whether the array's elements are converted as the real OpenGL converts them.
bool isRead(const ArraySource& array, const std::function<bool()>& fractions) {
  if (!array.buffer || !isReadable(array)) return false;
  return !isSignedFraction(array) || (array.type != GL_INT && fractions());
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

CullReason instanceColumns(const RealGl& real, const Program& program, const ArrayState& arrays,
                           const LinearPosition& position, const InstanceUnits& units,
                           const std::function<bool()>& fractions, std::vector<Instances::Column>& columns) {
  if (arrays.reason == Reason::deletedBuffer) return CullReason::deletedBuffer;
  const std::bitset<256> used = numbersIn(position);
  int first = 1;
  for (const InstanceColumn& column : position.columns) {
    bool any = false;
    for (int r = 0; r < column.rows; ++r) any = any || used[static_cast<size_t>(first + r)];
    const auto attribute = program.attributes.find(column.attribute);
    if (any && attribute == program.attributes.end()) return CullReason::instanceArrays;
    const ArraySource* const array =
        any ? arrayOf(arrays, attribute->second.location + column.column) : nullptr;
    if (any && (!array || !isRead(*array, fractions)))
      return array && isForeign(*array) ? CullReason::foreignBuffer : CullReason::instanceArrays;
    if (any) columns.push_back({ArrayReader(real, *array), first, column.rows, isSignedFraction(*array)});
    if (any && units.endElement(std::max(array->divisor, 1u)) > columns.back().array.available())
      return CullReason::instanceArrays;
    first += column.rows;
  }
  return CullReason::culled;
}

}  // namespace gluray::gl
