#include "gl/culled/shader_slice/slice_operators.h"

#include "gl/culled/shader_slice/slice_components.h"
#include "gl/culled/shader_slice/slice_functions.h"
#include "gl/culled/shader_slice/slice_matrices.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>

namespace gluray::gl::glsl {
namespace {

using Base = Shape::Base;

/// The order of `a` and `b`, if rounding cannot change it.
std::optional<int> order(const Linear& a, const Linear& b) {
  if (!a.isConstant() || !b.isConstant()) return std::nullopt;
  const double apart = a.value() - b.value();
  const bool exact = a.exact && b.exact;
  if (!exact && !(std::abs(apart) > kRounding * (a.magnitude() + b.magnitude()))) return std::nullopt;
  return apart < 0 ? -1 : apart > 0 ? 1 : 0;
}

Linear integerOperator(std::string_view op, const Linear& a, const Linear& b) {
  if (!a.isConstant() || !b.isConstant()) return Linear::unknown();
  constexpr double kMax = 1 << 30;
  const double x = a.value(), y = b.value();
  if (std::abs(x) > kMax || std::abs(y) > kMax) return Linear::unknown();
  const auto i = static_cast<int64_t>(x), j = static_cast<int64_t>(y);
  int64_t result = 0;
  if (op == "+")
    result = i + j;
  else if (op == "-")
    result = i - j;
  else if (op == "*")
    result = i * j;
  else if (op == "/" && j != 0)
    result = i / j;
  else if (op == "%" && j > 0 && i >= 0)
    result = i % j;
  else if (op == "&")
    result = i & j;
  else if (op == "|")
    result = i | j;
  else if (op == "^")
    result = i ^ j;
  else if (op == "<<" && j >= 0 && j < 31 && i >= 0)
    result = i << j;
  else if (op == ">>" && j >= 0 && j < 31)
    result = i >> j;
  else
    return Linear::unknown();
  if (std::abs(static_cast<double>(result)) > kMax) return Linear::unknown();
  return Linear::constant(static_cast<double>(result));
}

Linear arithmetic(std::string_view op, Base base, const Linear& a, const Linear& b) {
  if (base == Base::integers) return integerOperator(op, a, b);
  if (base != Base::floats) return Linear::unknown();
  if (op == "+") return sum(a, b);
  if (op == "-") return sum(a, b, -1);
  if (op == "*") return product(a, b);
  if (op == "/") return quotient(a, b);
  return Linear::unknown();
}

}  // namespace

Linear boolean(bool b) { return Linear::constant(b ? 1 : 0); }

Linear compared(std::string_view op, const Linear& a, const Linear& b) {
  const std::optional<int> o = order(a, b);
  if (!o) return Linear::unknown();
  if (op == "<") return boolean(*o < 0);
  if (op == ">") return boolean(*o > 0);
  if (op == "<=") return boolean(*o <= 0);
  if (op == ">=") return boolean(*o >= 0);
  return boolean((*o == 0) == (op == "=="));
}

Value reduced(const Value& v, bool all) {
  bool unknown = false;
  for (const Linear& l : v.components) {
    if (l.isConstant() && (l.value() != 0) != all) return Value::fromLinear(boolean(!all), Base::booleans);
    unknown = unknown || !l.isConstant();
  }
  return Value::fromLinear(unknown ? Linear::unknown() : boolean(all), Base::booleans);
}

Shape commonShape(const std::vector<Value>& values) {
  Shape common;
  for (const Value& v : values) {
    if (v.components.empty()) return {};
    if (common.base == Base::opaque || (common.size() == 1 && !v.isScalar())) common = v.shape;
    if (!v.isScalar() && v.shape.size() != common.size()) return {};
  }
  return common;
}

Value binaryOperator(std::string_view op, const Value& a, const Value& b) {
  static const std::set<std::string_view> comparisons{"<", ">", "<=", ">=", "==", "!="};
  const Shape yes{Base::booleans, 1, 1};
  if (comparisons.contains(op)) {
    if (a.components.empty() || a.components.size() != b.components.size()) return Value::unknown(yes);
    if (a.isScalar())
      return Value::fromLinear(compared(op, a.components[0], b.components[0]), Base::booleans);
    Value same = valueOf({Base::booleans, 1, a.shape.size()}, {});
    for (size_t i = 0; i < a.components.size(); ++i)
      same.components.push_back(compared("==", a.components[i], b.components[i]));
    const Value all = reduced(same, true);
    return op == "==" ? all : unaryOperator("!", all);
  }
  if (op == "&&" || op == "||" || op == "^^") {
    const std::optional<bool> x = truth(a), y = truth(b);
    if (op == "&&" && ((x && !*x) || (y && !*y))) return Value::fromLinear(boolean(false), Base::booleans);
    if (op == "||" && ((x && *x) || (y && *y))) return Value::fromLinear(boolean(true), Base::booleans);
    if (!x || !y) return Value::unknown(yes);
    return Value::fromLinear(boolean(op == "&&"   ? *x && *y
                                     : op == "||" ? *x || *y
                                                  : *x != *y),
                             Base::booleans);
  }
  if (a.components.empty() || b.components.empty()) return {};
  const bool matrices = a.shape.isMatrix() || b.shape.isMatrix();
  if (op == "*" && matrices && !a.isScalar() && !b.isScalar()) return multiplied(a, b);
  const Shape shape = commonShape({a, b});
  if (shape.base == Base::opaque) return {};
  const Base base = a.shape.base == Base::floats || b.shape.base == Base::floats ? Base::floats : shape.base;
  Value r = valueOf({base, shape.columns, shape.rows}, {});
  for (size_t i = 0; i < static_cast<size_t>(shape.size()); ++i)
    r.components.push_back(arithmetic(op, base, spread(a, i), spread(b, i)));
  return r;
}

Value unaryOperator(std::string_view op, const Value& a) {
  if (op == "+") return a;
  Value r = a;
  for (Linear& l : r.components) {
    const bool exact = l.exact;
    if (op == "-")
      l = product(l, Linear::constant(-1)), l.exact = l.known && exact;
    else if (op == "!" && l.isConstant())
      l = boolean(l.value() == 0);
    else
      l = Linear::unknown();
  }
  return r;
}

std::vector<size_t> swizzled(std::string_view field, size_t components) {
  for (const std::string_view names : {"xyzw", "rgba", "stpq"}) {
    std::vector<size_t> all;
    for (const char c : field)
      if (const size_t i = names.find(c); i != names.npos && i < components) all.push_back(i);
    if (all.size() == field.size() && all.size() <= 4) return all;
  }
  return {};
}

std::optional<bool> truth(const Value& v) {
  if (!v.isScalar() || !v.components[0].isConstant()) return std::nullopt;
  return v.components[0].value() != 0;
}

std::optional<long> integerOf(const Value& v) {
  if (!v.isScalar() || !v.components[0].isConstant() || v.shape.base == Base::floats) return std::nullopt;
  return static_cast<long>(v.components[0].value());
}

}  // namespace gluray::gl::glsl
