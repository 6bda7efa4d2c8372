// Conservative interval bounds of a shader value, for any input. Any thread.
#pragma once
#include <limits>

namespace gluray::gl::glsl {

/// Bounds include the rounding of single precision; a bound that single precision cannot hold is infinite.
/// Infinite values lie in ranges whose bound is infinite.
struct Range {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  double low = -kInfinity, high = kInfinity;
  bool number = false;  // the value is never NaN

  bool isFinite() const { return number && low > -kInfinity && high < kInfinity; }
  bool operator==(const Range&) const = default;
};

/// `slack`: maximum distance from `value`.
Range rangeAround(double value, double slack);
/// The smallest range that contains both.
Range hull(const Range& a, const Range& b);

Range sumOf(const Range& a, const Range& b);
Range negated(const Range& a);
Range productOf(const Range& a, const Range& b);
Range quotientOf(const Range& a, const Range& b);

// GLSL does not define min() and max() of a NaN and a number. Implementations by IEEE 754's minNum and
// maxNum, or by comparisons, return one or the other. The ranges below are valid only for those that return
// the number (FramebufferReader::replacesColors tests this).
Range smallerOf(const Range& a, const Range& b);
Range largerOf(const Range& a, const Range& b);

/// Ranges of built-in functions.
Range absoluteOf(const Range& a);
Range squareRootOf(const Range& a);
Range powerOf(const Range& base, const Range& exponent);
Range exponentialOf(const Range& a);  // exp() and exp2()
Range sineOf(const Range& a);         // sin() and cos()
Range fractionOf(const Range& a);
Range mixOf(const Range& a, const Range& b, const Range& weight);

}  // namespace gluray::gl::glsl
