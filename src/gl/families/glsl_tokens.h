// GLSL in tokens. Any thread.
#pragma once
#include <cstddef>
#include <string_view>

namespace gluray::gl {

/// Reads tokens of a text one by one. Comments and continued lines are skipped; a line feed is a token where
/// it ends a preprocessor directive, be it that the text ends there. Numbers have one form: 0.50f and .5 read
/// ".5", and 0.0 and .0 read "0.". No token is longer than what it was read from, but for that line feed at
/// the end.
class GlslTokens {
 public:
  explicit GlslTokens(std::string_view text) : text_(text) {}

  /// The next token; empty at the end. Valid as long as the text is.
  std::string_view next();
  /// Whether the token that next() returned begins a preprocessor directive.
  bool isDirective() const { return began_; }

 private:
  bool skip();
  std::string_view word(size_t from);
  std::string_view number(size_t from);
  char peek(size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  std::string_view text_;
  size_t at_ = 0;
  bool lineStart_ = true;   // nothing but white space since the line began
  bool directive_ = false;  // within one
  bool began_ = false;
};

/// Letters, digits and _.
constexpr bool isWordPart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}
constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }

}  // namespace gluray::gl
