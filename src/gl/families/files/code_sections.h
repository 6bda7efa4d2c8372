// Reads [[code]] sections of family files. Private to family_file.cpp.
#pragma once
#include "gl/families/known_code.h"

#include <toml++/toml.h>

#include <string>

namespace gluray::gl {

/// Adds one section's statements to the section of its name. On mistakes throws FamilyError with its line.
void readCode(const toml::table& table, const std::string& file, CodeSections& sections);

}  // namespace gluray::gl
