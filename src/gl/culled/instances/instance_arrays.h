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

/// Calls each(array) for all enabled arrays.
template <class Each>
void forEnabled(const ArrayState& arrays, const Each& each) {
  const auto look = [&](const ArraySource& a) {
    if (a.enabled) each(a);
  };
  arrays.forEach(look);
  for (const ArraySource& a : arrays.generic) look(a);
}

/// The array of the attribute at `location`; null if there is none.
const ArraySource* arrayOf(const ArrayState& arrays, GLint location);

/// The attributes of the shader program all of whose columns come from arrays with a divisor.
InstanceAttributes instanceAttributes(const Program& program, const ArrayState& arrays);

/// Finds the arrays of the instance attributes in `position`. Returns CullReason::culled, or the reason why
/// they cannot be read. `fractions`: returns whether signed normalised bytes and shorts can be read
/// (SignedFractions); called on demand.
CullReason instanceColumns(const RealGl& real, const Program& program, const ArrayState& arrays,
                           const LinearPosition& position, const InstanceUnits& units,
                           const std::function<bool()>& fractions, std::vector<Instances::Column>& columns);

}  // namespace gluray::gl
