#include "gl/culled/shader_slice/slice_run.h"

#include "base/ample_stack.h"
#include "gl/culled/shader_slice/slice_functions.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace gluray::gl::glsl {
void SliceRun::give(const std::string& why) { throw std::runtime_error(why); }

SliceRun::SliceRun(const Tree& tree, const UniformSource& uniforms, Stage stage, InstanceAttributes instances,
                   Varyings varyings)
    : tree_(tree),
      uniforms_(uniforms),
      stage_(stage),
      instances_(std::move(instances)),
      varyings_(std::move(varyings)) {}

Value SliceRun::run() {
  frames_.emplace_back().scopes.emplace_back();
  declareGlobals();
  const auto main = std::ranges::find_if(tree_.functions, [](const Function& f) { return f.name == "main"; });
  if (main == tree_.functions.end()) give("the shader has no main function");
  frames_.emplace_back().scopes.emplace_back();
  try {
    execute(*main->body);
    joinEnds();
  } catch (const Unfollowed&) { give("the shader may end early"); }
  return stage_ == Stage::vertex ? globals_["gl_Position"] : color();
}

/// The value of the only colour that the fragment shader writes.
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
    return std::ranges::any_of(v.components, [](const Linear& l) { return l.known || l.range != Range(); });
  };
  return isWritten(whole) ? whole : first;
}

void SliceRun::tick() {
  // Uniforms are read from OpenGL, so that a run cannot move to a thread with a larger stack.
  constexpr size_t kStackReserve = size_t{24} << 10;
  if (stackLeft() < kStackReserve) give("the shader nests too deeply for the thread's stack");
  if (++steps_ <= mostSteps_) return;
  if (mostSteps_ < kMaxSteps) throw TooLong();
  give("the shader runs for too long");
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
    case Kind::conditional: return conditional(s);
    case Kind::loop: return loop(s);
    case Kind::choice: evaluate(*s.expression); return forgetAssigned(s), Flow::on;
    case Kind::result:
      if (s.expression) frames_.back().result = evaluate(*s.expression);
      return Flow::result;
    case Kind::leave: return Flow::leave;
    case Kind::next: return Flow::next;
    case Kind::discard: return Flow::on;  // the result is for fragments that are not discarded
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

Value* SliceRun::find(std::string_view name) {
  std::vector<Scope>& scopes = frames_.back().scopes;
  for (size_t i = scopes.size(); i-- > 0;)
    if (const auto found = scopes[i].find(name); found != scopes[i].end()) return &found->second;
  const auto global = globals_.find(name);
  return global == globals_.end() ? nullptr : &global->second;
}

}  // namespace gluray::gl::glsl
