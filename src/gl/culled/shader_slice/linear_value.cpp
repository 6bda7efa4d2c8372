#include "gl/culled/shader_slice/linear_value.h"

#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace gluray::gl::glsl {
namespace {

using Factors = std::array<double, 5>;

constexpr size_t kMaxTerms = 128;

double sizeOf(const Factors& factors, const Factors& magnitudes) {
  double sum = 0;
  for (size_t i = 0; i < factors.size(); ++i) sum += std::abs(factors[i]) + magnitudes[i];
  return sum;
}

bool isFinite(const Linear& l) {
  double sum = sizeOf(l.factors, l.magnitudes);
  for (const InstanceTerm& term : l.terms) sum += sizeOf(term.factors, term.magnitudes);
  return std::isfinite(sum) && sum < std::numeric_limits<float>::max();
}

Linear checked(Linear l) {
  return isFinite(l) && l.terms.size() <= kMaxTerms ? std::move(l) : Linear::unknown();
}

void addTimes(Factors& to, const Factors& more, double sign) {
  for (size_t i = 0; i < to.size(); ++i) to[i] += sign * more[i];
}

/// The term of `product`; adds it if it is missing.
InstanceTerm& termOf(Linear& l, InstanceProduct product) {
  const auto at = std::ranges::lower_bound(l.terms, product, {}, &InstanceTerm::product);
  if (at != l.terms.end() && at->product == product) return *at;
  return *l.terms.insert(at, {product, {}, {}});
}

/// Product of both; nullopt if it has more than four values.
std::optional<InstanceProduct> productOf(InstanceProduct a, InstanceProduct b) {
  std::array<uint32_t, 8> numbers{};
  for (size_t i = 0; i < 4; ++i) numbers[i] = (a >> (8 * i)) & 0xFF, numbers[4 + i] = (b >> (8 * i)) & 0xFF;
  std::ranges::sort(numbers, std::greater<>());
  if (numbers[4] != 0) return std::nullopt;
  return numbers[0] | numbers[1] << 8 | numbers[2] << 16 | numbers[3] << 24;
}

/// Calls each(product, factors, magnitudes) for the part without instance values and for all terms.
template <class Each>
void forTerms(const Linear& l, const Each& each) {
  each(InstanceProduct{0}, l.factors, l.magnitudes);
  for (const InstanceTerm& term : l.terms) each(term.product, term.factors, term.magnitudes);
}

/// Adds form * factor to the term of `product`.
void addProduct(Linear& to, InstanceProduct product, const Factors& form, const Factors& magnitudes,
                double factor, double magnitude) {
  InstanceTerm* const term = product ? &termOf(to, product) : nullptr;
  Factors &factorsTo = term ? term->factors : to.factors,
          &magnitudesTo = term ? term->magnitudes : to.magnitudes;
  for (size_t i = 0; i < form.size(); ++i)
    factorsTo[i] += form[i] * factor, magnitudesTo[i] += magnitudes[i] * magnitude;
}

bool isZero(const InstanceTerm& term) {
  return std::ranges::all_of(term.magnitudes, [](double m) { return m == 0; });
}

Linear sumOfForms(const Linear& a, const Linear& b, double sign) {
  if (!a.known || !b.known) return Linear::unknown();
  if (a.attribute >= 0 && b.attribute >= 0 && a.attribute != b.attribute) return Linear::unknown();
  Linear r = a;
  r.attribute = std::max(a.attribute, b.attribute), r.exact = false;
  addTimes(r.factors, b.factors, sign), addTimes(r.magnitudes, b.magnitudes, 1);
  for (const InstanceTerm& term : b.terms) {
    InstanceTerm& to = termOf(r, term.product);
    addTimes(to.factors, term.factors, sign), addTimes(to.magnitudes, term.magnitudes, 1);
  }
  return checked(std::move(r));
}

Linear productOfForms(const Linear& a, const Linear& b) {
  if (!a.known || !b.known) return Linear::unknown();
  // Zero times a shader's value is assumed to be zero, which holds unless the value overflows.
  if (a.attribute >= 0 && b.attribute >= 0) return Linear::unknown();
  const Linear& form = a.attribute >= 0 ? a : b;
  const Linear& factor = a.attribute >= 0 ? b : a;
  Linear r;
  r.attribute = form.attribute, r.exact = false;
  bool fits = true;
  forTerms(form, [&](InstanceProduct x, const Factors& factors, const Factors& magnitudes) {
    forTerms(factor, [&](InstanceProduct y, const Factors& by, const Factors& magnitudesOf) {
      const std::optional<InstanceProduct> both = productOf(x, y);
      fits = fits && both;
      if (fits) addProduct(r, *both, factors, magnitudes, by[4], magnitudesOf[4]);
    });
  });
  std::erase_if(r.terms, isZero);
  return fits ? checked(std::move(r)) : Linear::unknown();
}

Linear quotientOfForms(const Linear& a, const Linear& b) {
  if (!a.known || !b.isConstant() || b.value() == 0) return Linear::unknown();
  Linear inverse = Linear::constant(1 / b.value(), false);
  inverse.magnitudes[4] = 2 * b.magnitude() / (b.value() * b.value());
  return productOfForms(a, inverse);
}

Linear withRange(Linear l, const Range& range) {
  l.range = range;
  return l;
}

bool isSame(const Linear& a, const Linear& b) {
  return a.known && b.known && a.attribute == b.attribute && a.factors == b.factors && a.terms == b.terms;
}

}  // namespace

Range rangeOf(const Linear& l) {
  return l.isConstant() ? rangeAround(l.value(), l.exact ? 0 : kRounding * l.magnitude()) : l.range;
}

Linear within(const Range& range) { return withRange(Linear::unknown(), range); }

Linear joined(const Linear& a, const Linear& b) {
  if (!isSame(a, b)) return within(hull(rangeOf(a), rangeOf(b)));
  Linear r = withRange(a, hull(a.range, b.range));
  for (size_t i = 0; i < r.magnitudes.size(); ++i)
    r.magnitudes[i] = std::max(a.magnitudes[i], b.magnitudes[i]);
  r.exact = a.exact && b.exact;
  return r;
}

Value joined(const Value& a, const Value& b) {
  const bool alike = a.shape == b.shape && a.structure == b.structure && a.isArray == b.isArray &&
                     a.components.size() == b.components.size() && a.items.size() == b.items.size();
  if (!alike) return {};
  Value r = a;
  for (size_t i = 0; i < r.components.size(); ++i) r.components[i] = joined(a.components[i], b.components[i]);
  for (size_t i = 0; i < r.items.size(); ++i) r.items[i] = joined(a.items[i], b.items[i]);
  return r;
}

Linear sum(const Linear& a, const Linear& b, double sign) {
  const Range other = rangeOf(b);
  return withRange(sumOfForms(a, b, sign), sumOf(rangeOf(a), sign < 0 ? negated(other) : other));
}

Linear product(const Linear& a, const Linear& b) {
  return withRange(productOfForms(a, b), productOf(rangeOf(a), rangeOf(b)));
}

Linear quotient(const Linear& a, const Linear& b) {
  return withRange(quotientOfForms(a, b), quotientOf(rangeOf(a), rangeOf(b)));
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
