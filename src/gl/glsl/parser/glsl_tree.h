// The declarations, functions and statements of a shader. Any thread.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl::glsl {

struct Expression;
using ExpressionPtr = std::unique_ptr<Expression>;

struct Expression {
  enum class Kind {
    number,   // text
    name,     // text
    call,     // text: function or type; parts: arguments
    index,    // parts: array, index
    member,   // text: field or swizzle; parts: object
    unary,    // text: - + ! ~ ++ --
    postfix,  // text: ++ or --
    binary,   // text: operator
    ternary,  // parts: condition, then, otherwise
    assign,   // text: "", or the operator before =
    comma,
  } kind;
  std::string_view text;
  std::vector<ExpressionPtr> parts;
  int height = 1;  // levels of the tree; the parser bounds them, as trees are visited recursively
};

/// A type as it is written, with the sizes of its array dimensions, outermost first; null for an unsized one.
struct TypeName {
  std::string_view name;
  std::vector<std::shared_ptr<const Expression>> sizes;
};

struct Variable {
  TypeName type;
  std::string_view name;
  std::shared_ptr<const Expression> value;  // null: no initialiser
};

struct Statement;
using StatementPtr = std::unique_ptr<Statement>;

struct Statement {
  enum class Kind {
    expression,
    declaration,
    block,
    conditional,  // expression, then parts[0] or parts[1]
    loop,         // parts[0]: start; expression; step; parts[1]: body
    choice,       // switch
    result,       // return
    leave,        // break
    next,         // continue
    discard,
    empty,
  } kind = Kind::empty;
  ExpressionPtr expression, step;
  bool conditionLast = false;  // do ... while
  std::vector<Variable> variables;
  std::vector<StatementPtr> parts;  // null: absent
};

struct Parameter {
  TypeName type;
  std::string_view name;
  bool in = true, out = false;
};

struct Function {
  std::string_view name;
  TypeName type;
  std::vector<Parameter> parameters;
  StatementPtr body;
};

struct Global {
  enum class Storage { plain, constant, uniform, attribute, varying, output, other } storage = Storage::plain;
  Variable variable;
  std::string path;  // for a uniform in a block: the name that OpenGL reports
};

struct Struct {
  std::string_view name;
  std::vector<Variable> fields;
};

struct Tree {
  std::vector<Global> globals;
  std::vector<Function> functions;
  std::vector<Struct> structs;
};

/// Parses the tokens of a shader. Throws std::runtime_error for text that it does not understand.
Tree parse(const std::vector<std::string_view>& tokens);

}  // namespace gluray::gl::glsl
