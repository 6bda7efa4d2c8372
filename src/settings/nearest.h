// Suggestions for misspelt names. Pure functions; any thread.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace gluray {

/// Optimal string alignment distance: the minimum number of letters to insert, delete, replace or swap with
/// their neighbour to turn one word into the other.
size_t editDistance(std::string_view from, std::string_view to);

/// The name with the smallest edit distance; empty if that distance exceeds both one and a third of the
/// letters.
std::string_view nearest(std::string_view word, std::span<const std::string_view> names);

}  // namespace gluray
