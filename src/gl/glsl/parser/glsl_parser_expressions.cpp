#include "gl/glsl/glsl_tokens.h"
#include "gl/glsl/parser/glsl_parser.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace gluray::gl::glsl {

ExpressionPtr Parser::node(Kind kind, std::string_view text, ExpressionPtr a, ExpressionPtr b) {
  auto made = std::make_unique<Expression>();
  made->kind = kind, made->text = text;
  if (a) addPart(*made, std::move(a));
  if (b) addPart(*made, std::move(b));
  return made;
}

void Parser::addPart(Expression& to, ExpressionPtr part) {
  to.height = std::max(to.height, part->height + 1);
  if (to.height > kDeepest) fail();
  to.parts.push_back(std::move(part));
}

ExpressionPtr Parser::expression() {
  const Depth depth(*this);
  ExpressionPtr left = assignment();
  while (accept(",")) left = node(Kind::comma, ",", std::move(left), assignment());
  return left;
}

ExpressionPtr Parser::assignment() {
  const Depth depth(*this);
  ExpressionPtr left = binary(0);
  if (accept("?")) {
    ExpressionPtr made = node(Kind::ternary, "?", std::move(left), assignment());
    expect(":");
    addPart(*made, assignment());
    return made;
  }
  static constexpr std::array<std::string_view, 8> kBefore{"+", "-", "*", "/", "%", "&", "|", "^"};
  if (peek() == "=" && !(peek(1) == "=" && adjoin(0))) {
    takeToken();
    return node(Kind::assign, "", std::move(left), assignment());
  }
  if (std::ranges::find(kBefore, peek()) != kBefore.end() && peek(1) == "=" && adjoin(0)) {
    const std::string_view op = takeToken();
    takeToken();
    return node(Kind::assign, op, std::move(left), assignment());
  }
  return left;
}

std::string_view Parser::operatorHere() const {
  static constexpr std::array<std::string_view, 9> kTwo{"||", "&&", "^^", "==", "!=", "<=", ">=", "<<", ">>"};
  for (const std::string_view two : kTwo)
    if (peek() == two.substr(0, 1) && peek(1) == two.substr(1) && adjoin(0)) {
      // <<= and >>= assign
      if ((two == "<<" || two == ">>") && peek(2) == "=" && adjoin(1)) fail();
      return two;
    }
  static constexpr std::string_view kOne = "|^&<>+-*/%";
  if (peek().size() != 1 || kOne.find(peek()[0]) == kOne.npos) return {};
  return peek(1) == "=" && adjoin(0) ? std::string_view() : peek();
}

int Parser::precedence(std::string_view op) {
  static const std::map<std::string_view, int> table{{"||", 1}, {"^^", 2}, {"&&", 3}, {"|", 4},  {"^", 5},
                                                     {"&", 6},  {"==", 7}, {"!=", 7}, {"<", 8},  {">", 8},
                                                     {"<=", 8}, {">=", 8}, {"<<", 9}, {">>", 9}, {"+", 10},
                                                     {"-", 10}, {"*", 11}, {"/", 11}, {"%", 11}};
  const auto found = table.find(op);
  return found == table.end() ? 0 : found->second;
}

ExpressionPtr Parser::binary(int least) {
  const Depth depth(*this);
  ExpressionPtr left = unary();
  for (std::string_view op = operatorHere(); precedence(op) > least; op = operatorHere()) {
    at_ += op.size();
    left = node(Kind::binary, op, std::move(left), binary(precedence(op)));
  }
  return left;
}

ExpressionPtr Parser::unary() {
  const Depth depth(*this);
  for (const std::string_view twice : {"++", "--"})
    if (isTwice(twice.substr(1))) {
      at_ += 2;
      return node(Kind::unary, twice, unary());
    }
  for (const std::string_view sign : {"-", "+", "!", "~"})
    if (accept(sign)) return node(Kind::unary, sign, unary());
  return postfix();
}

ExpressionPtr Parser::postfix() {
  ExpressionPtr made = primary();
  for (int steps = 0;; ++steps) {
    if (steps > kDeepest) fail();
    if (accept("[")) {
      made = node(Kind::index, "[", std::move(made), expression());
      expect("]");
    } else if (accept(".")) {
      const std::string_view field = takeToken();
      if (!isName(field)) fail();
      if (accept("(")) {  // length()
        expect(")");
        made = node(Kind::call, "length()", std::move(made));
      } else {
        made = node(Kind::member, field, std::move(made));
      }
    } else if (isTwice("+") || isTwice("-")) {
      made = node(Kind::postfix, peek() == "+" ? "++" : "--", std::move(made));
      at_ += 2;
    } else {
      return made;
    }
  }
}

ExpressionPtr Parser::primary() {
  if (accept("(")) {
    ExpressionPtr inner = expression();
    expect(")");
    return inner;
  }
  const std::string_view word = takeToken();
  if (isDigit(word[0]) || word[0] == '.') return node(Kind::number, word);
  if (!isName(word)) fail();
  if (peek() == "[" && (isBuiltInType(word) || structs_.contains(word))) {  // an array's constructor
    while (!accept("]")) takeToken();
    if (peek() != "(") fail();
    skipParentheses();
    return node(Kind::call, "array()");
  }
  if (!accept("(")) return node(Kind::name, word);
  ExpressionPtr call = node(Kind::call, word);
  if (peek() == "void" && peek(1) == ")") takeToken();
  while (!accept(")")) {
    addPart(*call, assignment());
    if (peek() != ")") expect(",");
  }
  return call;
}

}  // namespace gluray::gl::glsl
