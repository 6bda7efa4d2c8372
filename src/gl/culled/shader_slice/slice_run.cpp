#include "gl/culled/shader_slice/slice_run.h"

#include "gl/culled/shader_slice/slice_functions.h"
#include "gl/families/glsl_tokens.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace gluray::gl::glsl {
namespace {

using Base = Shape::Base;

constexpr int kMostSteps = 200'000, kDeepestCalls = 32;
constexpr size_t kMostElements = 4096;
constexpr size_t kDrawBuffers = 8;

/// A part of a function may or may not be executed, and ends the function.
struct Unfollowed {};

[[noreturn]] void give(const std::string& why) { throw std::runtime_error(why); }

/// Whether the names of variables begin so only in the language itself.
bool isBuiltIn(std::string_view name) { return name.starts_with("gl_"); }

Value literal(std::string_view text) {
  const std::string word(text);
  const bool hexadecimal = word.starts_with("0x") || word.starts_with("0X");
  if (!hexadecimal && word.find_first_of(".eE") != word.npos) {
    const bool doubles = word.ends_with("lf") || word.ends_with("LF");
    const auto value = static_cast<double>(std::strtof(word.c_str(), nullptr));
    return doubles ? Value() : Value::of(Linear::constant(value));
  }
  if (word.ends_with("f") && !hexadecimal)
    return Value::of(Linear::constant(static_cast<double>(std::strtof(word.c_str(), nullptr))));
  return Value::of(Linear::constant(static_cast<double>(std::strtoll(word.c_str(), nullptr, 0))),
                   Base::integers);
}

}  // namespace

SliceRun::SliceRun(const Tree& tree, const UniformSource& uniforms, Stage stage, InstanceAttributes instances)
    : tree_(tree), uniforms_(uniforms), stage_(stage), instances_(std::move(instances)) {}

Value SliceRun::run() {
  frames_.emplace_back().scopes.emplace_back();
  declareGlobals();
  const auto main = std::ranges::find_if(tree_.functions, [](const Function& f) { return f.name == "main"; });
  if (main == tree_.functions.end()) give("the shader has no main function");
  frames_.emplace_back().scopes.emplace_back();
  try {
    execute(*main->body);
  } catch (const Unfollowed&) { give("the shader may end early"); }
  return stage_ == Stage::vertex ? globals_["gl_Position"] : color();
}

/// Of the only colour that the fragment shader writes.
Value SliceRun::color() const {
  const auto valueOf = [&](std::string_view name) { return globals_.find(name)->second; };
  const Global* output = nullptr;
  for (const Global& global : tree_.globals) {
    if (global.storage != Global::Storage::output) continue;
    if (output) give("the fragment shader has several outputs");
    output = &global;
  }
  if (output) return valueOf(output->variable.name);
  Value whole = valueOf("gl_FragColor"), first = valueOf("gl_FragData").items[0];
  const auto isWritten = [](const Value& v) {
    return std::ranges::any_of(v.components, [](const Linear& l) { return l.known; });
  };
  return isWritten(whole) ? whole : first;
}

void SliceRun::declareGlobals() {
  using Storage = Global::Storage;
  const Value fourFloats = Value::unknown({Base::floats, 1, 4});
  if (stage_ == Stage::vertex) {
    globals_["gl_Position"] = fourFloats;
  } else {
    globals_["gl_FragColor"] = fourFloats;
    Value& data = globals_["gl_FragData"];
    data.isArray = true, data.items.assign(kDrawBuffers, fourFloats);
  }
  for (const Global& global : tree_.globals) {
    const std::string_view name = global.variable.name;
    if (global.storage == Storage::uniform)
      uniformGlobals_[name] = &global;
    else if (global.storage == Storage::attribute && stage_ == Stage::vertex)
      globals_[name] = attributeValue(global);
    else if (global.variable.value && global.storage != Storage::other)
      globals_[name] = evaluate(*global.variable.value);
    else
      globals_[name] = defaultValue(global.variable.type);
  }
}

