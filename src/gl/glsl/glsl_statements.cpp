#include "gl/glsl/glsl_statements.h"

#include "base/hash.h"
#include "gl/glsl/glsl_tokens.h"

#include <algorithm>
#include <cstring>
#include <unordered_set>
#include <utility>

namespace gluray::gl {
namespace {

bool startsWith(std::string_view text, std::string_view with) { return text.substr(0, with.size()) == with; }

/// Whether the statement is a plain declaration such as "in vec4 a,b[6];": a qualifier, maybe a precision, a
/// type, names.
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

/// Whether a statement in normal form can affect the result. `global`: it stands outside functions.
bool matters(std::string_view s, bool global) {
  for (const std::string_view none : {"#version ", "#extension ", "#pragma ", "#line ", "precision "})
    if (startsWith(s, none)) return false;
  return !global || (!isPlainUniform(s) && !isPlainInterface(s));
}

/// Start of the light number in the name in [from, end), such as "lightColor3"; `end` if there is none.
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

/// If the statement that begins at `start` names only one light, replaces its number by "#".
void unnumberLight(std::string& code, size_t start) {
  char* const text = code.data() + start;
  const size_t size = code.size() - start;
  const std::string_view s(text, size);
  std::string_view only;
  bool several = false;
  eachLight(s, [&](size_t number, size_t end) {
    const std::string_view digits = s.substr(number, end - number);
    several = several || (!only.empty() && only != digits);
    only = digits;
  });
  if (only.empty() || several) return;
  size_t to = 0, from = 0;
  const auto keep = [&](size_t end) {
    std::memmove(text + to, text + from, end - from);
    to += end - from;
  };
  // Text is moved only before the names that are still to be found.
  eachLight(s, [&](size_t number, size_t end) {
    keep(number);
    text[to++] = '#';
    from = end;
  });
  keep(size);
  code.resize(start + to);
}

/// Whether a comma stands outside parentheses.
bool listsSeveral(std::string_view s) {
  int depth = 0;
  return std::ranges::any_of(s, [&](char c) {
    depth += (c == '(') - (c == ')');
    return c == ',' && depth == 0;
  });
}

/// Appends a token of the statement that begins at `start`, after a space if `space`, or if it would
/// otherwise merge with the one before.
void addToken(std::string& code, size_t start, std::string_view token, bool space) {
  const bool empty = code.size() == start;
  const bool words = !empty && isWordPart(code.back()) && isWordPart(token[0]);
  const bool number = !empty && code.back() == '.' && isDigit(token[0]);
  if (words || number || space) code += ' ';
  code += token;
}

/// Appends the statements to `code`, the end of each to `ends`, and to `repeated` whether it occurred before.
class Cutter {
 public:
  Cutter(std::string_view text, const GlslStatements::Renamed& renamed, std::string& code,
         std::vector<size_t>& ends, std::vector<bool>& repeated, std::vector<bool>& global, bool wholeMain)
      : tokens_(text),
        renamed_(renamed),
        code_(code),
        ends_(ends),
        repeated_(repeated),
        global_(global),
        wholeMain_(wholeMain),
        start_(code.size()) {}

  void cut() {
    for (std::string_view t = tokens_.nextToken(); !t.empty(); t = tokens_.nextToken()) {
      if (ended_ && t != "else") finish();
      ended_ = false;
      if (isEmpty() && (t == ";" || t == "\n")) continue;
      if (isEmpty() && t == "}" && (loops_ > 0 || inMain_)) {
        loops_ > 0 ? void(--loops_) : void(inMain_ = false);
        continue;
      }
      const bool directive = isEmpty() && tokens_.isDirective();
      if (!isEmpty() && tokens_.isDirective()) add("\n", false);
      add(t == renamed_.from ? renamed_.to : t, false);
      directive ? addDirective() : count(t);
    }
    finish();
  }

 private:
  bool isEmpty() const { return code_.size() == start_; }
  std::string_view statement() const { return std::string_view(code_).substr(start_); }

