// The name that a user may have meant. Pure functions; any thread.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace gluray {

/// Letters inserted, deleted, replaced, or exchanged with their neighbour, that lead from one word to the
/// other (optimal string alignment distance).
size_t editDistance(std::string_view from, std::string_view to);

/// The name of least edit distance; empty where that is more than a third of the letters, and more than one.
std::string_view nearest(std::string_view word, std::span<const std::string_view> names);

}  // namespace gluray
