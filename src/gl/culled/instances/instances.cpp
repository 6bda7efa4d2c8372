#include "gl/culled/instances/instances.h"

#include "parallel/loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gluray::gl {
namespace {

constexpr size_t kUnitGrain = 512;

}  // namespace

Instances::Instances(const LinearPosition& position, std::vector<Column> columns, const InstanceUnits& units)
    : position_(position), columns_(std::move(columns)), units_(units) {}

std::optional<ClipMatrix> Instances::matrix(uint32_t unit) const {
  std::array<double, LinearPosition::kNumbers> numbers{1};
  for (const Column& column : columns_) {
    float values[4];
    column.array.read(units_.element(unit, std::max(column.array.divisor(), GLuint{1})), values);
    for (int r = 0; r < column.rows; ++r) {
      if (column.fractions && values[r] <= -1) return std::nullopt;
      numbers[static_cast<size_t>(column.firstNumber + r)] = values[r];
    }
  }
  ClipMatrix matrix;
  return position_.at(numbers, matrix.clipFromObject, matrix.magnitudes) ? std::optional(matrix)
                                                                         : std::nullopt;
}

void Instances::mayShow(const Clusters& mesh, const WindowMapping& window, const DepthPyramid* pyramid,
                        std::vector<uint64_t>& visible) const {
  const uint32_t count = units_.units();
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

}  // namespace gluray::gl