  void add(std::string_view token, bool space) { addToken(code_, start_, token, space); }
  /// "#define name text": the space after the name distinguishes macros without arguments from those with.
  void addDirective() {
    int words = 0;
    for (std::string_view t = tokens_.nextToken(); !t.empty() && t != "\n"; t = tokens_.nextToken())
      add(t, (++words == 2 || (words == 3 && t != "(")) && !code_.ends_with('$'));  // "$name" is one word
    finish();
  }
  /// Counts braces and parentheses; marks the end of the statement.
  void count(std::string_view t) {
    if (t == "(") ++parentheses_;
    if (t == ")") --parentheses_;
    const bool afterParenthesis = std::exchange(parenthesisClosed_, t == ")");
    if (t == "{" && braces_++ == 0 && opens(afterParenthesis)) return;
    if (t == "}") --braces_;
    if (parentheses_ > 0 || braces_ > 0) return;
    // "do { } while (x);" and "struct { } a;" continue after the brace.
    const bool block = t == "}" && (inMain_ ? !startsWith(statement(), "do{") : body_);
    ended_ = block || t == ";";
  }
  /// Handles an opening brace. True if the body of main or of a loop begins there.
  bool opens(bool afterParenthesis) {
    body_ = body_ || afterParenthesis;
    if (startsWith(statement(), "for(")) return ++loops_, finish(), true;
    if (inMain_ || wholeMain_ || !startsWith(statement(), "void main(")) return false;
    inMain_ = true, braces_ = 0, code_.resize(start_);
    return true;
  }
  void finish() {
    parentheses_ = braces_ = 0;
    body_ = ended_ = false;
    if (isEmpty()) return;
    if (!matters(statement(), !inMain_)) return code_.resize(start_);
    const std::string_view s = statement();
    repeated_.push_back(!seen_.insert(hashBytes(s.data(), s.size()).low).second);
    global_.push_back(!inMain_);
    unnumberLight(code_, start_);
    ends_.push_back(start_ = code_.size());
  }

  GlslTokens tokens_;
  const GlslStatements::Renamed& renamed_;
  std::string& code_;
  std::vector<size_t>& ends_;
  std::vector<bool>& repeated_;
  std::vector<bool>& global_;  // whether each statement stands outside functions
  const bool wholeMain_;
  std::unordered_set<uint64_t> seen_;  // statements of this text
  size_t start_;                       // of the statement being written
  int parentheses_ = 0, braces_ = 0, loops_ = 0;
  bool inMain_ = false, body_ = false, ended_ = false, parenthesisClosed_ = false;
};

}  // namespace

std::string_view definedBy(std::string_view s) {
  const bool constant = startsWith(s, "const ");
  if (constant && listsSeveral(s)) return {};
  const size_t name = s.find(constant ? '=' : '('), before = s.substr(0, name).rfind(' ');
  if (name == std::string_view::npos || before == std::string_view::npos) return {};
  // "vec3 f(vec3 a)": a type and a name, and nothing else before the parenthesis.
  const std::string_view start = s.substr(0, name);
  const bool plain =
      std::all_of(start.begin(), start.end(), [](char c) { return isWordPart(c) || c == ' '; });
  return plain && !startsWith(s, "layout") ? start.substr(before + 1) : std::string_view();
}

void GlslStatements::drop(const std::vector<bool>& unused, size_t first) {
  std::string code;
  std::vector<size_t> ends;
  std::vector<bool> repeated;
  for (size_t i = 0; i < size(); ++i) {
    if (i >= first && unused[i - first]) continue;
    code += (*this)[i], ends.push_back(code.size()), repeated.push_back(repeated_[i]);
  }
  code_ = std::move(code), ends_ = std::move(ends), repeated_ = std::move(repeated);
}

void GlslStatements::dropUnused(size_t first, const std::vector<bool>& global) {
  std::vector<bool> unused(size() - first);
  for (bool again = true; std::exchange(again, false);) {
    std::unordered_set<std::string_view> named{"main"};  // by statements that do not define the name
    for (size_t i = first; i < size(); ++i) {
      if (unused[i - first]) continue;
      const std::string_view own = global[i - first] ? definedBy((*this)[i]) : std::string_view();
      eachWord((*this)[i], [&](std::string_view word) {
        if (word != own) named.insert(word);
      });
    }
    for (size_t i = first; i < size(); ++i) {
      const std::string_view own = global[i - first] ? definedBy((*this)[i]) : std::string_view();
      if (own.empty() || unused[i - first] || named.contains(own)) continue;
      unused[i - first] = again = true;
    }
  }
  drop(unused, first);
}

void GlslStatements::cut(std::string_view text, const Renamed& renamed, const How& how) {
  // One allocation, unless renaming makes names longer: a token is no longer than its source text, and at
  // most one character, a space or a line feed, precedes it; a final line feed may have no source.
  code_.reserve(code_.size() + 2 * text.size() + 1);
  ends_.reserve(ends_.size() + 256);
  const size_t first = size();
  std::vector<bool> global;
  Cutter(text, renamed, code_, ends_, repeated_, global, how.wholeMain).cut();
  if (how.used) dropUnused(first, global);
}

std::string normalForm(std::string_view text) {
  std::string code;
  GlslTokens tokens(text);
  for (std::string_view t = tokens.nextToken(); !t.empty(); t = tokens.nextToken()) {
    if (tokens.isDirective()) code += '\n';
    addToken(code, 0, t, false);
  }
  unnumberLight(code, 0);
  return code;
}

}  // namespace gluray::gl
