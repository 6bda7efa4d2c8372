// Descriptions of shader programs that the user added (--program-families). Any thread, once there is a
// context.
#pragma once
#include "gl/families/family.h"

#include <memory>
#include <string>
#include <vector>

namespace gluray::intercept {

/// The families of `files`, in their order, before those that are built in. Null where the files add none. A
/// file that cannot be read adds none, and is told through `complain` in one line with file and line number.
std::shared_ptr<const gl::FamilyList> readFamilies(const std::vector<std::string>& files,
                                                   void (*complain)(const std::string& line));

/// The same for the session's files, read once; null: those that are built in.
std::shared_ptr<const gl::FamilyList> families();

}  // namespace gluray::intercept
