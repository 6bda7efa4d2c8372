// GLSL in tokens, read from a text and written back in front of it in normal form. Any thread.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace gluray::gl {

/// Reads tokens of a text one by one. Comments and continued lines are skipped; a line feed is a token where
/// it ends a preprocessor directive. Numbers are brought into one form in place: 0.50f and .5 read ".5".
class GlslTokens {
 public:
  explicit GlslTokens(std::span<char> text) : text_(text) {}

  /// The next token; empty at the end. Views of the text, valid as long as nobody writes there.
  std::string_view next();
  /// Bytes that were read: nothing before is needed any more.
  size_t at() const { return at_; }
  /// Whether the token that next() returned begins a preprocessor directive.
  bool isDirective() const { return began_; }

 private:
  bool skip();
  std::string_view word(size_t from);
  std::string_view number(size_t from);
  char peek(size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  std::span<char> text_;
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
