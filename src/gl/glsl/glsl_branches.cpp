#include "gl/glsl/glsl_branches.h"

#include "gl/glsl/glsl_tokens.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

namespace gluray::gl {
namespace {

using Token = std::string_view;

/// A range of tokens.
struct TokenRange {
  size_t begin = 0, end = 0;
  bool empty() const { return begin >= end; }
  size_t size() const { return end - begin; }
};

/// The tokens of a text. Directives are one token each, from # to the end of their line.
class TokenText {
 public:
  explicit TokenText(Token text) {
    GlslTokens tokens(text);
    for (Token t = tokens.nextToken(); !t.empty(); t = tokens.nextToken()) {
      const bool directive = tokens.isDirective();
      if (directive) {
        const Token begin = t;
        Token last = t;
        for (; !t.empty() && t != "\n"; t = tokens.nextToken()) last = t;
        t = Token(begin.data(), static_cast<size_t>(last.data() + last.size() - begin.data()));
      }
      tokens_.push_back(t), directives_.push_back(directive);
    }
  }

  size_t size() const { return tokens_.size(); }
  Token operator[](size_t i) const { return i < tokens_.size() ? tokens_[i] : Token(); }
  bool isDirective(size_t i) const { return i < directives_.size() && directives_[i]; }

  /// One past the bracket that closes the one at `i`.
  size_t pastClosing(size_t i) const {
    int depth = 0;
    for (; i < size(); ++i) {
      const Token t = tokens_[i];
      if (t == "(" || t == "{" || t == "[") ++depth;
      if ((t == ")" || t == "}" || t == "]") && --depth <= 0) return i + 1;
    }
    return size();
  }
  /// One past the statement that begins at `i`.
  size_t pastStatement(size_t i) const {
    const Token t = (*this)[i];
    if (isDirective(i)) return pastStatement(i + 1);
    if (t == "{") return pastClosing(i);
    if (t == "if") {
      const size_t end = pastStatement(pastClosing(i + 1));
      return (*this)[end] == "else" ? pastStatement(end + 1) : end;
    }
    if (t == "for" || t == "while") return pastStatement(pastClosing(i + 1));
    if (t == "do") i = pastStatement(i + 1);
    while (i < size() && tokens_[i] != ";") {
      const Token inner = tokens_[i];
      i = inner == "(" || inner == "{" || inner == "[" ? pastClosing(i) : i + 1;
    }
    return std::min(i + 1, size());
  }

 private:
  std::vector<Token> tokens_;
  std::vector<bool> directives_;
};

/// Evaluates conditions.
class ConditionEvaluator {
 public:
  ConditionEvaluator(const TokenText& text, const DecidedValues& values) : text_(text), values_(values) {}

  /// Nullopt: not known.
  std::optional<bool> condition(TokenRange part) const {
    while (isEnclosed(part)) ++part.begin, --part.end;
    if (const auto at = find(part, "|", "|")) {
      const auto a = condition({part.begin, *at}), b = condition({*at + 2, part.end});
      if ((a && *a) || (b && *b)) return true;
      return a && b ? std::optional(false) : std::nullopt;
    }
    if (const auto at = find(part, "&", "&")) {
      const auto a = condition({part.begin, *at}), b = condition({*at + 2, part.end});
      if ((a && !*a) || (b && !*b)) return false;
      return a && b ? std::optional(true) : std::nullopt;
    }
    return comparison(part);
  }

