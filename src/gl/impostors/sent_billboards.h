// Impostors whose billboards the program sends: squares around spheres, boxes around sticks. Each corner has
// all attributes of its impostor, and flags that identify the corner. GL thread.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/real/real.h"

#include <cstdint>
#include <span>

namespace gluray::gl {

struct ProgramState;

/// Whether a draw of this mode covers a square (`directions` 2) or each side of a box (3) exactly once, with
/// consistent winding. `corners`: bit d says on which side the corner lies in direction d.
bool coversBillboard(std::span<const uint8_t> corners, GLenum mode, int directions);

/// Builds the mesh of the spheres or sticks that a draw of billboards represents. Null if corners of a
/// billboard disagree, are missing or do not exist, and for sticks without length.
KnownMesh buildSentImpostors(const RealGl& real, const ArrayState& arrays, GLenum mode,
                             const Elements& elements);

/// Whether the program's boxes show all of these sticks in the current view. Boxes that reach from in front
/// of the viewer to behind do not.
bool showsSticks(const RealGl& real, const ProgramState& program, const scene::Mesh& mesh);

}  // namespace gluray::gl
