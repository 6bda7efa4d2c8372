#include "gl/culled/shader_slice/slice_run.h"

#include "gl/culled/shader_slice/slice_functions.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace gluray::gl::glsl {
namespace {

constexpr int kMostSteps = 200'000;

}  // namespace

void SliceRun::give(const std::string& why) { throw std::runtime_error(why); }

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
        shapeOfType(variable.type.name).base != Shape::Base::opaque)
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

}  // namespace gluray::gl::glsl
