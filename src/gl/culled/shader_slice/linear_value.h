// Values in the abstract interpretation of a shader: linear in the components of one vertex attribute, with
// coefficients that are polynomials in instance attributes; or unknown. Any thread.
#pragma once
#include "gl/culled/shader_slice/value_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

namespace gluray::gl::glsl {

inline constexpr double kRounding = 1.0 / (1 << 20);  // relative error of a value computed by some operations
inline constexpr double kRough = 4096;  // error of transcendental functions in software OpenGLs, in roundings

/// A product of up to four instance attributes: one byte each, largest first; 0: none.
using InstanceProduct = uint32_t;

/// (factors[0..3] * attribute + factors[4]) * product.
struct InstanceTerm {
  InstanceProduct product = 0;
  std::array<double, 5> factors{};
  std::array<double, 5> magnitudes{};  // as those of Linear
  bool operator==(const InstanceTerm&) const = default;
};

/// factors[0..3] * attribute + factors[4], and all terms.
struct Linear {
  std::array<double, 5> factors{};
  std::array<double, 5> magnitudes{};  // sums of absolute values, for rounding bounds
  std::vector<InstanceTerm> terms;     // in ascending order of products
  int attribute = -1;                  // of the vertex; -1: none
  bool known = true;
  bool exact = true;  // the constant equals the shader's result to the bit
  Range range;        // of non-constant values, known or unknown

  static Linear unknown() {
    Linear l;
    l.known = false, l.exact = false;
    return l;
  }
  static Linear constant(double value, bool exact = true) {
    Linear l;
    l.factors[4] = value, l.magnitudes[4] = std::abs(value), l.exact = exact;
    return l;
  }
  /// Number `number` of the instance, 1 to 255.
  static Linear ofInstance(int number) {
    Linear l;
    l.exact = false;
    l.terms.push_back({static_cast<InstanceProduct>(number), {0, 0, 0, 0, 1}, {0, 0, 0, 0, 1}});
    return l;
  }
  /// Whether the value is equal for all vertices and instances.
  bool isConstant() const { return known && attribute < 0 && terms.empty(); }
  double value() const { return factors[4]; }
  double magnitude() const { return magnitudes[4]; }
};

/// Bounds of the value.
Range rangeOf(const Linear& l);
/// An unknown value with this range.
Linear within(const Range& range);
/// Join of both values: their common properties.
Linear joined(const Linear& a, const Linear& b);

Linear sum(const Linear& a, const Linear& b, double sign = 1);
Linear product(const Linear& a, const Linear& b);
Linear quotient(const Linear& a, const Linear& b);
/// Result of a function of constants: `error` in roundings of 1 + |value|; errors of inexact arguments grow
/// by at most `gain`.
Linear computed(double value, double error, double gain, const std::vector<Linear>& arguments);

/// The type of a value without its array sizes: of `rows` components, and if `columns` > 1 a matrix.
struct Shape {
  enum class Base : unsigned char { floats, integers, booleans, opaque } base = Base::opaque;
  int columns = 1, rows = 1;
  bool operator==(const Shape&) const = default;
  int size() const { return columns * rows; }
  bool isMatrix() const { return columns > 1; }
};
/// Shape of the built-in type `name`; opaque for all other types.
Shape shapeOfType(std::string_view name);

/// A value with its components (column by column), or with `items`: elements of an array, fields of a struct.
struct Value {
  Shape shape;
  std::vector<Linear> components;
  std::vector<Value> items;
  std::string_view structure;  // name of a struct
  bool isArray = false;

  /// An unknown value of this shape; opaque: even the type is unknown.
  static Value unknown(const Shape& shape = {}) {
    Value v;
    v.shape = shape;
    if (shape.base != Shape::Base::opaque)
      v.components.assign(static_cast<size_t>(shape.size()), Linear::unknown());
    return v;
  }
  static Value fromLinear(const Linear& one, Shape::Base base = Shape::Base::floats) {
    Value v;
    v.shape = {base, 1, 1}, v.components = {one};
    return v;
  }
  bool isOpaque() const { return components.empty() && items.empty(); }
  bool isScalar() const { return components.size() == 1; }
  bool areConstants() const {
    return !components.empty() &&
           std::ranges::all_of(components, [](const Linear& l) { return l.isConstant(); });
  }
  /// Number of components of this value and all its items.
  size_t size() const {
    size_t all = components.size();
    for (const Value& item : items) all += item.size();
    return all;
  }
  /// Makes the value unknown, but keeps its type.
  void forget() {
    std::ranges::fill(components, Linear::unknown());
    for (Value& item : items) item.forget();
  }
};

/// Join of both values; opaque if their types differ.
Value joined(const Value& a, const Value& b);

}  // namespace gluray::gl::glsl
