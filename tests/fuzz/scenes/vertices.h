// Primitives of random scenes that are sent by glBegin and glEnd.
#pragma once
#include "tests/fuzz/scenes/arrays.h"
#include "tests/fuzz/scenes/script.h"
#include "tests/fuzz/scenes/shape.h"

namespace gluray::fuzz {

/// Where glMaterial stands between glBegin and glEnd.
enum class Materials { none, anywhere, inLists };

/// Appends the shape as triangles, strips, fans or polygons, or always as triangles. In lists, materials that
/// are new in the middle of a primitive confuse Mesa (avoided.md): there each primitive begins with the one
/// that changes later.
void writePrimitives(Writer& w, const Shape& shape, const Attributes& attributes, bool asTriangles,
                     Materials materials);

/// Appends lines or points with colours and materials of their own.
void writeMarks(Writer& w);

/// Appends glMaterial with random arguments.
void writeMaterial(Writer& w, Writer::At at = Writer::At::outside);

}  // namespace gluray::fuzz
