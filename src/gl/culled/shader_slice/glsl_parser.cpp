#include "gl/culled/shader_slice/glsl_tree.h"
#include "gl/glsl/glsl_tokens.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace gluray::gl::glsl {
namespace {

constexpr int kDeepest = 200;

constexpr std::array<std::string_view, 27> kQualifiers{
    "const",  "uniform",  "attribute", "varying",   "in",         "out",      "inout",
    "flat",   "smooth",   "centroid",  "sample",    "invariant",  "precise",  "noperspective",
    "lowp",   "mediump",  "highp",     "patch",     "buffer",     "coherent", "volatile",
    "shared", "restrict", "readonly",  "writeonly", "subroutine", "layout"};

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

class Parser {
 public:
  explicit Parser(const std::vector<std::string_view>& tokens) : tokens_(tokens) {}

  Tree run() {
    while (!peek().empty()) global();
    return std::move(tree_);
  }

 private:
  using Kind = Expression::Kind;

  [[noreturn]] static void fail() { throw std::runtime_error("the shader has syntax that is not known"); }
  std::string_view peek(size_t ahead = 0) const {
    return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead] : std::string_view();
  }
  std::string_view take() {
    if (at_ >= tokens_.size()) fail();
    return tokens_[at_++];
  }
  bool accept(std::string_view token) {
    if (peek() != token) return false;
    ++at_;
    return true;
  }
  void expect(std::string_view token) {
    if (!accept(token)) fail();
  }
  /// Whether tokens `ahead` and the next one are written together.
  bool adjoin(size_t ahead) const {
    return peek(ahead).data() + peek(ahead).size() == peek(ahead + 1).data();
  }
  struct Depth {
    explicit Depth(Parser& p) : parser(p) {
      if (++parser.depth_ > kDeepest) fail();
    }
    ~Depth() { --parser.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    Parser& parser;
  };
  void skipParentheses() {
    expect("(");
    for (int open = 1; open > 0;) {
      const std::string_view token = take();
      open += token == "(" ? 1 : token == ")" ? -1 : 0;
    }
  }

