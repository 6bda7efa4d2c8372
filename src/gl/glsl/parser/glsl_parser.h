// The parser of GLSL's declarations, statements and expressions (glsl_tree.h), by recursive descent. Private
// to glsl_parser*.cpp. Any thread.
#pragma once
#include "gl/glsl/parser/glsl_tree.h"

#include <cstddef>
#include <set>
#include <string_view>
#include <vector>

namespace gluray::gl::glsl {

bool isQualifier(std::string_view word);
bool isName(std::string_view word);
bool isBuiltInType(std::string_view word);

class Parser {
 public:
  explicit Parser(const std::vector<std::string_view>& tokens) : tokens_(tokens) {}

  Tree run();

 private:
  using Kind = Expression::Kind;

  [[noreturn]] static void fail();
  std::string_view peek(size_t ahead = 0) const {
    return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead] : std::string_view();
  }
  std::string_view takeToken();
  bool accept(std::string_view token);
  void expect(std::string_view token) {
    if (!accept(token)) fail();
  }
  /// Whether no white space separates token `ahead` from the next one.
  bool adjoin(size_t ahead) const {
    return peek(ahead).data() + peek(ahead).size() == peek(ahead + 1).data();
  }
  static constexpr int kDeepest = 200;
  struct Depth {
    explicit Depth(Parser& p) : parser(p) {
      if (++parser.depth_ > kDeepest) fail();
    }
    ~Depth() { --parser.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    Parser& parser;
  };
  void skipParentheses();

  // Declarations.
  struct Qualifiers {
    Global::Storage storage = Global::Storage::plain;
    bool in = false, out = false, constant = false;
  };
  Qualifiers qualifiers();
  TypeName type();
  void sizes(TypeName& of);
  TypeName structure();
  Variable variable(const TypeName& of);
  void global();
  void declare(const Qualifiers& how, Global::Storage storage);
  std::shared_ptr<const Expression> initial();
  void block(const Qualifiers& how);
  void function(const TypeName& of);

  // Statements.
  StatementPtr make(Statement::Kind kind);
  StatementPtr braces();
  bool isDeclaration() const;
  StatementPtr statement();
  /// A declaration or an expression, without the semicolon.
  StatementPtr simple();
  StatementPtr conditional();
  StatementPtr forLoop();
  /// A switch. Its cases are not followed: all variables that it assigns become unknown.
  StatementPtr choice();

  // Expressions.
  ExpressionPtr node(Kind kind, std::string_view text, ExpressionPtr a = nullptr, ExpressionPtr b = nullptr);
  static void addPart(Expression& to, ExpressionPtr part);
  ExpressionPtr expression();
  ExpressionPtr assignment();
  /// The binary operator at the current token; empty if there is none.
  std::string_view operatorHere() const;
  static int precedence(std::string_view op);
  ExpressionPtr binary(int least);
  ExpressionPtr unary();
  ExpressionPtr postfix();
  ExpressionPtr primary();
  bool isTwice(std::string_view sign) const { return peek() == sign && peek(1) == sign && adjoin(0); }

  const std::vector<std::string_view>& tokens_;
  size_t at_ = 0;
  int depth_ = 0;
  Tree tree_;
  std::set<std::string_view> structs_;
};

}  // namespace gluray::gl::glsl
