// Tokenizer for GLSL. Any thread.
#pragma once
#include <cstddef>
#include <string_view>

namespace gluray::gl {

/// Reads the tokens of a text one by one. Skips comments and line continuations. A preprocessor directive
/// ends with a line feed token, even at the end of the text. Numbers have one form: 0.50f and .5 become ".5",
/// 0.0 and .0 become "0.". Except for a final line feed, no token is longer than its source text.
class GlslTokens {
 public:
  explicit GlslTokens(std::string_view text) : text_(text) {}

  /// The next token; empty at the end. Valid as long as the text.
  std::string_view nextToken();
  /// Whether the token that nextToken() returned begins a preprocessor directive.
  bool isDirective() const { return began_; }

 private:
  bool skip();
  std::string_view word(size_t from);
  std::string_view number(size_t from);
  char peek(size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  std::string_view text_;
  size_t at_ = 0;
  bool lineStart_ = true;   // only white space since the line began
  bool directive_ = false;  // inside a preprocessor directive
  bool began_ = false;
};

/// Letters, digits and _.
constexpr bool isWordPart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}
constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }

}  // namespace gluray::gl
