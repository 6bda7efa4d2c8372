// Alternative names of a family's variables in a shader program. Any thread.
#pragma once
#include "gl/families/family.h"
#include "gl/glsl/program.h"

#include <string>

namespace gluray::gl {

/// For each family name that the shader program lacks, the first alternative name that the program has. For
/// Family::anyTexture, the program's only unknown sampler2D.
Renames renamedBy(const Program& program, const Family& family);

/// Whether the family mentions a variable, under this name or as an alternative.
bool isKnown(const std::string& name, const Family& family, const Renames& renamed);

}  // namespace gluray::gl
