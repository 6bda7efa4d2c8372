// Functions of shader programs that are evaluated in place of being compared. Part of match.h.
#pragma once
#include "gl/families/family.h"
#include "gl/glsl/functions/shader_functions.h"
#include "gl/glsl/program_source.h"

#include <memory>
#include <string>
#include <vector>

namespace gluray::gl {

/// Takes functions that stand for placeholders of the family away from `statements` (known_code.h). Adds what
/// does not fit to `out`. False: the other statements need no look.
bool needFunctions(GlslStatements& statements, const Family& family, const CodeSections& code,
                   std::vector<std::string>& out);

/// The functions of a program's vertex and fragment shaders, if they can be parsed.
std::vector<std::shared_ptr<const glsl::ShaderFunctions>> functionsOf(ProgramSource& source);

}  // namespace gluray::gl
