// Mistakes in the slots of known code, and in keys that get their words from slots. Private to
// code_sections.cpp.
#pragma once
#include "gl/families/family.h"

#include <string>

namespace gluray::gl {

/// A mistake in the slots of a section alone, with file and line; empty if there is none.
std::string mistakeInUses(const KnownCode& section);

/// A mistake that shows when all files are read: a slot without fragments, slots within themselves, words
/// that a key of the family does not know. With file and line; empty if there is none.
std::string mistakeInSlots(const Family& family, const CodeSections& known);

}  // namespace gluray::gl
