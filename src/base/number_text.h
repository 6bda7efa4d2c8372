// Reads numbers from text. Any thread.
#pragma once
#include <charconv>
#include <string_view>
#include <system_error>

namespace gluray {

/// Whether the whole text is a number of this type. Otherwise `value` stays as it was, or has the number that
/// the text begins with.
template <class Number>
bool readNumber(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace gluray
