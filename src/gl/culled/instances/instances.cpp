#include "gl/culled/instances/instances.h"

#include "parallel/loops.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace gluray::gl {
namespace {

constexpr size_t kUnitGrain = 512;

}  // namespace

Instances::Instances(const LinearPosition& position, std::vector<Column> columns, const Range& range)
    : position_(position), columns_(std::move(columns)), range_(range) {}

std::optional<ClipMatrix> Instances::matrix(uint32_t unit) const {
  std::array<double, LinearPosition::kNumbers> numbers{1};
  for (const Column& column : columns_) {
    float values[4];
    column.array.read(range_.first + unit, values);
    for (int r = 0; r < column.rows; ++r) numbers[static_cast<size_t>(column.firstNumber + r)] = values[r];
  }
  ClipMatrix matrix;
  return position_.at(numbers, matrix.clipFromObject, matrix.magnitudes) ? std::optional(matrix)
                                                                         : std::nullopt;
}

void Instances::mayShow(const Clusters& mesh, const WindowMapping& window, const DepthPyramid* pyramid,
                        std::vector<uint64_t>& visible) const {
  const uint32_t count = units();
  visible.assign((count + 63) / 64, 0);
  forPieces(visible.size(), kUnitGrain / 64, [&](size_t first, size_t last) {
    for (size_t word = first; word < last; ++word) {
      uint64_t bits = 0;
      for (size_t i = 64 * word; i < std::min<size_t>(count, 64 * (word + 1)); ++i) {
        const std::optional<ClipMatrix> at = matrix(static_cast<uint32_t>(i));
        if (!at || mesh.anyMayShow(BoxVisibility(*at, window, pyramid))) bits |= uint64_t{1} << (i & 63);
      }
      visible[word] = bits;
    }
  });
}

uint64_t Instances::instancesIn(const std::vector<uint64_t>& visible) const {
  uint64_t set = 0;
  for (const uint64_t word : visible) set += static_cast<uint64_t>(std::popcount(word));
  const uint32_t last = units() - 1;
  const bool hasLast = visible[last / 64] >> (last & 63) & 1;
  return set * range_.divisor - (hasLast ? uint64_t{last + 1} * range_.divisor - range_.instances : 0);
}

Elements Instances::part(Elements elements, uint32_t first, uint32_t end) const {
  const uint64_t instances =
      std::min(uint64_t{end} * range_.divisor, uint64_t{range_.instances}) - uint64_t{first} * range_.divisor;
  elements.instances = static_cast<GLsizei>(instances);
  elements.baseInstance = range_.first + first;
  return elements;
}

}  // namespace gluray::gl
