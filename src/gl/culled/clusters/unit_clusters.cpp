#include "gl/culled/clusters/unit_clusters.h"

#include "parallel/loops.h"

#include <algorithm>

namespace gluray::gl {
namespace {

constexpr size_t kPrimitiveGrain = 16384, kWordGrain = 8;

}  // namespace

void UnitClusters::find(const Clusters& clusters, const Primitives& primitives, size_t step, uint32_t count) {
  if (units_.size() != count) units_.assign(count, clusters);
  const size_t grain = std::max<size_t>(1, kPrimitiveGrain / std::max(primitives.count, 1u));
  forPieces(units_.size(), grain, [&](size_t first, size_t last) {
    for (size_t i = first; i < last; ++i) {
      Primitives ofUnit = primitives;
      ofUnit.positions += step * i;
      units_[i].refit(ofUnit);
    }
  });
}

void UnitClusters::mayShow(const WindowMapping& window, const DepthPyramid* pyramid,
                           std::vector<uint64_t>& visible) const {
  const BoxVisibility view({}, window, pyramid);
  visible.assign((units_.size() + 63) / 64, 0);
  forPieces(visible.size(), kWordGrain, [&](size_t first, size_t last) {
    for (size_t i = 64 * first; i < std::min(units_.size(), 64 * last); ++i)
      if (units_[i].anyMayShow(view)) visible[i / 64] |= uint64_t{1} << (i & 63);
  });
}

}  // namespace gluray::gl
