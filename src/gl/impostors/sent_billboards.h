// Impostors whose billboards the program sends: squares about spheres, boxes about sticks, each corner with
// all values of its impostor and with flags that say which corner it is. GL thread.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/real/real.h"

#include <cstdint>
#include <span>

namespace gluray::gl {

struct ProgramState;

/// Whether a draw of this mode covers a square (`directions` 2) or each side of a box (3) exactly once, with
/// all triangles turned alike. `corners`: bit d of a corner says on which side it is in direction d.
bool coversBillboard(std::span<const uint8_t> corners, GLenum mode, int directions);

/// The mesh of spheres or sticks that a draw of billboards stands for. Null where corners of one billboard
/// disagree, are missing or do not exist, and for sticks without length.
KnownMesh buildSentImpostors(const RealGl& real, const ArrayState& arrays, GLenum mode,
                             const Elements& elements);

/// Whether the program's boxes show all of these sticks in the current view: those that reach from before
/// the viewer to behind do not.
bool showsSticks(const RealGl& real, const ProgramState& program, const scene::Mesh& mesh);

}  // namespace gluray::gl
