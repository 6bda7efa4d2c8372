#include "gl/culled/shader_slice/slice_functions.h"

#include "gl/culled/shader_slice/slice_components.h"
#include "gl/culled/shader_slice/slice_matrices.h"
#include "gl/culled/shader_slice/slice_operators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace gluray::gl::glsl {
namespace {

using Base = Shape::Base;
using Linears = std::vector<Linear>;

Value dot(const Value& a, const Value& b) {
  Linear total = Linear::constant(0);
  for (size_t i = 0; i < a.components.size(); ++i)
    total = sum(total, product(a.components[i], b.components[i]));
  return Value::fromLinear(total);
}

Value cross(const Value& a, const Value& b) {
  if (a.components.size() != 3 || b.components.size() != 3) return {};
  Linears all;
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
    all.push_back(
        sum(product(a.components[j], b.components[k]), product(a.components[k], b.components[j]), -1));
  }
  return valueOf(a.shape, std::move(all));
}

Value length(const Value& v) {
  const bool number = std::ranges::all_of(v.components, [](const Linear& l) { return rangeOf(l).number; });
  if (!v.areConstants()) return Value::fromLinear(within({0, Range::kInfinity, number}));
  double squares = 0;
  for (const Linear& l : v.components) squares += l.value() * l.value();
  return Value::fromLinear(computed(std::sqrt(squares), kRough, 1, v.components));
}

Value normalize(const Value& v) {
  if (!v.areConstants()) return Value::unknown(v.shape);
  double squares = 0;
  for (const Linear& l : v.components) squares += l.value() * l.value();
  const double size = std::sqrt(squares);
  Value r = v;
  for (Linear& l : r.components)
    l = size > 0 ? computed(l.value() / size, kRough, 2 / size, v.components) : Linear::unknown();
  return r;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kComparisons{
    {{"lessThan", "<"},
     {"lessThanEqual", "<="},
     {"greaterThan", ">"},
     {"greaterThanEqual", ">="},
     {"equal", "=="},
     {"notEqual", "!="}}};

}  // namespace

bool isBuiltInFunction(std::string_view name) {
  static const std::set<std::string_view> names{"radians",
                                                "degrees",
                                                "sin",
                                                "cos",
                                                "tan",
                                                "asin",
                                                "acos",
                                                "atan",
                                                "sinh",
                                                "cosh",
                                                "tanh",
                                                "asinh",
                                                "acosh",
                                                "atanh",
                                                "pow",
                                                "exp",
                                                "log",
                                                "exp2",
                                                "log2",
                                                "sqrt",
                                                "inversesqrt",
                                                "abs",
                                                "sign",
                                                "floor",
                                                "trunc",
                                                "round",
                                                "roundEven",
                                                "ceil",
                                                "fract",
                                                "mod",
                                                "min",
                                                "max",
                                                "clamp",
                                                "mix",
                                                "step",
                                                "smoothstep",
                                                "isnan",
                                                "isinf",
                                                "fma",
                                                "ldexp",
                                                "length",
                                                "distance",
                                                "dot",
                                                "cross",
                                                "normalize",
                                                "ftransform",
                                                "faceforward",
                                                "reflect",
                                                "refract",
                                                "matrixCompMult",
                                                "outerProduct",
                                                "transpose",
                                                "determinant",
                                                "inverse",
                                                "lessThan",
                                                "lessThanEqual",
                                                "greaterThan",
                                                "greaterThanEqual",
                                                "equal",
                                                "notEqual",
                                                "any",
                                                "all",
                                                "not",
                                                "floatBitsToInt",
                                                "floatBitsToUint",
                                                "intBitsToFloat",
                                                "uintBitsToFloat",
                                                "bitCount",
                                                "findLSB",
                                                "findMSB"};
  if (names.contains(name)) return true;
  for (const std::string_view start :
       {"texture", "texel", "shadow1D", "shadow2D", "noise", "pack", "unpack", "bitfield", "dFd", "fwidth"})
    if (name.starts_with(start)) return true;
  return false;
}

