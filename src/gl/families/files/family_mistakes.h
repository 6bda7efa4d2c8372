// Whether the keys of a family go together, beyond what each one says.
#pragma once
#include "gl/families/family.h"

#include <string>

namespace gluray::gl {

/// What is wrong with the family, as it follows its name: ": ..." or " needs ..."; empty: nothing.
std::string mistakeIn(const Family& family);

}  // namespace gluray::gl