 private:
  bool isEnclosed(const TokenRange& part) const {
    return part.size() > 1 && text_[part.begin] == "(" && text_.pastClosing(part.begin) == part.end;
  }
  /// The first place outside brackets where token `first` stands, followed by `second`.
  std::optional<size_t> find(const TokenRange& part, Token first, Token second) const {
    for (size_t i = part.begin; i + 1 < part.end;) {
      if (text_[i] == first && text_[i + 1] == second) return i;
      i = text_[i] == "(" || text_[i] == "[" ? text_.pastClosing(i) : i + 1;
    }
    return std::nullopt;
  }
  std::optional<bool> comparison(const TokenRange& part) const {
    if (text_[part.begin] == "!" && text_[part.begin + 1] != "=") {
      const auto inner = condition({part.begin + 1, part.end});
      return inner ? std::optional(!*inner) : std::nullopt;
    }
    const auto left = number(part.begin);
    if (!left) return std::nullopt;
    if (part.size() == 1) return *left != 0;
    const Token op = text_[part.begin + 1];
    const bool two = text_[part.begin + 2] == "=";
    const size_t at = part.begin + (two ? 3 : 2);
    const auto right = at + 1 == part.end ? number(at) : std::nullopt;
    if (!right) return std::nullopt;
    if (two && op == "=") return *left == *right;
    if (two && op == "!") return *left != *right;
    if (op == "<") return two ? *left <= *right : *left < *right;
    if (op == ">") return two ? *left >= *right : *left > *right;
    return std::nullopt;
  }
  /// The value of one token: a decided variable or a number.
  std::optional<float> number(size_t at) const {
    const Token t = text_[at];
    if (const auto it = values_.find(t); it != values_.end()) return it->second;
    if (t == "true" || t == "false") return t == "true" ? 1.0f : 0.0f;
    float value = 0;
    const auto [end, error] = std::from_chars(t.data(), t.data() + t.size(), value);
    if (t.empty() || error != std::errc() || end != t.data() + t.size()) return std::nullopt;
    return value;
  }

  const TokenText& text_;
  const DecidedValues& values_;
};

/// Writes the text with its branches decided.
class BranchWriter {
 public:
  BranchWriter(const TokenText& text, const DecidedValues& values) : text_(text), evaluator_(text, values) {}

  std::string write() {
    for (size_t i = 0; i < text_.size();) {
      const bool main = text_[i] == "main" && text_[i + 1] == "(" && !text_.isDirective(i);
      const size_t end = main ? text_.pastStatement(text_.pastClosing(i + 1)) : i + 1;
      main ? writeAll({i, end}) : writeToken(i);
      i = end;
    }
    return std::move(out_);
  }

 private:
  struct If {
    TokenRange condition, then, otherwise;
    std::optional<bool> value;
  };

  If ifAt(size_t i) const {
    If found;
    found.condition = {i + 2, text_.pastClosing(i + 1) - 1};
    found.then = {found.condition.end + 1, text_.pastStatement(found.condition.end + 1)};
    if (text_[found.then.end] == "else")
      found.otherwise = {found.then.end + 1, text_.pastStatement(found.then.end + 1)};
    found.value = evaluator_.condition(found.condition);
    return found;
  }
  bool isIf(size_t i) const { return text_[i] == "if" && text_[i + 1] == "(" && !text_.isDirective(i); }

  void writeToken(size_t i) {
    if (text_.isDirective(i)) out_ += '\n';
    out_ += text_[i];
    out_ += text_.isDirective(i) ? '\n' : ' ';
  }
  void writeAll(const TokenRange& part) {
    for (size_t i = part.begin; i < part.end;) {
      if (!isIf(i)) {
        writeToken(i++);
        continue;
      }
      const If found = ifAt(i);
      writeIf(i, found);
      i = found.otherwise.empty() ? found.then.end : found.otherwise.end;
    }
  }
  void writeIf(size_t at, const If& found) {
    if (found.value) return writeTaken(*found.value ? found.then : found.otherwise);
    for (size_t i = at; i <= found.condition.end; ++i) writeToken(i);
    writeBranch(found.then);
    if (found.otherwise.empty()) return;
    out_ += "else ";
    writeBranch(found.otherwise);
  }
  /// The statements of a branch that is always taken.
  void writeTaken(TokenRange part) {
    if (!part.empty() && text_[part.begin] == "{") ++part.begin, --part.end;
    writeAll(part);
  }
  /// A branch that remains one. What replaces an if-statement may be no statement or several.
  void writeBranch(const TokenRange& part) {
    const bool replaced = isIf(part.begin) && ifAt(part.begin).value;
    if (replaced) out_ += "{ ";
    writeAll(part);
    if (replaced) out_ += "} ";
  }

  const TokenText& text_;
  const ConditionEvaluator evaluator_;
  std::string out_;
};

}  // namespace

std::string decideBranches(std::string_view text, const DecidedValues& values) {
  const TokenText tokens(text);
  return BranchWriter(tokens, values).write();
}

}  // namespace gluray::gl
