#include "saved/export/gather/edge_lines.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace gluray::saved {

SourcePtr edgeIndices(const scene::Instance& instance) {
  const scene::Mesh& mesh = *instance.mesh;
  constexpr uint32_t kAll = 7;
  std::vector<uint64_t> edges;  // the lesser index in the upper half
  for (uint32_t t = 0; t < mesh.triangleCount; ++t) {
    const size_t index = size_t{instance.triangleOffset} + t;
    const uint32_t flags =
        instance.triangleEdges ? static_cast<uint32_t>(instance.triangleEdges.data[index]) : kAll;
    for (uint32_t k = 0; k < 3; ++k) {
      if (!(flags >> k & 1)) continue;
      const uint32_t a = mesh.corner(t, k), b = mesh.corner(t, (k + 1) % 3);
      if (a != b) edges.push_back(uint64_t{std::min(a, b)} << 32 | std::max(a, b));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  if (edges.empty()) return nullptr;
  std::vector<uint32_t> ends;
  ends.reserve(2 * edges.size());
  for (const uint64_t edge : edges) {
    ends.push_back(static_cast<uint32_t>(edge >> 32));
    ends.push_back(static_cast<uint32_t>(edge));
  }
  return ownArray(Element::uint32, std::move(ends));
}

}  // namespace gluray::saved
