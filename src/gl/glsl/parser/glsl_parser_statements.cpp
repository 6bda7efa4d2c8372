#include "gl/glsl/parser/glsl_parser.h"

#include <map>
#include <utility>

namespace gluray::gl::glsl {

StatementPtr Parser::make(Statement::Kind kind) {
  auto made = std::make_unique<Statement>();
  made->kind = kind;
  return made;
}

StatementPtr Parser::braces() {
  expect("{");
  StatementPtr made = make(Statement::Kind::block);
  while (!accept("}")) made->parts.push_back(statement());
  return made;
}

bool Parser::isDeclaration() const {
  if (isQualifier(peek()) || peek() == "struct") return true;
  if (!isName(peek())) return false;
  if (!isBuiltInType(peek()) && !structs_.contains(peek())) return false;
  return isName(peek(1)) || peek(1) == "[";
}

StatementPtr Parser::statement() {
  const Depth depth(*this);
  const std::string_view word = peek();
  if (word == "{") return braces();
  if (accept(";")) return make(Statement::Kind::empty);
  if (accept("if")) return conditional();
  if (accept("for")) return forLoop();
  if (accept("while")) {
    StatementPtr made = make(Statement::Kind::loop);
    expect("("), made->expression = expression(), expect(")");
    made->parts.push_back(nullptr), made->parts.push_back(statement());
    return made;
  }
  if (accept("do")) {
    StatementPtr made = make(Statement::Kind::loop);
    made->conditionLast = true;
    made->parts.push_back(nullptr), made->parts.push_back(statement());
    expect("while"), expect("("), made->expression = expression(), expect(")"), expect(";");
    return made;
  }
  if (accept("switch")) return choice();
  static const std::map<std::string_view, Statement::Kind> jumps{{"break", Statement::Kind::leave},
                                                                 {"continue", Statement::Kind::next},
                                                                 {"discard", Statement::Kind::discard}};
  if (const auto jump = jumps.find(word); jump != jumps.end()) {
    takeToken(), expect(";");
    return make(jump->second);
  }
  if (accept("return")) {
    StatementPtr made = make(Statement::Kind::result);
    if (peek() != ";") made->expression = expression();
    expect(";");
    return made;
  }
  StatementPtr made = simple();
  expect(";");
  return made;
}

StatementPtr Parser::simple() {
  if (accept("precision")) {
    while (peek() != ";") takeToken();
    return make(Statement::Kind::empty);
  }
  if (!isDeclaration()) {
    StatementPtr made = make(Statement::Kind::expression);
    made->expression = expression();
    return made;
  }
  qualifiers();
  StatementPtr made = make(Statement::Kind::declaration);
  const TypeName of = type();
  if (peek() == ";") return made;  // a struct
  do {
    Variable one = variable(of);
    if (accept("=")) one.value = initial();
    made->variables.push_back(std::move(one));
  } while (accept(","));
  return made;
}

StatementPtr Parser::conditional() {
  StatementPtr made = make(Statement::Kind::conditional);
  expect("("), made->expression = expression(), expect(")");
  made->parts.push_back(statement());
  made->parts.push_back(accept("else") ? statement() : nullptr);
  return made;
}

StatementPtr Parser::forLoop() {
  StatementPtr made = make(Statement::Kind::loop);
  expect("(");
  made->parts.push_back(peek() == ";" ? nullptr : simple());
  expect(";");
  if (peek() != ";") made->expression = expression();
  expect(";");
  if (peek() != ")") made->step = expression();
  expect(")");
  made->parts.push_back(statement());
  return made;
}

StatementPtr Parser::choice() {
  StatementPtr made = make(Statement::Kind::choice);
  expect("("), made->expression = expression(), expect(")"), expect("{");
  while (!accept("}")) {
    if (accept("case"))
      expression(), expect(":");
    else if (accept("default"))
      expect(":");
    else
      made->parts.push_back(statement());
  }
  return made;
}

}  // namespace gluray::gl::glsl
