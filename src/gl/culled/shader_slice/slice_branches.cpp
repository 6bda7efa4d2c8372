// Conditional parts of a shader: interprets both branches, and joins their results. If jumps prevent this,
// all variables that they may assign become unknown.
#include "gl/culled/shader_slice/slice_functions.h"
#include "gl/culled/shader_slice/slice_run.h"

#include <algorithm>
#include <utility>

namespace gluray::gl::glsl {
namespace {

constexpr int kMaxBranchSteps = 4000;
constexpr size_t kValuesOfAStep = 64;  // values copied in the time of one step

/// Whether the statement may leave a loop around it, or continue with its next iteration.
bool jumps(const Statement& s) {
  using Kind = Statement::Kind;
  if (s.kind == Kind::leave || s.kind == Kind::next) return true;
  if (s.kind == Kind::loop || s.kind == Kind::choice) return false;
  return std::ranges::any_of(s.parts, [](const StatementPtr& part) { return part && jumps(*part); });
}

/// Sets another step limit during its lifetime.
class StepLimit {
 public:
  StepLimit(int& limit, int value) : limit_(limit), before_(std::exchange(limit, value)) {}
  ~StepLimit() { limit_ = before_; }
  StepLimit(const StepLimit&) = delete;
  StepLimit& operator=(const StepLimit&) = delete;

 private:
  int& limit_;
  const int before_;
};

template <class Values>
size_t valuesIn(const Values& values) {
  size_t all = 0;
  for (const auto& [name, value] : values) all += 1 + value.size();
  return all;
}

template <class Values>
void join(Values& values, const Values& others) {
  for (auto& [name, value] : values) {
    const auto other = others.find(name);
    value = other == others.end() ? Value() : joined(value, other->second);
  }
}

}  // namespace

SliceRun::State SliceRun::keep() {
  State state{globals_, frames_.back()};
  size_t size = valuesIn(state.globals);
  for (const Scope& scope : state.frame.scopes) size += valuesIn(scope);
  for (size_t i = 0; i < size; i += kValuesOfAStep) tick();
  return state;
}

void SliceRun::put(State state) {
  globals_ = std::move(state.globals), frames_.back() = std::move(state.frame);
}

void SliceRun::joinWith(const State& other) {
  join(globals_, other.globals);
  std::vector<Scope>& scopes = frames_.back().scopes;
  for (size_t i = 0; i < scopes.size() && i < other.frame.scopes.size(); ++i)
    join(scopes[i], other.frame.scopes[i]);
}

/// Records that the function may return here.
void SliceRun::mayEnd() {
  Frame& frame = frames_.back();
  auto ended = std::make_shared<Ended>(Ended{globals_, frame.scopes[0], frame.result});
  if (frame.ended) {
    join(ended->globals, frame.ended->globals), join(ended->parameters, frame.ended->parameters);
    ended->result = joined(ended->result, frame.ended->result);
  }
  frame.ended = std::move(ended);
}

void SliceRun::joinEnds() {
  Frame& frame = frames_.back();
  if (!frame.ended) return;
  join(globals_, frame.ended->globals), join(frame.scopes[0], frame.ended->parameters);
  frame.result = joined(frame.result, frame.ended->result);
}

SliceRun::Flow SliceRun::branch(const StatementPtr& s) {
  if (!s) return Flow::on;
  frames_.back().scopes.emplace_back();
  const Flow flow = execute(*s);
  frames_.back().scopes.pop_back();
  return flow;
}

SliceRun::Flow SliceRun::conditional(const Statement& s) {
  const std::optional<bool> chosen = truth(evaluate(*s.expression));
  if (chosen) return branch(s.parts[*chosen ? 0 : 1]);
  if (jumps(s)) return forgetAssigned(s), Flow::on;
  if (mostSteps_ < kMaxSteps) return bothBranches(s);
  const State before = keep();
  const size_t depth = frames_.size();
  try {
    const StepLimit limit(mostSteps_, std::min(kMaxSteps - 1, steps_ + kMaxBranchSteps));
    return bothBranches(s);
  } catch (const TooLong&) {
    frames_.resize(depth);
    put(before);
    return forgetAssigned(s), Flow::on;
  }
}

SliceRun::Flow SliceRun::bothBranches(const Statement& s) {
  const auto endedIn = [](State state, const Frame& frame) {
    state.frame.ended = frame.ended;
    return state;
  };
  State before = keep();
  const Flow first = branch(s.parts[0]);
  if (first == Flow::result) mayEnd();
  const State after = keep();
  put(endedIn(std::move(before), after.frame));
  const Flow second = branch(s.parts[1]);
  if (first == Flow::result) return second;
  if (second == Flow::result) {
    mayEnd();
    put(endedIn(after, frames_.back()));
  } else {
    joinWith(after);
  }
  return Flow::on;
}

void SliceRun::forgetAssigned(const Statement& statement) {
  std::set<std::string_view> names;
  bool returns = false;
  assignedBy(statement, names, returns, 0);
  forget(names);
  if (returns) throw Unfollowed();
}

/// `returns`: set if the statement may return from the function or leave a loop around it.
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
  // A return inside a loop is treated like the loop's break.
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
    // Called functions may refer to globals of the same name.
    if (const auto global = globals_.find(name); global != globals_.end()) global->second.forget();
    for (Scope& scope : frames_.back().scopes)
      if (const auto found = scope.find(name); found != scope.end()) found->second.forget();
  }
}

void SliceRun::forgetEverything() {
  for (auto& [name, value] : globals_) value.forget();
}

}  // namespace gluray::gl::glsl
