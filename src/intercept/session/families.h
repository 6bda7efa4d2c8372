// Families of shader programs from the user's files (--program-families). Any thread, after the first context
// was made.
#pragma once
#include "gl/families/family.h"

#include <memory>
#include <string>
#include <vector>

namespace gluray::intercept {

/// The families of `files`, in order, followed by the built-in ones. Null if the files add none. Skips
/// unreadable files, and reports each through `complain` in one line with file and line number.
std::shared_ptr<const gl::FamilyList> readFamilies(const std::vector<std::string>& files,
                                                   void (*complain)(const std::string& line));

/// The families of the session's files, read once; null: only the built-in ones.
std::shared_ptr<const gl::FamilyList> families();

}  // namespace gluray::intercept
