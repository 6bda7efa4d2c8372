#include "gl/glsl/functions/function_values.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gluray::gl::glsl {
namespace {

FunctionNumber sum(const FunctionNumber& a, const FunctionNumber& b, double sign) {
  return {a.constant + sign * b.constant, a.factors + sign * b.factors};
}

FunctionNumber product(const FunctionNumber& a, const FunctionNumber& b) {
  if (b.isConstant()) return {a.constant * b.constant, a.factors * b.constant};
  return {numberOf(a) * b.constant, b.factors * a.constant};
}

FunctionNumber arithmetic(char op, const FunctionNumber& a, const FunctionNumber& b) {
  switch (op) {
    case '+': return sum(a, b, 1);
    case '-': return sum(a, b, -1);
    case '*': return product(a, b);
    default: return {a.constant / numberOf(b), a.factors / numberOf(b)};
  }
}

FunctionValue transformed(const glm::dmat4& m, const FunctionValue& v) {
  if (v.size != 4) refuseFunction();
  FunctionValue out;
  out.size = 4;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      FunctionNumber& part = out.parts[static_cast<size_t>(row)];
      part = sum(part, product(v.at(column), {m[column][row], {}}), 1);
    }
  return out;
}

bool compared(std::string_view op, double a, double b) {
  if (op == "<") return a < b;
  if (op == "<=") return a <= b;
  if (op == ">") return a > b;
  if (op == ">=") return a >= b;
  if (op == "==") return a == b;
  if (op == "!=") return a != b;
  refuseFunction();
}

int commonSize(const FunctionValue& a, const FunctionValue& b) {
  if (a.isMatrix() || b.isMatrix() || (a.size != b.size && a.size != 1 && b.size != 1)) refuseFunction();
  return std::max(a.size, b.size);
}

}  // namespace

FunctionValue combined(std::string_view op, const FunctionValue& left, const FunctionValue& right) {
  if (op == "*" && left.isMatrix()) return transformed(left.matrix, right);
  const int size = commonSize(left, right);
  const bool integers = left.integer && right.integer;
  if (op != "+" && op != "-" && op != "*" && op != "/") {
    if (size != 1) refuseFunction();
    return FunctionValue::truth(compared(op, numberOf(left.parts[0]), numberOf(right.parts[0])));
  }
  if (op == "/" && integers) refuseFunction();
  FunctionValue out;
  out.size = size, out.integer = integers;
  for (int i = 0; i < size; ++i)
    out.parts[static_cast<size_t>(i)] = arithmetic(op[0], left.at(i), right.at(i));
  return out;
}

namespace {

using Of1 = double (*)(double);
using Of2 = double (*)(double, double);
using Of3 = double (*)(double, double, double);

double smoothStep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

const std::map<std::string_view, Of1>& ofOne() {
  static const std::map<std::string_view, Of1> table{
      {"abs", [](double x) { return std::abs(x); }},
      {"sign", [](double x) { return x > 0   ? 1.0
                                     : x < 0 ? -1.0
                                             : 0.0; }},
      {"floor", [](double x) { return std::floor(x); }},
      {"ceil", [](double x) { return std::ceil(x); }},
      {"fract", [](double x) { return x - std::floor(x); }},
      {"sqrt", [](double x) { return std::sqrt(x); }},
      {"sin", [](double x) { return std::sin(x); }},
      {"cos", [](double x) { return std::cos(x); }},
      {"exp", [](double x) { return std::exp(x); }},
      {"log", [](double x) { return std::log(x); }}};
  return table;
}

const std::map<std::string_view, Of2>& ofTwo() {
  static const std::map<std::string_view, Of2> table{
      {"min", [](double a, double b) { return std::min(a, b); }},
      {"max", [](double a, double b) { return std::max(a, b); }},
      {"mod", [](double a, double b) { return a - b * std::floor(a / b); }},
      {"pow", [](double a, double b) { return std::pow(a, b); }},
      {"step", [](double edge, double x) { return x < edge ? 0.0 : 1.0; }}};
  return table;
}

const std::map<std::string_view, Of3>& ofThree() {
  static const std::map<std::string_view, Of3> table{
      {"clamp", [](double x, double a, double b) { return std::min(std::max(x, a), b); }},
      {"mix", [](double a, double b, double share) { return a * (1 - share) + b * share; }},
      {"smoothstep", smoothStep}};
  return table;
}

/// The function of `table`; refuses names that it lacks.
template <class Function>
Function find(const std::map<std::string_view, Function>& table, std::string_view name) {
  const auto found = table.find(name);
  return found == table.end() ? (refuseFunction(), nullptr) : found->second;
}

}  // namespace

FunctionValue builtIn(std::string_view name, const FunctionValue* arguments, size_t count) {
  if (count < 1 || count > 3) refuseFunction();
  FunctionValue out;
  for (size_t i = 0; i < count; ++i) out.size = commonSize(out, arguments[i]);
  for (int i = 0; i < out.size; ++i) {
    const auto argument = [&](size_t a) { return numberOf(arguments[a].at(i)); };
    double& part = out.parts[static_cast<size_t>(i)].constant;
    if (count == 1) part = find(ofOne(), name)(argument(0));
    if (count == 2) part = find(ofTwo(), name)(argument(0), argument(1));
    if (count == 3) part = find(ofThree(), name)(argument(0), argument(1), argument(2));
  }
  return out;
}

}  // namespace gluray::gl::glsl
