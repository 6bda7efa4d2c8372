#include "gl/glsl/functions/shader_functions.h"

#include "gl/glsl/parser/glsl_preprocessor.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

namespace gluray::gl::glsl {
namespace {

constexpr size_t kMostArguments = 4;

int sizeOf(const TypeName& type) {
  if (!type.sizes.empty()) refuseFunction();
  if (type.name == "float" || type.name == "int" || type.name == "bool") return 1;
  if (type.name == "mat4") return FunctionValue::kMatrix;
  for (const std::string_view vector : {"vec2", "vec3", "vec4"})
    if (type.name == vector) return vector[3] - '0';
  refuseFunction();
}

int componentOf(char letter) {
  for (const std::string_view letters : {"xyzw", "rgba", "stpq"})
    if (const size_t at = letters.find(letter); at != std::string_view::npos) return static_cast<int>(at);
  refuseFunction();
}

/// Runs one function. Variables are those of the functions that are running.
class Run {
 public:
  Run(const Tree& tree, const FunctionInputs& inputs) : tree_(tree), inputs_(inputs) {}

  FunctionValue call(std::string_view name, const std::vector<FunctionValue>& arguments) {
    const Function& function = find(name);
    if (function.parameters.size() != arguments.size() || ++depth_ > kDeepest) refuseFunction();
    const size_t outer = std::exchange(first_, variables_.size());
    for (size_t i = 0; i < arguments.size(); ++i) {
      const Parameter& parameter = function.parameters[i];
      if (parameter.out) refuseFunction();
      declare(parameter.type, parameter.name, arguments[i]);
    }
    std::optional<FunctionValue> result = execute(*function.body);
    variables_.resize(first_);
    first_ = outer, --depth_;
    if (!result || result->size != sizeOf(function.type)) refuseFunction();
    return *result;
  }
  bool has(std::string_view name) const {
    for (const Function& function : tree_.functions)
      if (function.name == name) return true;
    return false;
  }

 private:
  using Result = std::optional<FunctionValue>;
  static constexpr int kDeepest = 64;
  struct Named {
    std::string_view name;
    FunctionValue value;
  };

  /// The function of this name; refuses names that several have.
  const Function& find(std::string_view name) const {
    const Function* found = nullptr;
    for (const Function& function : tree_.functions)
      if (function.name == name && function.body) {
        if (found) refuseFunction();
        found = &function;
      }
    return found ? *found : (refuseFunction(), *found);
  }

  void declare(const TypeName& type, std::string_view name, FunctionValue value) {
    if (value.size != sizeOf(type)) refuseFunction();
    const bool integer = type.name == "int" || type.name == "bool";
    if (integer && !value.integer) refuseFunction();
    value.integer = integer;
    variables_.push_back({name, value});
  }

  FunctionValue* variable(std::string_view name) {
    for (size_t i = variables_.size(); i-- > first_;)
      if (variables_[i].name == name) return &variables_[i].value;
    return nullptr;
  }

  Result execute(const Statement& statement) {
    switch (statement.kind) {
      case Statement::Kind::empty: return std::nullopt;
      case Statement::Kind::block: return executeBlock(statement);
      case Statement::Kind::result:
        return statement.expression ? Result(value(*statement.expression)) : (refuseFunction(), Result());
      case Statement::Kind::expression:
        if (statement.expression->kind != Expression::Kind::assign) refuseFunction();
        assign(*statement.expression);
        return std::nullopt;
      case Statement::Kind::declaration:
        for (const Variable& one : statement.variables)
          one.value ? declare(one.type, one.name, value(*one.value)) : declareEmpty(one);
        return std::nullopt;
      case Statement::Kind::conditional: {
        const auto& part = statement.parts[value(*statement.expression).isTrue() ? 0 : 1];
        return part ? execute(*part) : std::nullopt;
      }
      default: refuseFunction();
    }
  }

  Result executeBlock(const Statement& block) {
    const size_t outer = variables_.size();
    for (const StatementPtr& part : block.parts)
      if (Result result = execute(*part)) return result;
    variables_.resize(outer);
    return std::nullopt;
  }

  void declareEmpty(const Variable& one) {
    FunctionValue value;
    value.size = sizeOf(one.type), value.integer = one.type.name == "int" || one.type.name == "bool";
    variables_.push_back({one.name, value});
  }

  void assign(const Expression& e) {
    FunctionValue right = value(*e.parts[1]);
    const Expression& target = *e.parts[0];
    const bool member = target.kind == Expression::Kind::member;
    const Expression& object = member ? *target.parts[0] : target;
    FunctionValue* const to = object.kind == Expression::Kind::name ? variable(object.text) : nullptr;
    if (!to || to->isMatrix()) refuseFunction();
    if (!e.text.empty()) right = combined(e.text, member ? swizzled(*to, target.text) : *to, right);
    if (!member) {
      if (right.size != to->size || (to->integer && !right.integer)) refuseFunction();
      right.integer = to->integer, *to = right;
      return;
    }
    if (right.size != static_cast<int>(target.text.size())) refuseFunction();
    for (size_t i = 0; i < target.text.size(); ++i) {
      const int component = componentOf(target.text[i]);
      if (component >= to->size || to->size == 1) refuseFunction();
      to->parts[static_cast<size_t>(component)] = right.parts[i];
    }
  }

  static FunctionValue swizzled(const FunctionValue& v, std::string_view letters) {
    if (v.isMatrix() || v.size == 1 || letters.size() > 4) refuseFunction();
    FunctionValue out;
    out.size = static_cast<int>(letters.size());
    for (size_t i = 0; i < letters.size(); ++i) {
      const int component = componentOf(letters[i]);
      if (component >= v.size) refuseFunction();
      out.parts[i] = v.at(component);
    }
    return out;
  }

