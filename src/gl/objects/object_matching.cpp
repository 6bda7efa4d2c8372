#include "gl/objects/object_matching.h"

#include <algorithm>

namespace gluray::gl {
namespace {

constexpr size_t kMaxComparedPairs = size_t{1} << 18;  // pairs

using TraitsList = std::vector<const ObjectTraits*>;

/// The longest common subsequence, weighted by likeness.
std::vector<size_t> alignBest(const TraitsList& before, const TraitsList& now) {
  const size_t columns = before.size() + 1;
  std::vector<double> best((now.size() + 1) * columns, 0);  // sum for the rest of both lists
  for (size_t i = now.size(); i-- > 0;)
    for (size_t k = before.size(); k-- > 0;) {
      const double alike = likeness(*before[k], *now[i]);
      const double taken = alike > 0 ? alike + best[(i + 1) * columns + k + 1] : 0;
      best[i * columns + k] = std::max({taken, best[(i + 1) * columns + k], best[i * columns + k + 1]});
    }
  std::vector<size_t> found(now.size(), kNoObject);
  for (size_t i = 0, k = 0; i < now.size() && k < before.size();) {
    const double here = best[i * columns + k], alike = likeness(*before[k], *now[i]);
    if (alike > 0 && here == alike + best[(i + 1) * columns + k + 1])
      found[i++] = k++;
    else if (here == best[i * columns + k + 1])
      ++k;
    else
      ++i;
  }
  return found;
}

}  // namespace

double likeness(const ObjectTraits& earlier, const ObjectTraits& now) {
  if (earlier.shape != now.shape) return 0;
  const double less = std::min(earlier.triangles, now.triangles),
               more = std::max(earlier.triangles, now.triangles);
  return 0.3 + (earlier.look == now.look ? 0.4 : 0) + 0.3 * (more > 0 ? less / more : 1);
}

std::vector<size_t> alignObjects(const TraitsList& before, const TraitsList& now) {
  const auto mayBe = [](const ObjectTraits* a, const ObjectTraits* b) { return likeness(*a, *b) > 0; };
  const bool inOrder = std::equal(before.begin(), before.end(), now.begin(), now.end(), mayBe);
  if (!inOrder && before.size() * now.size() <= kMaxComparedPairs) return alignBest(before, now);
  std::vector<size_t> found(now.size(), kNoObject);
  for (size_t i = 0; i < std::min(before.size(), now.size()); ++i)
    if (likeness(*before[i], *now[i]) > 0) found[i] = i;
  return found;
}

}  // namespace gluray::gl
