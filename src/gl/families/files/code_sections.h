// Reads [[code]] sections of family files. Private to family_file.cpp.
#pragma once
#include "gl/families/known_code.h"

#include <toml++/toml.h>

#include <string>

namespace gluray::gl {

/// Adds the statements of one section to the section of the same name. Throws FamilyError with the line of a
/// mistake.
void readCode(const toml::table& table, const std::string& file, CodeSections& sections);

}  // namespace gluray::gl
