// Checks that the keys of a family are consistent with each other.
#pragma once
#include "gl/families/family.h"

#include <string>

namespace gluray::gl {

/// What is wrong with the family, as it follows its name: ": ..." or " needs ..."; empty: nothing.
std::string mistakeIn(const Family& family);

}  // namespace gluray::gl