Value callBuiltIn(std::string_view name, const std::vector<Value>& arguments) {
  if (arguments.empty()) return {};
  for (const Value& a : arguments)
    if (a.components.empty()) return {};
  const Value& first = arguments[0];
  const bool two = arguments.size() == 2 && arguments[1].components.size() == first.components.size();
  if (name == "dot" && two) return dot(first, arguments[1]);
  if (name == "cross" && two) return cross(first, arguments[1]);
  if (name == "length") return length(first);
  if (name == "distance" && two) return length(binaryOperator("-", first, arguments[1]));
  if (name == "normalize") return normalize(first);
  if (name == "transpose" && first.shape.isMatrix()) return transposed(first);
  if (name == "inverse" && first.shape.isMatrix()) return inverted(first);
  if (name == "any" || name == "all") return reduced(first, name == "all");
  if (name == "not") return unaryOperator("!", first);
  for (const auto& [function, op] : kComparisons)
    if (name == function && two) {
      Value r = valueOf({Base::booleans, 1, first.shape.rows}, {});
      for (size_t i = 0; i < first.components.size(); ++i)
        r.components.push_back(compared(op, first.components[i], arguments[1].components[i]));
      return r;
    }
  const Shape shape = commonShape(arguments);
  return shape.base == Base::opaque ? Value() : callByComponents(name, shape, arguments);
}

/// A vector with only the last components known. The last arguments are scalars; an argument of unknown type
/// before them provides all other components (GLSL 4.60, 5.4.2: no argument may be unused).
Value constructedEnd(const Shape& shape, const std::vector<Value>& arguments) {
  Value r = Value::unknown(shape);
  auto to = r.components.rbegin();
  for (auto from = arguments.rbegin(); from != arguments.rend() && from->isScalar(); ++from, ++to) {
    if (to == r.components.rend()) return Value::unknown(shape);
    if (from->shape.base == shape.base) *to = from->components[0];
  }
  const auto known = static_cast<size_t>(to - r.components.rbegin());
  return known + 1 == arguments.size() ? r : Value::unknown(shape);
}

Value construct(const Shape& shape, const std::vector<Value>& arguments) {
  const auto isUnknown = [](const Value& a) { return a.components.empty(); };
  if (std::ranges::any_of(arguments, isUnknown))
    return shape.isMatrix() || shape.base != Base::floats ? Value::unknown(shape)
                                                          : constructedEnd(shape, arguments);
  const auto converted = [&](Linear l, Base from) {
    if (shape.base == from || !l.known) return l;
    if (shape.base == Base::floats) return l;
    if (!l.isConstant()) return Linear::unknown();
    if (shape.base == Base::booleans)
      return l.exact || l.value() != 0 ? boolean(l.value() != 0) : Linear::unknown();
    if (from == Base::booleans) return l;
    return truncated(l);
  };
  Value r = valueOf(shape, {});
  const auto size = static_cast<size_t>(shape.size());
  if (arguments.size() == 1 && arguments[0].isScalar()) {
    const Linear one = converted(arguments[0].components[0], arguments[0].shape.base);
    for (int c = 0; c < shape.columns; ++c)
      for (int row = 0; row < shape.rows; ++row)
        r.components.push_back(shape.isMatrix() && c != row ? Linear::constant(0) : one);
    return r;
  }
  if (shape.isMatrix() && arguments.size() == 1 && arguments[0].shape.isMatrix()) {
    const Value& m = arguments[0];
    for (int c = 0; c < shape.columns; ++c)
      for (int row = 0; row < shape.rows; ++row)
        r.components.push_back(c < m.shape.columns && row < m.shape.rows
                                   ? elementOf(m, c, row)
                                   : Linear::constant(c == row ? 1 : 0));
    return r;
  }
  for (const Value& a : arguments)
    for (const Linear& l : a.components)
      if (r.components.size() < size) r.components.push_back(converted(l, a.shape.base));
  return r.components.size() == size ? r : Value::unknown(shape);
}

}  // namespace gluray::gl::glsl
