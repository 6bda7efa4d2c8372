#include "gl/volumes/label_rows.h"

#include <algorithm>
#include <cmath>

namespace gluray::gl {
namespace {

/// Whether `v` is within `margin` of a whole number that is at most `last`.
bool isNearStep(double v, double margin, double last) {
  return v < last + margin && std::abs(v - std::round(v)) < margin;
}

}  // namespace

std::optional<std::array<float, 256>> labelRows(const LabelNumbers& numbers) {
  constexpr double kRounding = 1e-6;  // of a number's size
  std::array<float, 256> rows{};
  const auto count = double{numbers.count};
  if (!(count > 0)) return rows;
  for (size_t byte = 0; byte < rows.size(); ++byte) {
    const double value = static_cast<double>(byte) / 255 * double{numbers.scale} + double{numbers.bias};
    const double label = value * count;
    if (!std::isfinite(label)) return std::nullopt;
    if (label != 0 && isNearStep(label, kRounding * std::max(count, 1000.0), count)) return std::nullopt;
    // Rows beyond the last one are clamped to it.
    const double row = std::clamp(std::floor(label) / count, -1.0, 1.0);
    const auto tableRows = double(numbers.tableRows);
    if (row > 0 && isNearStep(row * tableRows, kRounding * 1000, tableRows - 1)) return std::nullopt;
    rows[byte] = static_cast<float>(row);
  }
  return rows;
}

}  // namespace gluray::gl
