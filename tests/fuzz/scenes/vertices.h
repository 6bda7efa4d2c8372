// Primitives of random scenes that are sent by glBegin and glEnd.
#pragma once
#include "tests/fuzz/scenes/arrays.h"
#include "tests/fuzz/scenes/script.h"
#include "tests/fuzz/scenes/shape.h"

namespace gluray::fuzz {

/// Appends the shape as triangles, strips, fans or polygons. With `materials`, glMaterial stands between some
/// of the vertices.
void writePrimitives(Writer& w, const Shape& shape, const Attributes& attributes, bool materials);

/// Appends lines or points with colours and materials of their own.
void writeMarks(Writer& w);

/// Appends glMaterial with random arguments.
void writeMaterial(Writer& w);

}  // namespace gluray::fuzz
