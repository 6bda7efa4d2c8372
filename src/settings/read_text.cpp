#include "settings/value_text.h"
#include "settings/values.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace gluray {
namespace {

std::string wanted(const Row& row) { return "use " + allowedValues(row); }

/// Parses the whole text as one number within the setting's range.
template <class T>
std::optional<T> number(const Row& row, std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (!std::isfinite(static_cast<double>(value))) return std::nullopt;
  // Limits are compared in the value's precision, because 0.1f > 0.1.
  if (row.ranged && (value < static_cast<T>(row.least) || value > static_cast<T>(row.most)))
    return std::nullopt;
  return value;
}

template <class T>
std::string take(const Row& row, std::optional<T> read, T& value) {
  if (!read) return wanted(row);
  return value = *read, "";
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// Parses "1,0.5,0", with or without spaces.
std::optional<glm::vec3> triple(const Row& row, std::string_view text) {
  glm::vec3 result{};
  for (int i = 0; i < 3; ++i) {
    const size_t comma = text.find(',');
    if ((comma == text.npos) != (i == 2)) return std::nullopt;
    const std::optional<float> value = number<float>(row, trimmed(text.substr(0, comma)));
    if (!value) return std::nullopt;
    result[i] = *value;
    if (i < 2) text.remove_prefix(comma + 1);
  }
  return result;
}

/// Parses "#ff8000".
std::optional<glm::vec3> hexColor(std::string_view text) {
  uint32_t code = 0;
  const char* end = text.data() + text.size();
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  if (const auto read = std::from_chars(text.data() + 1, end, code, 16);
      read.ec != std::errc() || read.ptr != end)
    return std::nullopt;
  const auto channel = [&](int shift) { return static_cast<float>(code >> shift & 0xff) / 255; };
  return glm::vec3(channel(16), channel(8), channel(0));
}

}  // namespace

std::string readText(const Row& row, std::string_view text, bool& value) {
  if (text == "1" || text == "true" || text == "on") return value = true, "";
  if (text == "0" || text == "false" || text == "off") return value = false, "";
  return wanted(row);
}

std::string readText(const Row& row, std::string_view text, int& value) {
  return take(row, number<int>(row, text), value);
}

std::string readText(const Row& row, std::string_view text, float& value) {
  return take(row, number<float>(row, text), value);
}

std::string readText(const Row& row, std::string_view text, uint8_t& value) {
  for (size_t i = 0; i < row.words.size(); ++i)
    if (row.words[i].word == text) return value = static_cast<uint8_t>(i), "";
  return wanted(row);
}

std::string readText(const Row& row, std::string_view text, glm::vec3& value) {
  const bool hex = row.type == Type::color && text.starts_with('#');
  return take(row, hex ? hexColor(text) : triple(row, text), value);
}

std::string readText(const Row&, std::string_view text, std::string& value) { return value = text, ""; }

std::string readText(const Row& row, std::string_view text, std::vector<std::string>& value) {
  std::vector<std::string> entries;
  while (!text.empty()) {
    const size_t end = text.find(separatorOf(row));
    const std::string_view entry = text.substr(0, end);
    if (std::string why = row.check && !entry.empty() ? row.check(entry) : ""; !why.empty()) return why;
    if (!entry.empty()) entries.emplace_back(entry);
    text = end == text.npos ? std::string_view() : text.substr(end + 1);
  }
  value = std::move(entries);
  return "";
}

std::string readText(const Row&, std::string_view text, QuirkSet& value) { return readQuirks(text, value); }

}  // namespace gluray
