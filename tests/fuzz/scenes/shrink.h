// Shortens a scene that differs: leaves out calls as long as it still differs.
#pragma once
#include "tests/fuzz/scenes/script.h"

#include <functional>
#include <vector>

namespace gluray::fuzz {

/// Whether glBegin and glEnd, lists and stacks are in pairs, and vertices between the former, as in scenes
/// that programs draw.
bool isBalanced(const std::vector<Call>& calls);

/// A part of `calls`, in order, for which `differs` holds, as it does for `calls`. After Zeller's ddmin
/// (2002).
std::vector<Call> shrink(std::vector<Call> calls,
                         const std::function<bool(const std::vector<Call>&)>& differs);

}  // namespace gluray::fuzz