Value SliceRun::attributeValue(const Global& global) {
  const Shape shape = shapeOfType(global.variable.type.name);
  Value v = defaultValue(global.variable.type);
  if (shape.base != Base::floats || v.components.empty()) return v;
  const std::string name(global.variable.name);
  if (instances_.contains(name)) return instanceValue(name, shape);
  if (shape.isMatrix()) return v;
  attributes_.push_back({name, shape.rows});
  for (int i = 0; i < shape.rows; ++i) {
    Linear l;
    l.attribute = static_cast<int>(attributes_.size()) - 1, l.exact = false;
    l.factors[static_cast<size_t>(i)] = l.magnitudes[static_cast<size_t>(i)] = 1;
    v.components[static_cast<size_t>(i)] = l;
  }
  return v;
}

Value SliceRun::instanceValue(const std::string& name, const Shape& shape) {
  constexpr int kMostNumbers = 255;
  Value v = Value::unknown(shape);
  if (instanceNumbers_ + shape.size() > kMostNumbers) return v;
  for (int c = 0; c < shape.columns; ++c) instanceColumns_.push_back({name, c, shape.rows});
  for (Linear& l : v.components) l = Linear::ofInstance(++instanceNumbers_);
  return v;
}

const Struct* SliceRun::structNamed(std::string_view name) const {
  const auto found = std::ranges::find_if(tree_.structs, [&](const Struct& s) { return s.name == name; });
  return found == tree_.structs.end() ? nullptr : &*found;
}

std::optional<size_t> SliceRun::sizeOf(const TypeName& type, size_t dimension) {
  if (!type.sizes[dimension]) return std::nullopt;
  const std::optional<long> size = integerOf(evaluate(*type.sizes[dimension]));
  if (!size || *size < 1 || *size > static_cast<long>(kMostElements)) return std::nullopt;
  return static_cast<size_t>(*size);
}

Value SliceRun::defaultValue(const TypeName& type, size_t dimension, int depth) {
  if (depth > 8) return {};
  tick();
  if (dimension < type.sizes.size()) {
    const std::optional<size_t> size = sizeOf(type, dimension);
    if (!size) return {};
    Value array;
    array.isArray = true;
    for (size_t i = 0; i < *size; ++i) array.items.push_back(defaultValue(type, dimension + 1, depth + 1));
    return array;
  }
  const Struct* const structure = structNamed(type.name);
  if (!structure) return Value::unknown(shapeOfType(type.name));
  Value v;
  v.structure = structure->name;
  for (const Variable& field : structure->fields) v.items.push_back(defaultValue(field.type, 0, depth + 1));
  return v;
}

Value SliceRun::uniformValue(const std::string& path, const TypeName& type, size_t dimension, int depth) {
  tick();
  if (depth > 8) return {};
  if (dimension < type.sizes.size()) {
    const std::optional<size_t> size = sizeOf(type, dimension);
    if (!size) return {};
    Value array;
    array.isArray = true;
    for (size_t i = 0; i < *size; ++i)
      array.items.push_back(
          uniformValue(path + "[" + std::to_string(i) + "]", type, dimension + 1, depth + 1));
    return array;
  }
  if (const Struct* const structure = structNamed(type.name)) {
    Value v;
    v.structure = structure->name;
    for (const Variable& field : structure->fields)
      v.items.push_back(uniformValue(path + "." + std::string(field.name), field.type, 0, depth + 1));
    return v;
  }
  const auto known = read_.find(path);
  if (known != read_.end()) return known->second;
  Value v = Value::unknown(shapeOfType(type.name));
  std::vector<double> components;
  if (!v.components.empty() && uniforms_.read(path, components) && components.size() == v.components.size())
    for (size_t i = 0; i < components.size(); ++i) v.components[i] = Linear::constant(components[i]);
  return read_[path] = v;
}

