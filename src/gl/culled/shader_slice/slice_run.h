// Abstract interpretation of a vertex or fragment shader with the current values of its uniforms. Any thread.
#pragma once
#include "gl/culled/shader_slice/linear_value.h"
#include "gl/culled/shader_slice/position_slice.h"
#include "gl/glsl/parser/glsl_tree.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl::glsl {

class SliceRun {
 public:
  enum class Stage { vertex, fragment };

  /// `tree` and `uniforms` must outlive it. `instances`: attributes with one value per instance. `varyings`:
  /// inputs of a fragment shader.
  SliceRun(const Tree& tree, const UniformSource& uniforms, Stage stage, InstanceAttributes instances = {},
           Varyings varyings = {});

  /// Returns gl_Position, or the colour of a fragment that is not discarded, at the end of main(). Throws
  /// std::runtime_error with the reason if it is unknown.
  Value run();
  /// Outputs of a vertex shader. Call after run().
  Varyings varyings() const;
  /// Name of attribute number `i`.
  const std::string& attribute(int i) const { return attributes_[static_cast<size_t>(i)].name; }
  /// Number of components in the declaration of attribute `i`.
  int componentsOf(int i) const { return attributes_[static_cast<size_t>(i)].components; }
  /// Columns of instance attributes. Their components are numbered consecutively, from 1.
  const std::vector<InstanceColumn>& instanceColumns() const { return instanceColumns_; }

 private:
  static constexpr int kDeepestCalls = 32;
  static constexpr int kMaxSteps = 200'000;
  enum class Flow { on, leave, next, result };
  /// Thrown if a conditional part may return from the function.
  struct Unfollowed {};
  /// Thrown if a conditional part takes too many steps.
  struct TooLong {};
  struct Attribute {
    std::string name;
    int components;
  };
  struct Place {  // the storage that an expression refers to
    Value* value = nullptr;
    std::vector<size_t> components;  // of *value; empty: all of it
  };
  using Scope = std::map<std::string_view, Value>;
  /// Joined state of all points where the function may have returned earlier.
  struct Ended {
    Scope globals, parameters;
    Value result;
  };
  struct Frame {
    std::vector<Scope> scopes;
    Value result;
    std::shared_ptr<const Ended> ended;  // null: it has not returned yet
  };
  /// All state that statements of a function may change.
  struct State {
    Scope globals;
    Frame frame;
  };

  [[noreturn]] static void give(const std::string& why);
  void declareGlobals();
  Value color() const;
  Value attributeValue(const Global& global);
  Value varyingValue(std::string_view name, Value unknown) const;
  VaryingComponent varyingComponent(const Linear& l) const;
  Value instanceValue(const std::string& name, const Shape& shape);
  Value uniformValue(const std::string& path, const TypeName& type, size_t dimension, int depth);
  Value defaultValue(const TypeName& type, size_t dimension = 0, int depth = 0);
  const Struct* structNamed(std::string_view name) const;
  std::optional<size_t> sizeOf(const TypeName& type, size_t dimension);

  Flow execute(const Statement& statement);
  Flow executeAll(const std::vector<StatementPtr>& statements);
  Flow loop(const Statement& statement);
  Flow branch(const StatementPtr& statement);
  Flow conditional(const Statement& statement);
  Flow bothBranches(const Statement& statement);
  State keep();
  void put(State state);
  /// Joins the values with those of `other`.
  void joinWith(const State& other);
  void mayEnd();
  /// Joins the state at the function's end with those of its earlier returns.
  void joinEnds();
  void declare(const Variable& variable);
  /// Makes all variables unknown that the statements may assign. Throws Unfollowed if the statements may
  /// return from the function.
  void forgetAssigned(const Statement& statement);
  void assignedBy(const Statement& statement, std::set<std::string_view>& names, bool& returns, int depth);
  void assignedBy(const Expression& expression, std::set<std::string_view>& names, int depth);
  void forget(const std::set<std::string_view>& names);
  void forgetEverything();

  Value evaluate(const Expression& e);
  Value name(std::string_view name);
  Value ternary(const Expression& e);
  Value assign(const Expression& e);
  Value step(const Expression& e, bool valueBefore);
  Value call(const Expression& e);
  Value call(const Function& function, std::vector<Value>& arguments, const Expression& e);
  Value index(const Expression& e);
  Value member(const Expression& e);
  std::optional<Place> placeOf(const Expression& e);
  void store(const Expression& target, const Value& value);
  Value* find(std::string_view name);
  /// A uniform, or an element or member of one, without reading all of it.
  std::optional<Value> uniformAt(const Expression& e);
  bool uniformPath(const Expression& e, std::string& path, TypeName& type, size_t& dimension);
  void tick();

  const Tree& tree_;
  const UniformSource& uniforms_;
  const Stage stage_;
  const InstanceAttributes instances_;
  const Varyings varyings_;
  Scope globals_;
  std::map<std::string_view, const Global*> uniformGlobals_;
  std::map<std::string, Value> read_;
  std::vector<Attribute> attributes_;
  std::vector<InstanceColumn> instanceColumns_;
  int instanceNumbers_ = 0;
  std::vector<Frame> frames_;
  int steps_ = 0, mostSteps_ = kMaxSteps;
};

}  // namespace gluray::gl::glsl
