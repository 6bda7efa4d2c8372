#include "gl/glsl/glsl_conditions.h"

#include "gl/glsl/glsl_tokens.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace gluray::gl {
namespace {

using Names = std::set<std::string, std::less<>>;
using Tokens = std::vector<std::string>;

/// A directive, or all other lines up to the next directive, as tokens. Lines without tokens are left out.
struct Part {
  bool directive = false;
  Tokens tokens;
};

std::vector<Part> partsOf(std::string_view text) {
  std::vector<Part> parts;
  GlslTokens tokens(text);
  bool inDirective = false;
  for (std::string_view t = tokens.nextToken(); !t.empty(); t = tokens.nextToken()) {
    if (tokens.isDirective()) {
      parts.push_back({true, {}}), inDirective = true;
    } else if (inDirective && t == "\n") {
      inDirective = false;
      continue;
    } else if (!inDirective && (parts.empty() || parts.back().directive)) {
      parts.push_back({});
    }
    if (t != "\n") parts.back().tokens.emplace_back(t);
  }
  return parts;
}

/// Evaluates "defined(A) || !(defined B && defined C)", 0 and 1.
class Condition {
 public:
  Condition(const Tokens& tokens, size_t from, const Names& defined)
      : tokens_(tokens), at_(from), defined_(defined) {}
  std::optional<bool> value() {
    const bool result = any();
    return fails_ || at_ != tokens_.size() ? std::nullopt : std::optional(result);
  }

 private:
  bool take(std::string_view token) {
    if (at_ >= tokens_.size() || tokens_[at_] != token) return false;
    return ++at_, true;
  }
  /// Consumes && or ||: the same token twice.
  bool takeTwo(std::string_view one) {
    if (at_ + 1 >= tokens_.size() || tokens_[at_] != one || tokens_[at_ + 1] != one) return false;
    return at_ += 2, true;
  }
  bool any() {
    bool result = all();
    while (!fails_ && takeTwo("|")) result = all() || result;
    return result;
  }
  bool all() {
    bool result = one();
    while (!fails_ && takeTwo("&")) result = one() && result;
    return result;
  }
  bool one() {
    if (fails_) return false;
    if (take("!")) return !one();
    if (take("(")) {
      const bool result = any();
      fails_ = fails_ || !take(")");
      return result;
    }
    if (take("0")) return false;
    if (take("1")) return true;
    if (!take("defined")) return fails_ = true, false;
    const bool inner = take("(");
    if (at_ >= tokens_.size()) return fails_ = true, false;
    const bool result = isDefined(tokens_[at_++]);
    fails_ = fails_ || (inner && !take(")"));
    return result;
  }
  bool isDefined(const std::string& name) {
    const bool byOpenGl = name != "GL_ES" && (name.starts_with("GL_") || name.starts_with("__"));
    fails_ = fails_ || byOpenGl || !isWordPart(name[0]) || isDigit(name[0]);
    return defined_.contains(name);
  }

  const Tokens& tokens_;
  size_t at_;
  const Names& defined_;
  bool fails_ = false;
};

/// Keeps the parts that conditions include.
class Resolver {
 public:
  /// False if a condition cannot be resolved.
  bool add(const Part& part) {
    if (part.directive && part.tokens.size() >= 2 && isCondition(part.tokens[1])) return follow(part.tokens);
    if (!shown()) return true;
    if (part.directive && part.tokens.size() >= 3 && part.tokens[1] == "define")
      defined_.insert(part.tokens[2]);
    if (part.directive && part.tokens.size() >= 3 && part.tokens[1] == "undef")
      defined_.erase(part.tokens[2]);
    kept_.push_back(part);
    return true;
  }
  bool isEnded() const { return levels_.empty(); }
  std::string text() const {
    std::string text;
    for (size_t i = 0; i < kept_.size(); ++i) {
      if (isUnused(i)) continue;
      for (const std::string& token : kept_[i].tokens) text.append(token).push_back(' ');
      text.push_back('\n');
    }
    return text;
  }

 private:
  struct Level {
    bool shown, before;  // this branch; this one or an earlier one
    bool last = false;   // #else was seen
  };
  static bool isCondition(const std::string& word) {
    const std::string_view words[] = {"if", "ifdef", "ifndef", "elif", "else", "endif"};
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
  }
  bool shown() const {
    return std::all_of(levels_.begin(), levels_.end(), [](const Level& l) { return l.shown; });
  }
  bool follow(const Tokens& tokens) {
    const std::string& word = tokens[1];
    if (word == "endif") return !levels_.empty() && (levels_.pop_back(), true);
    if (word == "else" || word == "elif") return goOn(tokens);
    Tokens condition = tokens;
    if (word != "if") condition.insert(condition.begin() + 2, "defined");
    const auto value = Condition(condition, 2, defined_).value();
    if (!value) return false;
    const bool on = *value == (word != "ifndef");
    levels_.push_back({on, on});
    return true;
  }
  bool goOn(const Tokens& tokens) {
    if (levels_.empty() || levels_.back().last) return false;
    Level& level = levels_.back();
    std::optional<bool> value = true;
    if (tokens[1] == "elif") value = Condition(tokens, 2, defined_).value();
    level.last = tokens[1] == "else";
    if (!value) return false;
    level.shown = *value && !level.before;
    level.before = level.before || level.shown;
    return true;
  }
  /// Whether part i defines a name that occurs in no other part.
  bool isUnused(size_t i) const {
    const Tokens& tokens = kept_[i].tokens;
    if (!kept_[i].directive || tokens.size() < 3 || tokens[1] != "define") return false;
    for (size_t k = 0; k < kept_.size(); ++k)
      if (k != i &&
          std::find(kept_[k].tokens.begin(), kept_[k].tokens.end(), tokens[2]) != kept_[k].tokens.end())
        return false;
    return true;
  }

  std::vector<Part> kept_;
  std::vector<Level> levels_;
  Names defined_;
};

}  // namespace

std::optional<std::string> resolveConditions(std::string_view text) {
  Resolver resolver;
  for (const Part& part : partsOf(text))
    if (!resolver.add(part)) return std::nullopt;
  return resolver.isEnded() ? std::optional(resolver.text()) : std::nullopt;
}

}  // namespace gluray::gl
