#include "gl/glsl/parser/glsl_preprocessor.h"

#include "gl/glsl/glsl_tokens.h"

#include <cstdint>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace gluray::gl {
namespace {

using Words = std::vector<std::string_view>;

constexpr size_t kMaxTokens = 1 << 20;
constexpr int kDeepestMacros = 64, kDeepestConditions = 256;

struct Macro {
  bool function = false;
  Words parameters, body;
};

[[noreturn]] void refuse(const char* why) { throw std::runtime_error(why); }

class Preprocessor {
 public:
  explicit Preprocessor(std::string_view source) : tokens_(source) {}

  Words run() {
    Words line;
    for (std::string_view token = tokens_.nextToken(); !token.empty(); token = tokens_.nextToken()) {
      if (tokens_.isDirective()) {
        flush(line);
        directive();
      } else if (isActive() && token != "\n") {
        line.push_back(token);
      }
    }
    flush(line);
    return std::move(out_);
  }

 private:
  void flush(Words& line) {
    expand(line, out_, 0);
    line.clear();
  }

  bool isActive() const { return groups_.empty() || groups_.back().active; }

  Words restOfLine(std::string_view token) {
    Words line;
    for (; !token.empty() && token != "\n"; token = tokens_.nextToken()) line.push_back(token);
    return line;
  }

  void directive() {
    const std::string_view name = tokens_.nextToken();
    if (name.empty() || name == "\n") return;
    std::string_view first = tokens_.nextToken();
    if (name == "define" && isActive()) return define(first);
    const Words line = restOfLine(first);
    if (name == "ifdef" || name == "ifndef")
      open(isActive() && !line.empty() && isDefined(line[0]) == (name == "ifdef"));
    else if (name == "if")
      open(isActive() && evaluate(line) != 0);
    else if (name == "elif")
      otherwise([&] { return evaluate(line) != 0; });
    else if (name == "else")
      otherwise([] { return true; });
    else if (name == "endif")
      groups_.empty() ? refuse("#endif without #if") : groups_.pop_back();
    else if (name == "undef" && isActive() && !line.empty())
      macros_.erase(line[0]);
    else if (name == "include" && isActive())
      refuse("the shader includes other texts");
    else if (name == "version" && isActive() && !line.empty())
      version_ = line[0];
  }

  struct Group {
    bool outer, taken, active;
  };
  void open(bool active) {
    if (groups_.size() >= kDeepestConditions) refuse("conditions nest too deep");
    groups_.push_back({isActive(), active, active});
  }
  template <class Condition>
  void otherwise(Condition&& condition) {
    if (groups_.empty()) refuse("#else without #if");
    Group& group = groups_.back();
    group.active = group.outer && !group.taken && condition();
    group.taken = group.taken || group.active;
  }

  void define(std::string_view name) {
    Macro macro;
    std::string_view token = tokens_.nextToken();
    const bool adjoins = token == "(" && token.data() == name.data() + name.size();
    if (adjoins) {
      macro.function = true;
      for (token = tokens_.nextToken(); token != ")" && !token.empty() && token != "\n";
           token = tokens_.nextToken())
        if (token != ",") macro.parameters.push_back(token);
      token = tokens_.nextToken();
    }
    macro.body = restOfLine(token);
    macros_[name] = std::move(macro);
  }

  bool isDefined(std::string_view name) const {
    if (macros_.contains(name) || name == "__VERSION__") return true;
    // Extensions and profiles: the names that the real OpenGL defines are not known here.
    if (name.starts_with("GL_") && name != "GL_ES" && !name.starts_with("GL_FRAGMENT_PRECISION"))
      refuse("a condition asks for an extension");
    return false;
  }

  void expand(const Words& in, Words& out, int depth) {
    if (depth > kDeepestMacros) refuse("macros nest too deep");
    for (size_t i = 0; i < in.size(); ++i) {
      if (out.size() > kMaxTokens) refuse("the shader is too long");
      const auto found = macros_.find(in[i]);
      const bool called = i + 1 < in.size() && in[i + 1] == "(";
      if (in[i] == "__VERSION__") {
        out.push_back(version_);
      } else if (found == macros_.end() || (found->second.function && !called) || isOpen(in[i])) {
        out.push_back(in[i]);
      } else {
        std::vector<Words> arguments;
        if (found->second.function) i = readArguments(in, i + 2, arguments);
        call(found->first, found->second, arguments, out, depth);
      }
    }
  }

  /// Position of the closing parenthesis.
  static size_t readArguments(const Words& in, size_t i, std::vector<Words>& arguments) {
    arguments.emplace_back();
    for (int open = 1; i < in.size(); ++i) {
      if (in[i] == "(") ++open;
      if (in[i] == ")" && --open == 0) return i;
      if (in[i] == "," && open == 1)
        arguments.emplace_back();
      else
        arguments.back().push_back(in[i]);
    }
    refuse("a macro call has no end");
  }

