// The pieces of VTK's shaders for physically based materials. For program_text.cpp.
#pragma once
#include "tests/support/program_text.h"

#include <string>

namespace gluray::test {

/// `count` copies of the text, in which @ stands for the number of the copy.
std::string repeated(int count, const std::string& text);

/// Uniforms, constants and functions.
std::string pbrDeclarations(const Surface& s);
/// From the material's values to the output.
std::string pbrText(const Surface& s);
/// Bends the normal by a normal map.
std::string normalMapText();

}  // namespace gluray::test
