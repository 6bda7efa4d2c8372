#include "gl/glsl/glsl_tokens.h"

#include <algorithm>

namespace gluray::gl {

/// Skips white space and comments. Returns true if it stopped at the line feed or end of text that ends a
/// directive.
bool GlslTokens::skip() {
  while (at_ < text_.size()) {
    const char c = peek();
    if (c == '\\' && (peek(1) == '\n' || (peek(1) == '\r' && peek(2) == '\n'))) {
      at_ += peek(1) == '\n' ? 2 : 3;
    } else if (c == '/' && peek(1) == '/') {
      while (at_ < text_.size() && peek() != '\n') ++at_;
    } else if (c == '/' && peek(1) == '*') {
      const size_t end = text_.find("*/", at_ + 2);
      at_ = end == std::string_view::npos ? text_.size() : end + 2;
    } else if (c == '\n') {
      if (directive_) return true;
      lineStart_ = true;
      ++at_;
    } else if (c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f' || c == '\0') {
      ++at_;
    } else {
      return false;
    }
  }
  return directive_;
}

std::string_view GlslTokens::nextToken() {
  began_ = false;
  if (skip()) {
    directive_ = false;
    lineStart_ = true;
    at_ = std::min(at_ + 1, text_.size());
    return "\n";
  }
  if (at_ >= text_.size()) return {};
  const size_t from = at_;
  const char c = peek();
  began_ = c == '#' && lineStart_;
  directive_ = directive_ || began_;
  lineStart_ = false;
  if (isDigit(c) || (c == '.' && isDigit(peek(1)))) return number(from);
  if (isWordPart(c)) return word(from);
  ++at_;
  return text_.substr(from, 1);
}

std::string_view GlslTokens::word(size_t from) {
  while (isWordPart(peek())) ++at_;
  return text_.substr(from, at_ - from);
}

/// Removes leading and trailing zeros and the suffix of decimal fractions. Keeps integers, hexadecimal
/// numbers and numbers with an exponent as they are.
std::string_view GlslTokens::number(size_t from) {
  bool exponent = false;
  while (isWordPart(peek()) || peek() == '.' || (exponent && (peek() == '+' || peek() == '-'))) {
    exponent = peek() == 'e' || peek() == 'E';
    ++at_;
  }
  std::string_view token = text_.substr(from, at_ - from);
  const size_t point = token.find('.'),
               plain = std::min(token.find_first_not_of("0123456789."), token.size());
  const bool suffixed = plain + 1 == token.size() && (token[plain] == 'f' || token[plain] == 'F');
  if (point == token.npos || (plain < token.size() && !suffixed)) return token;
  size_t begin = 0, end = plain;
  while (end > point + 1 && token[end - 1] == '0') --end;
  while (begin < point && token[begin] == '0') ++begin;
  if (begin == point && end == point + 1) return "0.";  // nothing is left but the point
  return token.substr(begin, end - begin);
}

}  // namespace gluray::gl
