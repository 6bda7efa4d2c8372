// Suggestions for misspelt names. Pure functions; any thread.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace gluray {

/// Optimal string alignment distance: the least number of letters inserted, deleted, replaced, or swapped
/// with their neighbour that turns one word into the other.
size_t editDistance(std::string_view from, std::string_view to);

/// The name of least edit distance; empty if that exceeds both one and a third of the letters.
std::string_view nearest(std::string_view word, std::span<const std::string_view> names);

}  // namespace gluray