  struct Qualifiers {
    Global::Storage storage = Global::Storage::plain;
    bool in = false, out = false, constant = false;
  };
  Qualifiers qualifiers() {
    using Storage = Global::Storage;
    Qualifiers all;
    for (; isQualifier(peek());) {
      const std::string_view word = take();
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

  TypeName type() {
    TypeName result;
    if (accept("struct")) return structure();
    result.name = take();
    if (!isName(result.name)) fail();
    sizes(result);
    return result;
  }
  void sizes(TypeName& of) {
    while (accept("[")) {
      of.sizes.push_back(peek() == "]" ? nullptr : std::shared_ptr<const Expression>(expression()));
      expect("]");
    }
  }
  TypeName structure() {
    Struct made;
    made.name = isName(peek()) ? take() : "struct ";
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
  Variable variable(const TypeName& of) {
    Variable made;
    made.type = of, made.name = take();
    if (!isName(made.name)) fail();
    std::vector<std::shared_ptr<const Expression>> inner = std::exchange(made.type.sizes, {});
    sizes(made.type);
    made.type.sizes.insert(made.type.sizes.end(), inner.begin(), inner.end());
    return made;
  }

  void global() {
    if (accept(";")) return;
    if (accept("precision")) {
      while (!accept(";")) take();
      return;
    }
    const Qualifiers how = qualifiers();
    if (accept(";")) return;
    if (how.in && how.storage == Global::Storage::plain && peek(1) != "{")
      return declare(how, Global::Storage::attribute);
    if (isName(peek()) && peek(1) == "{" && peek() != "struct") return block(how);
    if (isName(peek()) && (peek(1) == ";" || peek(1) == ",")) {  // invariant gl_Position;
      while (!accept(";")) take();
      return;
    }
    declare(how, how.out ? Global::Storage::output : how.storage);
  }

  void declare(const Qualifiers& how, Global::Storage storage) {
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

  std::shared_ptr<const Expression> initial() {
    if (peek() == "{") fail();
    return std::shared_ptr<const Expression>(assignment());
  }

  void block(const Qualifiers& how) {
    const std::string_view name = take();
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

  void function(const TypeName& of) {
    Function made;
    made.type = of, made.name = take();
    expect("(");
    if (peek() == "void" && peek(1) == ")") take();
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

  StatementPtr make(Statement::Kind kind) {
    auto made = std::make_unique<Statement>();
    made->kind = kind;
    return made;
  }
  StatementPtr braces() {
    expect("{");
    StatementPtr made = make(Statement::Kind::block);
    while (!accept("}")) made->parts.push_back(statement());
    return made;
  }

  bool isDeclaration() const {
    if (isQualifier(peek()) || peek() == "struct") return true;
    if (!isName(peek())) return false;
    if (!isBuiltInType(peek()) && !structs_.contains(peek())) return false;
    return isName(peek(1)) || peek(1) == "[";
  }

  StatementPtr statement() {
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
      take(), expect(";");
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

  /// A declaration or an expression, without the semicolon.
  StatementPtr simple() {
    if (accept("precision")) {
      while (peek() != ";") take();
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

  StatementPtr conditional() {
    StatementPtr made = make(Statement::Kind::conditional);
    expect("("), made->expression = expression(), expect(")");
    made->parts.push_back(statement());
    made->parts.push_back(accept("else") ? statement() : nullptr);
    return made;
  }

  StatementPtr forLoop() {
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

  /// What it chooses is not followed: all that it assigns is unknown.
  StatementPtr choice() {
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

  ExpressionPtr node(Kind kind, std::string_view text, ExpressionPtr a = nullptr, ExpressionPtr b = nullptr) {
    auto made = std::make_unique<Expression>();
    made->kind = kind, made->text = text;
    if (a) made->parts.push_back(std::move(a));
    if (b) made->parts.push_back(std::move(b));
    return made;
  }

  ExpressionPtr expression() {
    const Depth depth(*this);
    ExpressionPtr left = assignment();
    while (accept(",")) left = node(Kind::comma, ",", std::move(left), assignment());
    return left;
  }

  ExpressionPtr assignment() {
    const Depth depth(*this);
    ExpressionPtr left = binary(0);
    if (accept("?")) {
      ExpressionPtr made = node(Kind::ternary, "?", std::move(left), assignment());
      expect(":");
      made->parts.push_back(assignment());
      return made;
    }
    static constexpr std::array<std::string_view, 8> kBefore{"+", "-", "*", "/", "%", "&", "|", "^"};
    if (peek() == "=" && !(peek(1) == "=" && adjoin(0))) {
      take();
      return node(Kind::assign, "", std::move(left), assignment());
    }
    if (std::ranges::find(kBefore, peek()) != kBefore.end() && peek(1) == "=" && adjoin(0)) {
      const std::string_view op = take();
      take();
      return node(Kind::assign, op, std::move(left), assignment());
    }
    return left;
  }

  /// The binary operator here; empty: there is none.
  std::string_view operatorHere() const {
    static constexpr std::array<std::string_view, 9> kTwo{
        "||", "&&", "^^", "==", "!=", "<=", ">=", "<<", ">>"};
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
  static int precedence(std::string_view op) {
    static const std::map<std::string_view, int> table{{"||", 1}, {"^^", 2}, {"&&", 3}, {"|", 4},  {"^", 5},
                                                       {"&", 6},  {"==", 7}, {"!=", 7}, {"<", 8},  {">", 8},
                                                       {"<=", 8}, {">=", 8}, {"<<", 9}, {">>", 9}, {"+", 10},
                                                       {"-", 10}, {"*", 11}, {"/", 11}, {"%", 11}};
    const auto found = table.find(op);
    return found == table.end() ? 0 : found->second;
  }
  ExpressionPtr binary(int least) {
    const Depth depth(*this);
    ExpressionPtr left = unary();
    for (std::string_view op = operatorHere(); precedence(op) > least; op = operatorHere()) {
      at_ += op.size();
      left = node(Kind::binary, op, std::move(left), binary(precedence(op)));
    }
    return left;
  }

  bool isTwice(std::string_view sign) const { return peek() == sign && peek(1) == sign && adjoin(0); }
  ExpressionPtr unary() {
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

  ExpressionPtr postfix() {
    ExpressionPtr made = primary();
    for (int steps = 0;; ++steps) {
      if (steps > kDeepest) fail();
      if (accept("[")) {
        made = node(Kind::index, "[", std::move(made), expression());
        expect("]");
      } else if (accept(".")) {
        const std::string_view field = take();
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

  ExpressionPtr primary() {
    if (accept("(")) {
      ExpressionPtr inner = expression();
      expect(")");
      return inner;
    }
    const std::string_view word = take();
    if (isDigit(word[0]) || word[0] == '.') return node(Kind::number, word);
    if (!isName(word)) fail();
    if (peek() == "[" && (isBuiltInType(word) || structs_.contains(word))) {  // an array's constructor
      while (!accept("]")) take();
      if (peek() != "(") fail();
      skipParentheses();
      return node(Kind::call, "array()");
    }
    if (!accept("(")) return node(Kind::name, word);
    ExpressionPtr call = node(Kind::call, word);
    if (peek() == "void" && peek(1) == ")") take();
    while (!accept(")")) {
      call->parts.push_back(assignment());
      if (peek() != ")") expect(",");
    }
    return call;
  }

  const std::vector<std::string_view>& tokens_;
  size_t at_ = 0;
  int depth_ = 0;
  Tree tree_;
  std::set<std::string_view> structs_;
};

}  // namespace

Tree parse(const std::vector<std::string_view>& tokens) { return Parser(tokens).run(); }

}  // namespace gluray::gl::glsl
