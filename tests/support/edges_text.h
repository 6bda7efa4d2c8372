// The pieces of VTK's shaders that paint edges of triangles, as VTK 9.4 and later have them: between corners
// that stay.
#pragma once
#include "tests/support/program_text.h"

#include <string>

namespace gluray::test {

/// Declarations of the fragment shader, and its statements after the colours.
std::string edgeDeclarations();
std::string edgePainting();
/// The text with names of the geometry shader's outputs in place of those of the vertex shader.
std::string afterGeometry(std::string text);

}  // namespace gluray::test
