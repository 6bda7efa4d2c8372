// Checks that the keys of a family are consistent with each other.
#pragma once
#include "gl/families/family.h"

#include <string>

namespace gluray::gl {

/// The family's mistake as a phrase that follows its name: ": ..." or " needs ..."; empty if there is none.
std::string mistakeIn(const Family& family);

}  // namespace gluray::gl
