// Expressions and calls of a shader.
#include "gl/culled/shader_slice/slice_functions.h"
#include "gl/culled/shader_slice/slice_run.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace gluray::gl::glsl {
namespace {

using Base = Shape::Base;

/// Whether only the language itself declares such a name.
bool isBuiltIn(std::string_view name) { return name.starts_with("gl_"); }

Value literal(std::string_view text) {
  const std::string word(text);
  const bool hexadecimal = word.starts_with("0x") || word.starts_with("0X");
  if (!hexadecimal && word.find_first_of(".eE") != word.npos) {
    const bool doubles = word.ends_with("lf") || word.ends_with("LF");
    const auto value = static_cast<double>(std::strtof(word.c_str(), nullptr));
    return doubles ? Value() : Value::fromLinear(Linear::constant(value));
  }
  if (word.ends_with("f") && !hexadecimal)
    return Value::fromLinear(Linear::constant(static_cast<double>(std::strtof(word.c_str(), nullptr))));
  return Value::fromLinear(Linear::constant(static_cast<double>(std::strtoll(word.c_str(), nullptr, 0))),
                           Base::integers);
}

}  // namespace

Value SliceRun::evaluate(const Expression& e) {
  using Kind = Expression::Kind;
  tick();
  switch (e.kind) {
    case Kind::number: return literal(e.text);
    case Kind::name: return name(e.text);
    case Kind::call: return call(e);
    case Kind::index: return index(e);
    case Kind::member: return member(e);
    case Kind::unary:
      if (e.text == "++" || e.text == "--") return step(e, false);
      return unaryOperator(e.text, evaluate(*e.parts[0]));
    case Kind::postfix: return step(e, true);
    case Kind::binary: {
      const Value left = evaluate(*e.parts[0]);
      const bool both = e.text == "&&";
      if (both || e.text == "||") {
        if (const std::optional<bool> known = truth(left); known && *known != both) return left;
        const Value right = evaluate(*e.parts[1]);
        if (!truth(left)) {  // the right side may not be executed
          std::set<std::string_view> names;
          assignedBy(*e.parts[1], names, 0);
          forget(names);
        }
        return binaryOperator(e.text, left, right);
      }
      return binaryOperator(e.text, left, evaluate(*e.parts[1]));
    }
    case Kind::ternary: return ternary(e);
    case Kind::assign: return assign(e);
    case Kind::comma: evaluate(*e.parts[0]); return evaluate(*e.parts[1]);
  }
  return {};
}

Value SliceRun::name(std::string_view name) {
  if (name == "true" || name == "false")
    return Value::fromLinear(Linear::constant(name == "true"), Base::booleans);
  if (const Value* const value = find(name)) return *value;
  if (const auto uniform = uniformGlobals_.find(name); uniform != uniformGlobals_.end())
    return uniformValue(uniform->second->path, uniform->second->variable.type, 0, 0);
  if (!isBuiltIn(name)) return {};
  if ((name == "gl_Vertex" || name == "gl_Color") && stage_ == Stage::vertex) {
    Global attribute;
    attribute.variable.type.name = "vec4", attribute.variable.name = name;
    return globals_[name] = attributeValue(attribute);
  }
  // The matrix is a product in single precision.
  if (name == "gl_ModelViewProjectionMatrix")
    return binaryOperator("*", this->name("gl_ProjectionMatrix"), this->name("gl_ModelViewMatrix"));
  TypeName type;
  type.name = name.starts_with("gl_NormalMatrix") ? "mat3" : name.find("Matrix") != name.npos ? "mat4" : "";
  return type.name.empty() ? Value() : uniformValue(std::string(name), type, 0, 0);
}

Value SliceRun::ternary(const Expression& e) {
  const std::optional<bool> chosen = truth(evaluate(*e.parts[0]));
  if (chosen) return evaluate(*e.parts[*chosen ? 1 : 2]);
  std::set<std::string_view> names;
  assignedBy(*e.parts[1], names, 0), assignedBy(*e.parts[2], names, 0);
  forget(names);
  const Value first = evaluate(*e.parts[1]);
  forget(names);
  const Value second = evaluate(*e.parts[2]);
  forget(names);
  Value both = joined(first, second);
  if (both.isOpaque()) both = first.isOpaque() ? second : first, both.forget();
  return both;
}