void SliceRun::tick() {
  if (++steps_ > kMostSteps) give("the shader runs for too long");
}

SliceRun::Flow SliceRun::executeAll(const std::vector<StatementPtr>& statements) {
  for (const StatementPtr& statement : statements)
    if (const Flow flow = execute(*statement); flow != Flow::on) return flow;
  return Flow::on;
}

SliceRun::Flow SliceRun::execute(const Statement& s) {
  using Kind = Statement::Kind;
  tick();
  switch (s.kind) {
    case Kind::expression: evaluate(*s.expression); return Flow::on;
    case Kind::declaration:
      for (const Variable& variable : s.variables) declare(variable);
      return Flow::on;
    case Kind::block: {
      frames_.back().scopes.emplace_back();
      const Flow flow = executeAll(s.parts);
      frames_.back().scopes.pop_back();
      return flow;
    }
    case Kind::conditional: {
      const std::optional<bool> chosen = truth(evaluate(*s.expression));
      if (!chosen) return forgetAssigned(s), Flow::on;
      const StatementPtr& part = s.parts[*chosen ? 0 : 1];
      if (!part) return Flow::on;
      frames_.back().scopes.emplace_back();
      const Flow flow = execute(*part);
      frames_.back().scopes.pop_back();
      return flow;
    }
    case Kind::loop: return loop(s);
    case Kind::choice: evaluate(*s.expression); return forgetAssigned(s), Flow::on;
    case Kind::result:
      if (s.expression) frames_.back().result = evaluate(*s.expression);
      return Flow::result;
    case Kind::leave: return Flow::leave;
    case Kind::next: return Flow::next;
    case Kind::discard: return Flow::on;  // the value of fragments that are kept is asked for
    case Kind::empty: return Flow::on;
  }
  return Flow::on;
}

SliceRun::Flow SliceRun::loop(const Statement& s) {
  frames_.back().scopes.emplace_back();
  const size_t scopes = frames_.back().scopes.size();
  Flow flow = Flow::on;
  if (s.parts[0]) execute(*s.parts[0]);
  for (bool first = true;; first = false) {
    tick();
    if (s.expression && !(first && s.conditionLast)) {
      const std::optional<bool> goesOn = truth(evaluate(*s.expression));
      if (!goesOn) {
        forgetAssigned(s);
        break;
      }
      if (!*goesOn) break;
    }
    frames_.back().scopes.emplace_back();
    flow = execute(*s.parts[1]);
    frames_.back().scopes.resize(scopes);
    if (flow == Flow::leave || flow == Flow::result) break;
    if (s.step) evaluate(*s.step);
  }
  frames_.back().scopes.resize(scopes - 1);
  return flow == Flow::result ? flow : Flow::on;
}

void SliceRun::declare(const Variable& variable) {
  Value value = defaultValue(variable.type);
  if (variable.value) {
    Value given = evaluate(*variable.value);
    if (!given.isOpaque() && variable.type.sizes.empty() &&
        shapeOfType(variable.type.name).base != Base::opaque)
      given = construct(shapeOfType(variable.type.name), {given});
    if (!given.isOpaque()) value = std::move(given);
  }
  frames_.back().scopes.back()[variable.name] = std::move(value);
}

void SliceRun::forgetAssigned(const Statement& statement) {
  std::set<std::string_view> names;
  bool returns = false;
  assignedBy(statement, names, returns, 0);
  forget(names);
  if (returns) throw Unfollowed();
}

