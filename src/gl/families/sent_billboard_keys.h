// Keys of impostors whose billboards the program sends (impostors.billboards = "sent").
#pragma once
#include "gl/families/family.h"

#include <string>

namespace gluray::gl {

/// What is wrong with these keys of a family; empty: nothing.
std::string mistakeInSentBillboards(const Family& family);

}  // namespace gluray::gl
