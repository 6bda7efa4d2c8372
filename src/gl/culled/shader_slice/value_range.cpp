#include "gl/culled/shader_slice/value_range.h"

#include <algorithm>
#include <cmath>

namespace gluray::gl::glsl {
namespace {

constexpr double kInfinity = Range::kInfinity;
constexpr double kOneRounding = 1.0 / (1 << 21);  // relative error of one operation
constexpr double kRoughly = 1.0 / (1 << 10);      // relative error of a transcendental function

/// The range with its bounds moved outwards by the relative error `rounding` and by the smallest normal
/// number.
Range widened(double low, double high, bool number, double rounding = kOneRounding) {
  constexpr double kMax = std::numeric_limits<float>::max(), kMin = std::numeric_limits<float>::min();
  low -= rounding * std::abs(low) + (low == 0 ? 0 : kMin);
  high += rounding * std::abs(high) + (high == 0 ? 0 : kMin);
  if (!(low > -kMax)) low = -kInfinity;  // also if it is NaN
  if (!(high < kMax)) high = kInfinity;
  return {low, high, number};
}

bool mayBeInfinite(const Range& r) { return r.low == -kInfinity || r.high == kInfinity; }
bool mayBeZero(const Range& r) { return r.low <= 0 && r.high >= 0; }

double times(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

}  // namespace

Range rangeAround(double value, double slack) {
  if (!std::isfinite(value) || !std::isfinite(slack)) return {};
  return slack == 0 ? Range{value, value, true} : widened(value - slack, value + slack, true);
}

Range hull(const Range& a, const Range& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high), a.number && b.number};
}

Range sumOf(const Range& a, const Range& b) {
  const bool cancels =
      (a.high == kInfinity && b.low == -kInfinity) || (a.low == -kInfinity && b.high == kInfinity);
  return widened(a.low + b.low, a.high + b.high, a.number && b.number && !cancels);
}

Range negated(const Range& a) { return {-a.high, -a.low, a.number}; }

Range productOf(const Range& a, const Range& b) {
  const double corners[] = {times(a.low, b.low), times(a.low, b.high), times(a.high, b.low),
                            times(a.high, b.high)};
  const bool undefined = (mayBeInfinite(a) && mayBeZero(b)) || (mayBeInfinite(b) && mayBeZero(a));
  return widened(*std::ranges::min_element(corners), *std::ranges::max_element(corners),
                 a.number && b.number && !undefined);
}

Range quotientOf(const Range& a, const Range& b) {
  if (mayBeZero(b) || !b.isFinite()) return {};
  return productOf(a, widened(1 / b.high, 1 / b.low, true));
}

Range smallerOf(const Range& a, const Range& b) { return negated(largerOf(negated(a), negated(b))); }

Range largerOf(const Range& a, const Range& b) {
  Range r{std::max(a.low, b.low), std::max(a.high, b.high), a.number || b.number};
  if (!a.number) r.low = b.low;  // the result may be b
  if (!b.number) r.low = std::min(r.low, a.low);
  return r;
}

Range absoluteOf(const Range& a) {
  const double most = std::max(std::abs(a.low), std::abs(a.high));
  return {mayBeZero(a) ? 0 : std::min(std::abs(a.low), std::abs(a.high)), most, a.number};
}

Range squareRootOf(const Range& a) {
  if (a.low < 0) return {0, kInfinity, false};
  return widened(std::sqrt(a.low), std::sqrt(a.high), a.number, kRoughly);
}

Range powerOf(const Range& base, const Range& exponent) {
  if (base.low < 0) return {};  // pow() is undefined for negative bases
  const bool number = base.isFinite() && exponent.isFinite() && exponent.low > 0;
  return {0, number && base.high <= 1 ? 1 + kRoughly : kInfinity, number};
}

Range exponentialOf(const Range& a) { return {0, kInfinity, a.number}; }

Range sineOf(const Range& a) { return {-1 - kRoughly, 1 + kRoughly, a.isFinite()}; }

Range fractionOf(const Range& a) { return {0, 1, a.isFinite()}; }

Range mixOf(const Range& a, const Range& b, const Range& weight) {
  const bool between = weight.number && weight.low >= 0 && weight.high <= 1 && a.isFinite() && b.isFinite();
  if (!between) return sumOf(productOf(a, sumOf({1, 1, true}, negated(weight))), productOf(b, weight));
  const Range around = hull(a, b);
  const double slack = kOneRounding * 4 * std::max(std::abs(around.low), std::abs(around.high));
  return widened(around.low - slack, around.high + slack, true);
}

}  // namespace gluray::gl::glsl
