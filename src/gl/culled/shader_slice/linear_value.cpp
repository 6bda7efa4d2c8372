#include "gl/culled/shader_slice/linear_value.h"

#include <limits>

namespace gluray::gl::glsl {
namespace {

bool isFinite(const Linear& l) {
  double sum = 0;
  for (size_t i = 0; i < l.factors.size(); ++i) sum += std::abs(l.factors[i]) + l.magnitudes[i];
  return std::isfinite(sum) && sum < std::numeric_limits<float>::max();
}

Linear checked(const Linear& l) { return isFinite(l) ? l : Linear::unknown(); }

}  // namespace

Linear sum(const Linear& a, const Linear& b, double sign) {
  if (!a.known || !b.known) return Linear::unknown();
  if (a.attribute >= 0 && b.attribute >= 0 && a.attribute != b.attribute) return Linear::unknown();
  Linear r;
  r.attribute = std::max(a.attribute, b.attribute), r.exact = false;
  for (size_t i = 0; i < r.factors.size(); ++i) {
    r.factors[i] = a.factors[i] + sign * b.factors[i];
    r.magnitudes[i] = a.magnitudes[i] + b.magnitudes[i];
  }
  return checked(r);
}

Linear product(const Linear& a, const Linear& b) {
  if (!a.known || !b.known) return Linear::unknown();
  // Zero times anything that a shader computes may not be zero, but is where nothing overflows.
  if (a.attribute >= 0 && b.attribute >= 0) return Linear::unknown();
  const Linear& form = a.attribute >= 0 ? a : b;
  const Linear& factor = a.attribute >= 0 ? b : a;
  Linear r;
  r.attribute = form.attribute, r.exact = false;
  for (size_t i = 0; i < r.factors.size(); ++i) {
    r.factors[i] = form.factors[i] * factor.value();
    r.magnitudes[i] = form.magnitudes[i] * factor.magnitude();
  }
  return checked(r);
}

Linear quotient(const Linear& a, const Linear& b) {
  if (!a.known || !b.isConstant() || b.value() == 0) return Linear::unknown();
  Linear inverse = Linear::constant(1 / b.value(), false);
  inverse.magnitudes[4] = 2 * b.magnitude() / (b.value() * b.value());
  return product(a, inverse);
}

Linear computed(double value, double error, double gain, const std::vector<Linear>& arguments) {
  double magnitude = error * (1 + std::abs(value));
  for (const Linear& l : arguments) magnitude += l.exact ? 0 : gain * l.magnitude();
  Linear r = Linear::constant(value, false);
  r.magnitudes[4] = std::max(magnitude, std::abs(value));
  return checked(r);
}

Shape shapeOfType(std::string_view name) {
  using Base = Shape::Base;
  const auto digit = [](char c) { return c >= '2' && c <= '4' ? c - '0' : 0; };
  const auto vector = [&](std::string_view start, Base base) -> Shape {
    if (!name.starts_with(start) || name.size() != start.size() + 1) return {};
    const int rows = digit(name.back());
    return rows ? Shape{base, 1, rows} : Shape{};
  };
  if (name == "float") return {Base::floats, 1, 1};
  if (name == "int" || name == "uint") return {Base::integers, 1, 1};
  if (name == "bool") return {Base::booleans, 1, 1};
  for (const Shape& shape : {vector("vec", Base::floats), vector("ivec", Base::integers),
                             vector("uvec", Base::integers), vector("bvec", Base::booleans)})
    if (shape.base != Base::opaque) return shape;
  if (!name.starts_with("mat")) return {};
  const int columns = name.size() > 3 ? digit(name[3]) : 0;
  const int rows = name.size() == 4 ? columns : name.size() == 6 && name[4] == 'x' ? digit(name[5]) : 0;
  return columns && rows ? Shape{Base::floats, columns, rows} : Shape{};
}

}  // namespace gluray::gl::glsl
