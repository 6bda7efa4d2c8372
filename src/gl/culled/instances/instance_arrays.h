// The arrays that give instances their values: which attributes they feed, and how draws can be made of some
// instances. A part of CulledDraws, GL thread, context current.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/culled/instances/instances.h"
#include "gl/culled/shader_slice/position_slice.h"
#include "gl/draws/reasons.h"
#include "gl/programs/program.h"

#include <vector>

namespace gluray::gl {

/// The array that feeds the attribute; null: none does.
const ArraySource* arrayOf(const ArrayState& arrays, GLint location);

/// Attributes of the program all of whose columns come from arrays with a divisor.
InstanceAttributes instanceAttributes(const Program& program, const ArrayState& arrays);

/// Finds what the draw's instances read. Reason::traced, or why that cannot be drawn in parts: the real
/// OpenGL has no base instance, or arrays advance at different rates.
Reason instanceRange(const RealGl& real, const ArrayState& arrays, const Elements& elements,
                     Instances::Range& range);

/// Finds the arrays of the numbers that `position` depends on. Reason::traced, or why they cannot be read.
Reason instanceColumns(const RealGl& real, const Program& program, const ArrayState& arrays,
                       const LinearPosition& position, const Instances::Range& range,
                       std::vector<Instances::Column>& columns);

}  // namespace gluray::gl
