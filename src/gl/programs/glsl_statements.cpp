#include "gl/programs/glsl_statements.h"

#include "gl/programs/glsl_tokens.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace gluray::gl {
namespace {

bool startsWith(std::string_view text, std::string_view with) { return text.substr(0, with.size()) == with; }

/// "in vec4 a,b[6];" and the like: a qualifier, a type and names, perhaps a precision.
bool isPlainInterface(std::string_view s) {
  constexpr std::string_view kQualifiers[] = {"in ", "out ", "varying ", "attribute "};
  constexpr std::string_view kPrecisions[] = {"highp ", "mediump ", "lowp "};
  const auto take = [&](const auto& words) {
    for (const std::string_view word : words)
      if (startsWith(s, word)) return s.remove_prefix(word.size()), true;
    return false;
  };
  if (!take(kQualifiers)) return false;
  take(kPrecisions);
  const auto isPart = [](char c) {
    return isWordPart(c) || c == ' ' || c == ',' || c == '[' || c == ']' || c == ';';
  };
  return std::count(s.begin(), s.end(), ' ') == 1 && std::all_of(s.begin(), s.end(), isPart);
}

bool isPlainUniform(std::string_view s) {
  if (startsWith(s, "layout(")) s.remove_prefix(std::min(s.find(')') + 1, s.size()));
  return startsWith(s, "uniform ") && s.find('{') == std::string_view::npos;
}

/// Whether a statement in normal form can change what is computed. `global`: it stands outside functions.
bool matters(std::string_view s, bool global) {
  for (const std::string_view none : {"#version ", "#extension ", "#pragma ", "#line ", "precision "})
    if (startsWith(s, none)) return false;
  return !global || (!isPlainUniform(s) && !isPlainInterface(s));
}

/// Where the number of a light begins in the name at `from`, "lightColor3"; its end where there is none.
size_t lightNumber(std::string_view s, size_t from, size_t end) {
  if (!startsWith(s.substr(from, end - from), "light")) return end;
  size_t digits = end;
  while (digits > from && isDigit(s[digits - 1])) --digits;
  return digits >= from + 5 ? digits : end;
}

/// Calls each(begin, number, end) for every name of a numbered light.
template <class Each>
void eachLight(std::string_view s, Each&& each) {
  for (size_t at = 0; at < s.size();) {
    if (!isWordPart(s[at])) {
      ++at;
      continue;
    }
    size_t end = at;
    while (end < s.size() && isWordPart(s[end])) ++end;
    if (const size_t number = lightNumber(s, at, end); number < end) each(number, end);
    at = end;
  }
}

/// The number of the only light that a statement speaks of reads "#". Returns the statement's length after
/// that.
size_t unnumberLight(char* text, size_t size) {
  const std::string_view s(text, size);
  std::string_view only;
  bool several = false;
  eachLight(s, [&](size_t number, size_t end) {
    const std::string_view digits = s.substr(number, end - number);
    several = several || (!only.empty() && only != digits);
    only = digits;
  });
  if (only.empty() || several) return size;
  size_t to = 0, from = 0;
  const auto keep = [&](size_t end) {
    std::memmove(text + to, text + from, end - from);
    to += end - from;
  };
  // What is moved lies before the names that are still to be found.
  eachLight(s, [&](size_t number, size_t end) {
    keep(number);
    text[to++] = '#';
    from = end;
  });
  keep(size);
  return to;
}

/// Writes tokens back in front of the text they come from, statement by statement.
class Cutter {
 public:
  Cutter(std::span<char> text, std::vector<std::string_view>& out) : text_(text), tokens_(text), out_(out) {}

  void cut() {
    for (std::string_view t = tokens_.next(); !t.empty(); t = tokens_.next()) {
      if (ended_ && t != "else") finish();
      ended_ = false;
      if (isEmpty() && (t == ";" || t == "\n")) continue;
      if (isEmpty() && t == "}" && (loops_ > 0 || inMain_)) {
        loops_ > 0 ? void(--loops_) : void(inMain_ = false);
        continue;
      }
      const bool directive = isEmpty() && tokens_.isDirective();
      if (!isEmpty() && tokens_.isDirective()) add("\n", false);
      add(t, false);
      directive ? addDirective() : count(t);
    }
    finish();
  }

 private:
  bool isEmpty() const { return to_ == start_; }
  std::string_view statement() const { return {text_.data() + start_, to_ - start_}; }

  /// Tokens are parted where they would run into one another, or by `space`.
  void add(std::string_view token, bool space) {
    const bool words = to_ > start_ && isWordPart(text_[to_ - 1]) && isWordPart(token[0]);
    const bool number = to_ > start_ && text_[to_ - 1] == '.' && isDigit(token[0]);
    if (words || number || space) text_[to_++] = ' ';
    std::memmove(text_.data() + to_, token.data(), token.size());
    to_ += token.size();
  }
  /// "#define name text": one space after what was defined keeps macros with arguments apart from those
  /// without.
  void addDirective() {
    int words = 0;
    for (std::string_view t = tokens_.next(); !t.empty() && t != "\n"; t = tokens_.next())
      add(t, ++words == 2 || (words == 3 && t != "("));
    finish();
  }
  /// Follows braces; ends the statement where it ends.
  void count(std::string_view t) {
    if (t == "(") ++parentheses_;
    if (t == ")") --parentheses_;
    const bool afterParenthesis = std::exchange(parenthesisClosed_, t == ")");
    if (t == "{" && braces_++ == 0 && opens(afterParenthesis)) return;
    if (t == "}") --braces_;
    if (parentheses_ > 0 || braces_ > 0) return;
    // do { } while (x); and struct { } a; go on behind the brace.
    const bool block = t == "}" && (inMain_ ? !startsWith(statement(), "do{") : body_);
    ended_ = block || t == ";";
  }
  /// An opening brace. Whether a list of statements begins there: of main, or of a loop.
  bool opens(bool afterParenthesis) {
    body_ = body_ || afterParenthesis;
    if (startsWith(statement(), "for(")) return ++loops_, finish(), true;
    if (inMain_ || !startsWith(statement(), "void main(")) return false;
    inMain_ = true, braces_ = 0, to_ = start_;
    return true;
  }
  void finish() {
    parentheses_ = braces_ = 0;
    body_ = ended_ = false;
    if (isEmpty()) return;
    if (matters(statement(), !inMain_)) {
      const size_t size = unnumberLight(text_.data() + start_, to_ - start_);
      out_.emplace_back(text_.data() + start_, size);
      start_ += size;
    }
    to_ = start_;
  }

  std::span<char> text_;
  GlslTokens tokens_;
  std::vector<std::string_view>& out_;
  size_t start_ = 0, to_ = 0;  // of the statement that is being written
  int parentheses_ = 0, braces_ = 0, loops_ = 0;
  bool inMain_ = false, body_ = false, ended_ = false, parenthesisClosed_ = false;
};

}  // namespace

void cutStatements(std::span<char> text, std::vector<std::string_view>& statements) {
  Cutter(text, statements).cut();
}

}  // namespace gluray::gl