  FunctionValue nameValue(std::string_view name) {
    if (name == "true" || name == "false") return FunctionValue::truth(name == "true");
    if (const FunctionValue* found = variable(name)) return *found;
    for (const Global& global : tree_.globals)
      if (global.variable.name == name && global.storage == Global::Storage::uniform) {
        const auto known = inputs_.uniform(name);
        return known && known->size == sizeOf(global.variable.type) ? *known : (refuseFunction(), *known);
      }
    refuseFunction();
  }

  static FunctionValue literal(std::string_view text) {
    const std::string copy(text);
    char* end = nullptr;
    FunctionValue out = FunctionValue::number(std::strtod(copy.c_str(), &end));
    const std::string_view rest(end);
    if (!(rest.empty() || rest == "f" || rest == "F")) refuseFunction();
    out.integer = rest.empty() && text.find_first_of(".eE") == std::string_view::npos;
    if (out.integer && text.size() > 1 && text[0] == '0') refuseFunction();  // octal
    return out;
  }

  FunctionValue value(const Expression& e) {
    switch (e.kind) {
      case Expression::Kind::number: return literal(e.text);
      case Expression::Kind::name: return nameValue(e.text);
      case Expression::Kind::call: return called(e);
      case Expression::Kind::member: return swizzled(value(*e.parts[0]), e.text);
      case Expression::Kind::unary: {
        const FunctionValue inner = value(*e.parts[0]);
        if (e.text == "!") return FunctionValue::truth(!inner.isTrue());
        if (e.text != "-" && e.text != "+") refuseFunction();
        FunctionValue zero = FunctionValue::number(0);
        zero.integer = inner.integer;
        return e.text == "-" ? combined("-", zero, inner) : inner;
      }
      case Expression::Kind::binary: {
        const FunctionValue left = value(*e.parts[0]);
        if (e.text == "||") return FunctionValue::truth(left.isTrue() || value(*e.parts[1]).isTrue());
        if (e.text == "&&") return FunctionValue::truth(left.isTrue() && value(*e.parts[1]).isTrue());
        return combined(e.text, left, value(*e.parts[1]));
      }
      case Expression::Kind::ternary: return value(*e.parts[value(*e.parts[0]).isTrue() ? 1 : 2]);
      default: refuseFunction();
    }
  }

  FunctionValue called(const Expression& e) {
    if (e.parts.size() > kMostArguments) refuseFunction();
    if (e.text == "texture2D" || (e.text == "texture" && !has(e.text))) return sampled(e);
    std::vector<FunctionValue> arguments;
    for (const ExpressionPtr& part : e.parts) arguments.push_back(value(*part));
    if (has(e.text)) return call(e.text, arguments);
    if (e.text == "float" || e.text.starts_with("vec")) return constructed(e.text, arguments);
    return builtIn(e.text, arguments.data(), arguments.size());
  }

  FunctionValue sampled(const Expression& e) {
    if (e.parts.size() != 2 || e.parts[0]->kind != Expression::Kind::name) refuseFunction();
    const FunctionValue at = value(*e.parts[1]);
    if (at.size != 2) refuseFunction();
    const auto texel = inputs_.texture(e.parts[0]->text, {numberOf(at.parts[0]), numberOf(at.parts[1])});
    return texel ? FunctionValue::vector(*texel, 4) : (refuseFunction(), FunctionValue());
  }

  static FunctionValue constructed(std::string_view type, const std::vector<FunctionValue>& arguments) {
    FunctionValue out;
    out.size = sizeOf({type, {}});
    size_t count = 0;
    for (const FunctionValue& argument : arguments) {
      if (argument.isMatrix()) refuseFunction();
      for (int i = 0; i < argument.size && count < out.parts.size(); ++i) out.parts[count++] = argument.at(i);
    }
    const bool spread = arguments.size() == 1 && arguments[0].size == 1;
    if (spread) out.parts.fill(arguments[0].parts[0]);
    if (!spread && count != static_cast<size_t>(out.size)) refuseFunction();
    return out;
  }

  const Tree& tree_;
  const FunctionInputs& inputs_;
  std::vector<Named> variables_;
  size_t first_ = 0;  // of the running function
  int depth_ = 0;
};

}  // namespace

ShaderFunctions::ShaderFunctions(std::string source)
    : source_(std::move(source)), tree_(parse(preprocessed(source_))) {}

bool ShaderFunctions::has(std::string_view name) const {
  return std::ranges::any_of(tree_.functions, [&](const Function& f) { return f.name == name; });
}

glm::dmat4 ShaderFunctions::matrixOf(std::string_view name, const FunctionInputs& inputs) const {
  FunctionValue argument;
  argument.size = 4;
  for (size_t i = 0; i < 4; ++i) argument.parts[i].factors[static_cast<int>(i)] = 1;
  const FunctionValue result = Run(tree_, inputs).call(name, {argument});
  if (result.size != 4) refuseFunction();
  glm::dmat4 matrix(0);
  for (int row = 0; row < 4; ++row) {
    const FunctionNumber& part = result.at(row);
    if (part.constant != 0) refuseFunction();
    for (int column = 0; column < 4; ++column) matrix[column][row] = part.factors[column];
  }
  return matrix;
}

glm::dvec4 ShaderFunctions::colorOf(std::string_view name, double at, const FunctionInputs& inputs) const {
  const FunctionValue result = Run(tree_, inputs).call(name, {FunctionValue::number(at)});
  if (result.size != 4) refuseFunction();
  glm::dvec4 color;
  for (int i = 0; i < 4; ++i) color[i] = numberOf(result.at(i));
  return color;
}

}  // namespace gluray::gl::glsl
