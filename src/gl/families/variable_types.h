// Checks that the variables of a shader program have types that match their roles in a family. Part of
// match.cpp.
#pragma once
#include "gl/families/family.h"
#include "gl/glsl/program.h"

#include <string>
#include <vector>

namespace gluray::gl {

/// One reason why a shader program does not fit, for the user: `before`, `name` in quotes, `after`.
std::string about(const char* before, const std::string& name, const std::string& after = "");

/// Adds a reason to `out` for each variable of a wrong type.
void needTypes(const Program& p, const Family& f, std::vector<std::string>& out);

}  // namespace gluray::gl