/// `returns`: it may leave the function, or a loop around it.
void SliceRun::assignedBy(const Statement& s, std::set<std::string_view>& names, bool& returns, int depth) {
  using Kind = Statement::Kind;
  tick();
  if (s.kind == Kind::result) returns = true;
  if (s.kind == Kind::leave || s.kind == Kind::next) returns = true;
  bool inner = false;
  const bool jumpsStayInside = s.kind == Kind::loop || s.kind == Kind::choice;
  if (s.expression) assignedBy(*s.expression, names, depth);
  if (s.step) assignedBy(*s.step, names, depth);
  for (const Variable& variable : s.variables)
    if (variable.value) assignedBy(*variable.value, names, depth);
  for (const StatementPtr& part : s.parts)
    if (part) assignedBy(*part, names, jumpsStayInside ? inner : returns, depth);
  // A return inside of a loop looks like its break here.
  returns = returns || inner;
}

void SliceRun::assignedBy(const Expression& e, std::set<std::string_view>& names, int depth) {
  using Kind = Expression::Kind;
  tick();
  if (depth > kDeepestCalls) give("functions of the shader call each other too deep");
  const auto root = [](const Expression* of) {
    while (of->kind == Kind::index || of->kind == Kind::member) of = of->parts[0].get();
    return of->kind == Kind::name ? of->text : std::string_view();
  };
  const bool steps = e.kind == Kind::postfix || (e.kind == Kind::unary && (e.text == "++" || e.text == "--"));
  if (e.kind == Kind::assign || steps) names.insert(root(e.parts[0].get()));
  if (e.kind == Kind::call && !isBuiltInFunction(e.text)) {
    for (const ExpressionPtr& part : e.parts) names.insert(root(part.get()));
    for (const Function& function : tree_.functions) {
      if (function.name != e.text) continue;
      bool returns = false;
      assignedBy(*function.body, names, returns, depth + 1);
    }
  }
  for (const ExpressionPtr& part : e.parts) assignedBy(*part, names, depth);
}

void SliceRun::forget(const std::set<std::string_view>& names) {
  for (const std::string_view name : names) {
    // Functions that were called may mean globals of the same name.
    if (const auto global = globals_.find(name); global != globals_.end()) global->second.forget();
    for (Scope& scope : frames_.back().scopes)
      if (const auto found = scope.find(name); found != scope.end()) found->second.forget();
  }
}

void SliceRun::forgetEverything() {
  for (auto& [name, value] : globals_) value.forget();
}

Value* SliceRun::find(std::string_view name) {
  std::vector<Scope>& scopes = frames_.back().scopes;
  for (size_t i = scopes.size(); i-- > 0;)
    if (const auto found = scopes[i].find(name); found != scopes[i].end()) return &found->second;
  const auto global = globals_.find(name);
  return global == globals_.end() ? nullptr : &global->second;
}

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
  if (name == "true" || name == "false") return Value::of(Linear::constant(name == "true"), Base::booleans);
  if (const Value* const value = find(name)) return *value;
  if (const auto uniform = uniformGlobals_.find(name); uniform != uniformGlobals_.end())
    return uniformValue(uniform->second->path, uniform->second->variable.type, 0, 0);
  if (!isBuiltIn(name)) return {};
  if (name == "gl_Vertex" && stage_ == Stage::vertex) {
    Global vertex;
    vertex.variable.type.name = "vec4", vertex.variable.name = "gl_Vertex";
    return globals_["gl_Vertex"] = attributeValue(vertex);
  }
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
  Value v = evaluate(*e.parts[1]);
  forget(names);
  v.forget();
  return v;
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
  const Value one = Value::of(Linear::constant(1), base == Base::integers ? Base::integers : Base::floats);
  const Value after = binaryOperator(e.text.substr(0, 1), before, one);
  store(*e.parts[0], after);
  return valueBefore ? before : after;
}

Value SliceRun::call(const Expression& e) {
  std::vector<Value> arguments;
  for (const ExpressionPtr& part : e.parts) arguments.push_back(evaluate(*part));
  if (e.text == "length()")
    return arguments[0].isArray
               ? Value::of(Linear::constant(static_cast<double>(arguments[0].items.size())), Base::integers)
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
  // It may change any global, and what it is given.
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
