#include "gl/culled/shader_slice/slice_components.h"

#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace gluray::gl::glsl {
namespace {

using Linears = std::vector<Linear>;
using Each = std::function<Linear(const Linears&)>;
/// A function with this number of arguments.
struct ByComponents {
  size_t arguments = 1;
  Each each;
};

Linear mixed(const Linears& x) {
  Linear r = sum(product(x[0], sum(Linear::constant(1), x[2], -1)), product(x[1], x[2]));
  r.range = mixOf(rangeOf(x[0]), rangeOf(x[1]), rangeOf(x[2]));
  return r;
}

Linear smaller(const Linears& x, int sign) {
  if (!x[0].isConstant() || !x[1].isConstant())
    return within((sign > 0 ? smallerOf : largerOf)(rangeOf(x[0]), rangeOf(x[1])));
  Linear r = sign * (x[0].value() - x[1].value()) < 0 ? x[0] : x[1];
  r.magnitudes[4] = std::max(x[0].magnitude(), x[1].magnitude()), r.exact = x[0].exact && x[1].exact;
  return r;
}

Linear clamped(const Linears& x) { return smaller({smaller({x[0], x[1]}, -1), x[2]}, 1); }

Linear absolute(const Linears& x) {
  if (!x[0].isConstant()) return within(absoluteOf(rangeOf(x[0])));
  return x[0].value() < 0 ? product(x[0], Linear::constant(-1)) : x[0];
}

/// `error` and `gain` have the same meaning as in computed().
ByComponents ofConstants(double (*function)(double), double error, double (*gain)(double),
                         Range (*range)(const Range&)) {
  return {1, [=](const Linears& x) {
            if (!x[0].isConstant()) return within(range(rangeOf(x[0])));
            return computed(function(x[0].value()), error, gain(x[0].value()), x);
          }};
}

/// For step functions: unknown near a step.
ByComponents stepping(double (*function)(double)) {
  return {1, [=](const Linears& x) {
            if (!x[0].isConstant()) return Linear::unknown();
            const double v = x[0].value(), slack = x[0].exact ? 0 : kRounding * x[0].magnitude();
            if (function(v - slack) != function(v + slack)) return Linear::unknown();
            return Linear::constant(function(v), x[0].exact);
          }};
}

ByComponents scaling(double by) {
  return {1, [=](const Linears& x) { return product(x[0], Linear::constant(by, false)); }};
}

/// A function whose result is known only by its range.
ByComponents ranging(Range (*range)(const Range&)) {
  return {1, [=](const Linears& x) { return within(range(rangeOf(x[0]))); }};
}

/// Results of comparisons, or of a clamp to [0, 1].
ByComponents fromZeroToOne(size_t arguments) {
  return {arguments, [](const Linears&) { return within({0, 1, true}); }};
}

double one(double) { return 1; }
double signOf(double v) { return v > 0 ? 1.0 : v < 0 ? -1.0 : 0.0; }
Range reciprocalSquareRootOf(const Range& a) { return {0, Range::kInfinity, a.number && a.low > 0}; }

const std::map<std::string_view, ByComponents>& functions() {
  static const std::map<std::string_view, ByComponents> table{
      {"mix", {3, mixed}},
      {"min", {2, [](const Linears& x) { return smaller(x, 1); }}},
      {"max", {2, [](const Linears& x) { return smaller(x, -1); }}},
      {"clamp", {3, clamped}},
      {"abs", {1, absolute}},
      {"pow", {2, [](const Linears& x) { return within(powerOf(rangeOf(x[0]), rangeOf(x[1]))); }}},
      {"step", fromZeroToOne(2)},
      {"smoothstep", fromZeroToOne(3)},
      {"fract", ranging(fractionOf)},
      {"radians", scaling(std::numbers::pi / 180)},
      {"degrees", scaling(180 / std::numbers::pi)},
      {"sin", ofConstants([](double v) { return std::sin(v); }, kRough, one, sineOf)},
      {"cos", ofConstants([](double v) { return std::cos(v); }, kRough, one, sineOf)},
      {"exp", ofConstants([](double v) { return std::exp(v); }, kRough, [](double v) { return std::exp(v); },
                          exponentialOf)},
      {"exp2", ofConstants([](double v) { return std::exp2(v); }, kRough,
                           [](double v) { return std::exp2(v); }, exponentialOf)},
      {"sqrt", ofConstants([](double v) { return std::sqrt(v); }, kRough,
                           [](double v) { return 1 / std::sqrt(v); }, squareRootOf)},
      {"inversesqrt", ofConstants([](double v) { return 1 / std::sqrt(v); }, kRough,
                                  [](double v) { return 1 / (v * std::sqrt(v)); }, reciprocalSquareRootOf)},
      {"floor", stepping([](double v) { return std::floor(v); })},
      {"ceil", stepping([](double v) { return std::ceil(v); })},
      {"sign", stepping(signOf)},
  };
  return table;
}

/// Whether function `name`, which is not in the table, returns a value of its arguments' type.
bool keepsType(std::string_view name, const Shape& shape) {
  if (shape.base != Shape::Base::floats || name == "determinant" || name == "outerProduct") return false;
  for (const std::string_view start : {"texture", "texel", "shadow", "is", "pack", "float", "noise"})
    if (name.starts_with(start)) return false;
  return true;
}

}  // namespace

Value callByComponents(std::string_view name, const Shape& shape, const std::vector<Value>& arguments) {
  const auto found = functions().find(name);
  if (found == functions().end()) return keepsType(name, shape) ? Value::unknown(shape) : Value();
  if (arguments.size() != found->second.arguments) return {};
  // mix() with booleans selects components.
  if (arguments.back().shape.base == Shape::Base::booleans) return Value::unknown(shape);
  Value r;
  r.shape = shape;
  for (size_t i = 0; i < static_cast<size_t>(shape.size()); ++i) {
    Linears x;
    for (const Value& a : arguments) x.push_back(spread(a, i));
    r.components.push_back(found->second.each(x));
  }
  return r;
}

Linear truncated(const Linear& l) {
  return stepping([](double v) { return std::trunc(v); }).each({l});
}

}  // namespace gluray::gl::glsl
