// Words, tokens and declarations.
#include "gl/glsl/parser/glsl_parser.h"

#include "gl/glsl/glsl_tokens.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace gluray::gl::glsl {
namespace {

constexpr std::array<std::string_view, 27> kQualifiers{
    "const",  "uniform",  "attribute", "varying",   "in",         "out",      "inout",
    "flat",   "smooth",   "centroid",  "sample",    "invariant",  "precise",  "noperspective",
    "lowp",   "mediump",  "highp",     "patch",     "buffer",     "coherent", "volatile",
    "shared", "restrict", "readonly",  "writeonly", "subroutine", "layout"};

}  // namespace

bool isQualifier(std::string_view word) { return std::ranges::find(kQualifiers, word) != kQualifiers.end(); }
bool isName(std::string_view word) { return !word.empty() && isWordPart(word[0]) && !isDigit(word[0]); }

bool isBuiltInType(std::string_view word) {
  static const std::set<std::string_view> names{"void", "float", "double", "int", "uint", "bool"};
  if (names.contains(word)) return true;
  const auto takes = [&](std::string_view start) {
    return word.starts_with(start) && word.size() > start.size() && isDigit(word[start.size()]);
  };
  return takes("vec") || takes("ivec") || takes("uvec") || takes("bvec") || takes("dvec") || takes("mat") ||
         takes("dmat") || word.find("sampler") != word.npos || word.find("image") == 0 ||
         word.find("image") == 1 || word.starts_with("atomic_");
}

Tree Parser::run() {
  while (!peek().empty()) global();
  return std::move(tree_);
}

void Parser::fail() { throw std::runtime_error("the shader has syntax that is not known"); }

std::string_view Parser::takeToken() {
  if (at_ >= tokens_.size()) fail();
  return tokens_[at_++];
}

bool Parser::accept(std::string_view token) {
  if (peek() != token) return false;
  ++at_;
  return true;
}

void Parser::skipParentheses() {
  expect("(");
  for (int open = 1; open > 0;) {
    const std::string_view token = takeToken();
    open += token == "(" ? 1 : token == ")" ? -1 : 0;
  }
}

Parser::Qualifiers Parser::qualifiers() {
  using Storage = Global::Storage;
  Qualifiers all;
  for (; isQualifier(peek());) {
    const std::string_view word = takeToken();
    if ((word == "layout" || word == "subroutine") && peek() == "(") skipParentheses();
    if (word == "uniform") all.storage = Storage::uniform;
    if (word == "attribute") all.storage = Storage::attribute;
    if (word == "const") all.storage = Storage::constant, all.constant = true;
    if (word == "varying") all.storage = Storage::varying;
    if (word == "buffer" || word == "shared" || word == "subroutine") all.storage = Storage::other;
    if (word == "in" || word == "inout") all.in = true;
    if (word == "out" || word == "inout") all.out = true;
  }
  return all;
}

TypeName Parser::type() {
  TypeName result;
  if (accept("struct")) return structure();
  result.name = takeToken();
  if (!isName(result.name)) fail();
  sizes(result);
  return result;
}

void Parser::sizes(TypeName& of) {
  while (accept("[")) {
    of.sizes.push_back(peek() == "]" ? nullptr : std::shared_ptr<const Expression>(expression()));
    expect("]");
  }
}

TypeName Parser::structure() {
  Struct made;
  made.name = isName(peek()) ? takeToken() : "struct ";
  expect("{");
  while (!accept("}")) {
    qualifiers();
    const TypeName of = type();
    do made.fields.push_back(variable(of));
    while (accept(","));
    expect(";");
  }
  TypeName result;
  result.name = made.name;
  structs_.insert(made.name);
  tree_.structs.push_back(std::move(made));
  return result;
}

Variable Parser::variable(const TypeName& of) {
  Variable made;
  made.type = of, made.name = takeToken();
  if (!isName(made.name)) fail();
  std::vector<std::shared_ptr<const Expression>> inner = std::exchange(made.type.sizes, {});
  sizes(made.type);
  made.type.sizes.insert(made.type.sizes.end(), inner.begin(), inner.end());
  return made;
}

void Parser::global() {
  if (accept(";")) return;
  if (accept("precision")) {
    while (!accept(";")) takeToken();
    return;
  }
  const Qualifiers how = qualifiers();
  if (accept(";")) return;
  if (how.in && how.storage == Global::Storage::plain && peek(1) != "{")
    return declare(how, Global::Storage::attribute);
  if (isName(peek()) && peek(1) == "{" && peek() != "struct") return block(how);
  if (isName(peek()) && (peek(1) == ";" || peek(1) == ",")) {  // invariant gl_Position;
    while (!accept(";")) takeToken();
    return;
  }
  declare(how, how.out ? Global::Storage::output : how.storage);
}

void Parser::declare(const Qualifiers& how, Global::Storage storage) {
  const TypeName of = type();
  if (accept(";")) return;  // a struct
  if (isName(peek()) && peek(1) == "(") return function(of);
  (void)how;
  do {
    Global made;
    made.storage = storage, made.variable = variable(of), made.path = made.variable.name;
    if (accept("=")) made.variable.value = initial();
    tree_.globals.push_back(std::move(made));
  } while (accept(","));
  expect(";");
}

std::shared_ptr<const Expression> Parser::initial() {
  if (peek() == "{") fail();
  return std::shared_ptr<const Expression>(assignment());
}

void Parser::block(const Qualifiers& how) {
  const std::string_view name = takeToken();
  expect("{");
  std::vector<Variable> members;
  while (!accept("}")) {
    qualifiers();
    const TypeName of = type();
    do members.push_back(variable(of));
    while (accept(","));
    expect(";");
  }
  const bool uniform = how.storage == Global::Storage::uniform;
  Global made;
  made.storage = uniform ? Global::Storage::uniform : Global::Storage::other;
  if (isName(peek())) {
    // An instance: a variable whose type has the block's members.
    tree_.structs.push_back({name, members});
    structs_.insert(name);
    TypeName of;
    of.name = name;
    made.variable = variable(of), made.path = name;
    tree_.globals.push_back(std::move(made));
  } else {
    for (Variable& member : members) {
      made.variable = member, made.path = member.name;
      tree_.globals.push_back(made);
    }
  }
  expect(";");
}

void Parser::function(const TypeName& of) {
  Function made;
  made.type = of, made.name = takeToken();
  expect("(");
  if (peek() == "void" && peek(1) == ")") takeToken();
  while (!accept(")")) {
    const Qualifiers how = qualifiers();
    Parameter parameter;
    parameter.type = type();
    parameter.in = how.in || !how.out, parameter.out = how.out;
    if (isName(peek())) {
      const Variable named = variable(parameter.type);
      parameter.type = named.type, parameter.name = named.name;
    }
    made.parameters.push_back(parameter);
    if (peek() != ")") expect(",");
  }
  if (accept(";")) return;  // a prototype
  made.body = braces();
  tree_.functions.push_back(std::move(made));
}

Tree parse(const std::vector<std::string_view>& tokens) { return Parser(tokens).run(); }

}  // namespace gluray::gl::glsl