Value SliceRun::assign(const Expression& e) {
  Value value = evaluate(*e.parts[1]);
  if (!e.text.empty()) value = binaryOperator(e.text, evaluate(*e.parts[0]), value);
  store(*e.parts[0], value);
  return value;
}

Value SliceRun::step(const Expression& e, bool valueBefore) {
  const Value before = evaluate(*e.parts[0]);
  const Base base = before.components.empty() ? Base::opaque : before.shape.base;
  const Value one =
      Value::fromLinear(Linear::constant(1), base == Base::integers ? Base::integers : Base::floats);
  const Value after = binaryOperator(e.text.substr(0, 1), before, one);
  store(*e.parts[0], after);
  return valueBefore ? before : after;
}

Value SliceRun::call(const Expression& e) {
  std::vector<Value> arguments;
  for (const ExpressionPtr& part : e.parts) arguments.push_back(evaluate(*part));
  if (e.text == "length()")
    return arguments[0].isArray
               ? Value::fromLinear(Linear::constant(static_cast<double>(arguments[0].items.size())),
                                   Base::integers)
               : Value();
  if (e.text == "array()") return {};
  if (const Shape shape = shapeOfType(e.text); shape.base != Base::opaque) return construct(shape, arguments);
  if (const Struct* const structure = structNamed(e.text)) {
    Value v;
    v.structure = structure->name, v.items = std::move(arguments);
    return v.items.size() == structure->fields.size() ? v : Value();
  }
  const Function* found = nullptr;
  int candidates = 0;
  for (const Function& function : tree_.functions) {
    if (function.name != e.text || function.parameters.size() != arguments.size()) continue;
    bool fits = true;
    for (size_t i = 0; i < arguments.size(); ++i) {
      const Shape wanted = shapeOfType(function.parameters[i].type.name);
      fits = fits &&
             (arguments[i].components.empty() || wanted.base == Base::opaque || wanted == arguments[i].shape);
    }
    if (fits) found = &function, ++candidates;
  }
  if (candidates == 1) return call(*found, arguments, e);
  if (e.text == "ftransform") {
    Expression vertex{Expression::Kind::name, "gl_Vertex", {}},
        matrix{Expression::Kind::name, "gl_ModelViewProjectionMatrix", {}};
    return binaryOperator("*", evaluate(matrix), evaluate(vertex));
  }
  const bool own = std::ranges::any_of(tree_.functions, [&](const Function& f) { return f.name == e.text; });
  if (isBuiltInFunction(e.text) && !own) return callBuiltIn(e.text, arguments);
  // The function may change any global, and its arguments.
  for (const ExpressionPtr& part : e.parts)
    if (placeOf(*part)) store(*part, Value());
  forgetEverything();
  return {};
}

Value SliceRun::call(const Function& function, std::vector<Value>& arguments, const Expression& e) {
  if (frames_.size() > kDeepestCalls) give("functions of the shader call each other too deep");
  Frame frame;
  frame.scopes.emplace_back();
  for (size_t i = 0; i < arguments.size(); ++i) {
    const Parameter& parameter = function.parameters[i];
    Value value = defaultValue(parameter.type);
    if (parameter.in && !arguments[i].isOpaque()) value = arguments[i];
    frame.scopes[0][parameter.name] = std::move(value);
  }
  frame.result = defaultValue(function.type);
  frames_.push_back(std::move(frame));
  bool unfollowed = false;
  const size_t depth = frames_.size();
  try {
    execute(*function.body);
    joinEnds();
  } catch (const Unfollowed&) {
    frames_.resize(depth);
    unfollowed = true;
    std::set<std::string_view> names;
    bool returns = false;
    assignedBy(*function.body, names, returns, 0);
    for (const Parameter& parameter : function.parameters) names.insert(parameter.name);
    forget(names);
    frames_.back().result = defaultValue(function.type);
  }
  Frame ended = std::move(frames_.back());
  frames_.pop_back();
  for (size_t i = 0; i < arguments.size(); ++i) {
    const Parameter& parameter = function.parameters[i];
    if (!parameter.out) continue;
    Value value = ended.scopes[0][parameter.name];
    if (unfollowed) value.forget();
    store(*e.parts[i], value);
  }
  return ended.result;
}

}  // namespace gluray::gl::glsl