  void call(std::string_view name, const Macro& macro, const std::vector<Words>& arguments, Words& out,
            int depth) {
    Words body;
    for (const std::string_view word : macro.body) {
      if (word == "#") refuse("a macro pastes tokens");
      size_t parameter = 0;
      while (parameter < macro.parameters.size() && macro.parameters[parameter] != word) ++parameter;
      if (parameter < macro.parameters.size() && parameter < arguments.size())
        expand(arguments[parameter], body, depth + 1);
      else
        body.push_back(word);
      if (body.size() > kMaxTokens) refuse("the shader is too long");
    }
    open_.push_back(name);
    expand(body, out, depth + 1);
    open_.pop_back();
  }

  bool isOpen(std::string_view name) const {
    for (const std::string_view open : open_)
      if (open == name) return true;
    return false;
  }

  // Expressions of #if.
  int64_t evaluate(const Words& line) {
    Words plain;
    for (size_t i = 0; i < line.size(); ++i) {
      if (line[i] != "defined") {
        plain.push_back(line[i]);
        continue;
      }
      const bool parentheses = i + 1 < line.size() && line[i + 1] == "(";
      const size_t at = i + (parentheses ? 2 : 1);
      if (at >= line.size()) refuse("defined without a name");
      plain.push_back(isDefined(line[at]) ? "1" : "0");
      i = at + (parentheses ? 1 : 0);
    }
    expression_.clear(), at_ = 0, depth_ = 0;
    expand(plain, expression_, 0);
    return binary(0);
  }
  std::string_view peek(size_t ahead = 0) const {
    return at_ + ahead < expression_.size() ? expression_[at_ + ahead] : std::string_view();
  }
  std::string_view operatorHere() const {
    static constexpr std::string_view kTwo[] = {"||", "&&", "==", "!=", "<=", ">=", "<<", ">>"};
    for (const std::string_view two : kTwo)
      if (peek() == two.substr(0, 1) && peek(1) == two.substr(1)) return two;
    return peek();
  }
  static int precedence(std::string_view op) {
    static const std::map<std::string_view, int> table{
        {"||", 1}, {"&&", 2}, {"|", 3},  {"^", 4},  {"&", 5}, {"==", 6}, {"!=", 6}, {"<", 7},  {">", 7},
        {"<=", 7}, {">=", 7}, {"<<", 8}, {">>", 8}, {"+", 9}, {"-", 9},  {"*", 10}, {"/", 10}, {"%", 10}};
    const auto found = table.find(op);
    return found == table.end() ? 0 : found->second;
  }
  int64_t binary(int least) {
    if (++depth_ > kDeepestConditions) refuse("a condition nests too deep");
    int64_t left = unary();
    for (std::string_view op = operatorHere(); precedence(op) > least; op = operatorHere()) {
      at_ += op.size();
      left = static_cast<int32_t>(apply(op, left, binary(precedence(op))));
    }
    --depth_;
    return left;
  }
  static int64_t apply(std::string_view op, int64_t a, int64_t b) {
    if ((op == "/" || op == "%") && b == 0) refuse("a condition divides by zero");
    if (op == "||") return a || b;
    if (op == "&&") return a && b;
    if (op == "==") return a == b;
    if (op == "!=") return a != b;
    if (op == "<") return a < b;
    if (op == ">") return a > b;
    if (op == "<=") return a <= b;
    if (op == ">=") return a >= b;
    if (op == "+") return a + b;
    if (op == "-") return a - b;
    if (op == "*") return a * b;
    if (op == "/") return a / b;
    if (op == "%") return a % b;
    if (op == "|") return a | b;
    if (op == "&") return a & b;
    if (op == "^") return a ^ b;
    refuse("a condition shifts");
  }
  int64_t unary() {
    const std::string_view word = peek();
    ++at_;
    if (word.empty()) refuse("a condition has no end");
    if (++depth_ > kDeepestConditions) refuse("a condition nests too deep");
    int64_t value = 0;
    if (word == "!") {
      value = !unary();
    } else if (word == "-") {
      value = -unary();
    } else if (word == "+") {
      value = unary();
    } else if (word == "(") {
      value = binary(0);
      if (peek() != ")") refuse("a condition lacks a parenthesis");
      ++at_;
    } else if (isDigit(word[0])) {
      value = static_cast<int32_t>(std::strtol(std::string(word).c_str(), nullptr, 0));
    }  // names that are not defined count as 0
    --depth_;
    return value;
  }

  GlslTokens tokens_;
  Words out_, expression_;
  size_t at_ = 0;
  int depth_ = 0;
  std::string_view version_ = "110";
  std::vector<Group> groups_;
  std::map<std::string_view, Macro> macros_;
  std::vector<std::string_view> open_;  // macros that are being expanded
};

}  // namespace

std::vector<std::string_view> preprocessed(std::string_view source) { return Preprocessor(source).run(); }

}  // namespace gluray::gl
