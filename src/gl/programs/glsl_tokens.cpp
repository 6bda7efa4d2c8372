#include "gl/programs/glsl_tokens.h"

#include <algorithm>

namespace gluray::gl {

/// Skips what separates tokens; true where it stopped at a line feed that ends a directive.
bool GlslTokens::skip() {
  while (at_ < text_.size()) {
    const char c = peek();
    if (c == '\\' && (peek(1) == '\n' || (peek(1) == '\r' && peek(2) == '\n'))) {
      at_ += peek(1) == '\n' ? 2 : 3;
    } else if (c == '/' && peek(1) == '/') {
      while (at_ < text_.size() && peek() != '\n') ++at_;
    } else if (c == '/' && peek(1) == '*') {
      const std::string_view rest(text_.data() + at_ + 2, text_.size() - at_ - 2);
      const size_t end = rest.find("*/");
      at_ = end == std::string_view::npos ? text_.size() : at_ + 2 + end + 2;
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

std::string_view GlslTokens::next() {
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
  return {text_.data() + from, 1};
}

std::string_view GlslTokens::word(size_t from) {
  while (isWordPart(peek())) ++at_;
  return {text_.data() + from, at_ - from};
}

/// Decimal fractions lose zeros at both ends and their suffix; whole numbers, hexadecimal ones and those with
/// an exponent stay as they are.
std::string_view GlslTokens::number(size_t from) {
  bool exponent = false;
  while (isWordPart(peek()) || peek() == '.' || (exponent && (peek() == '+' || peek() == '-'))) {
    exponent = peek() == 'e' || peek() == 'E';
    ++at_;
  }
  char* begin = text_.data() + from;
  char* end = text_.data() + at_;
  char* point = std::find(begin, end, '.');
  const auto isPlain = [](char c) { return isDigit(c) || c == '.'; };
  char* plain = std::find_if_not(begin, end, isPlain);
  const bool suffixed = plain == end - 1 && (*plain == 'f' || *plain == 'F');
  if (point == end || (plain != end && !suffixed)) return {begin, at_ - from};
  end = plain;
  while (end > point + 1 && end[-1] == '0') --end;
  while (begin < point && *begin == '0') ++begin;
  if (begin == point && end == point + 1) {  // nothing is left but the point
    char* zero = text_.data() + from;        // which had a digit beside it
    zero[0] = '0', zero[1] = '.';
    return {zero, 2};
  }
  return {begin, static_cast<size_t>(end - begin)};
}

}  // namespace gluray::gl
