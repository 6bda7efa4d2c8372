// The arrays with instance attributes, and the attributes that read them. A part of CulledDraws, GL thread,
// context current.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/basics/reasons.h"
#include "gl/culled/instances/instances.h"
#include "gl/culled/shader_slice/position_slice.h"
#include "gl/glsl/program.h"

#include <functional>
#include <vector>

namespace gluray::gl {

/// Calls each(array) for all that are enabled.
template <class Each>
void forEnabled(const ArrayState& arrays, const Each& each) {
  const auto look = [&](const ArraySource& a) {
    if (a.enabled) each(a);
  };
  arrays.forEach(look);
  for (const ArraySource& a : arrays.generic) look(a);
}

/// The array that feeds the attribute; null: none does.
const ArraySource* arrayOf(const ArrayState& arrays, GLint location);

/// Attributes of the program all of whose columns come from arrays with a divisor.
InstanceAttributes instanceAttributes(const Program& program, const ArrayState& arrays);

/// Finds the arrays of the numbers that `position` depends on. CullReason::culled, or why they cannot be
/// read. `fractions`: whether signed fractions of bytes and shorts can be (SignedFractions); asked if needed.
CullReason instanceColumns(const RealGl& real, const Program& program, const ArrayState& arrays,
                           const LinearPosition& position, const InstanceUnits& units,
                           const std::function<bool()>& fractions, std::vector<Instances::Column>& columns);

}  // namespace gluray::gl
