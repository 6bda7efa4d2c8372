// Draws of random scenes from arrays, in client memory or in buffer objects, of many types and layouts.
#pragma once
#include "tests/fuzz/scenes/script.h"
#include "tests/fuzz/scenes/shape.h"

namespace gluray::fuzz {

/// Appends draws of the shape from arrays. These leave attributes that have arrays undefined: they are set
/// again afterwards. `list`: a list is compiled.
void writeArrays(Writer& w, const Shape& shape, const Attributes& attributes, bool list);

/// Appends a primitive that is sent by glArrayElement.
void writeArrayElements(Writer& w, const Shape& shape, const Attributes& attributes);

}  // namespace gluray::fuzz
