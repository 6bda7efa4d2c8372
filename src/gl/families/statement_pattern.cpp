#include "gl/families/statement_pattern.h"

#include "gl/glsl/glsl_tokens.h"

#include <charconv>
#include <cmath>
#include <optional>

namespace gluray::gl {
namespace {

/// Removes a decimal number from the front of `text`; nullopt if there is none.
std::optional<float> takeNumber(std::string_view& text) {
  if (text.empty() || !(isDigit(text[0]) || (text[0] == '.' && text.size() > 1 && isDigit(text[1]))))
    return std::nullopt;
  const std::string_view token = GlslTokens(text).nextToken();
  const size_t digits = token.ends_with('f') || token.ends_with('F') ? token.size() - 1 : token.size();
  float number = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + digits, number);
  if (error != std::errc() || end != token.data() + digits || !std::isfinite(number)) return std::nullopt;
  text.remove_prefix(token.size());
  return number;
}

bool takeText(std::string_view& text, std::string_view expected) {
  if (!text.starts_with(expected)) return false;
  text.remove_prefix(expected.size());
  return true;
}

}  // namespace

StatementPattern::StatementPattern(std::string_view statement)
    : hash_(hashBytes(statement.data(), statement.size())) {
  size_t from = 0;
  for (size_t at = statement.find('$'); at != std::string_view::npos; at = statement.find('$', from)) {
    texts_.emplace_back(statement.substr(from, at - from));
    for (from = at + 1; from < statement.size() && isWordPart(statement[from]);) ++from;
    names_.emplace_back(statement.substr(at, from - at));
  }
  texts_.emplace_back(statement.substr(from));
}

bool StatementPattern::fits(std::string_view statement, std::vector<float>& numbers) const {
  for (size_t i = 0; i < names_.size(); ++i) {
    if (!takeText(statement, texts_[i])) return false;
    const std::optional<float> number = takeNumber(statement);
    if (!number) return false;
    numbers.push_back(*number);
  }
  return statement == texts_.back();
}

}  // namespace gluray::gl
