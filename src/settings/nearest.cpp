#include "settings/nearest.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace gluray {

size_t editDistance(std::string_view from, std::string_view to) {
  // The last three rows of the table of distances between prefixes, the current one last.
  std::vector<size_t> older, old, row(to.size() + 1);
  for (size_t j = 0; j <= to.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= from.size(); ++i) {
    older = std::exchange(old, row);
    row[0] = i;
    for (size_t j = 1; j <= to.size(); ++j) {
      const size_t replaced = old[j - 1] + (from[i - 1] != to[j - 1]);
      row[j] = std::min({old[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
        row[j] = std::min(row[j], older[j - 2] + 1);
    }
  }
  return row[to.size()];
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> names) {
  std::string_view best;
  size_t least = std::max<size_t>(word.size() / 3, 1) + 1;
  for (const std::string_view name : names) {
    const size_t distance = editDistance(word, name);
    if (distance < least) least = distance, best = name;
  }
  return best;
}

}  // namespace gluray
