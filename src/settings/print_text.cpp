#include "settings/value_text.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace gluray {
namespace {

std::string printNumbers(const glm::vec3& values) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    char digits[32];
    text.append(text.empty() ? "" : ",");
    text.append(digits, std::to_chars(digits, digits + sizeof digits, values[i]).ptr);
  }
  return text;
}

std::string printHex(const glm::vec3& color) {
  char code[8];
  const auto byte = [](float channel) {
    return channel >= 0 && channel <= 1 ? static_cast<unsigned>(std::lround(channel * 255)) : 0u;
  };
  std::snprintf(code, sizeof code, "#%02x%02x%02x", byte(color.r), byte(color.g), byte(color.b));
  return code;
}

}  // namespace

std::string printText(const Row&, bool value) { return value ? "true" : "false"; }

std::string printText(const Row&, int value) { return std::to_string(value); }

std::string printText(const Row&, float value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

std::string printText(const Row& row, uint8_t value) {
  return value < row.words.size() ? std::string(row.words[value].word) : "";
}

std::string printText(const Row& row, const glm::vec3& value) {
  const std::string code = row.type == Type::color ? printHex(value) : "";
  glm::vec3 again(-1);
  const bool exact = !code.empty() && readText(row, code, again).empty() && again == value;
  return exact ? code : printNumbers(value);
}

std::string printText(const Row&, const std::string& value) { return value; }

std::string printText(const Row& row, const std::vector<std::string>& value) {
  std::string text;
  for (const std::string& entry : value)
    text.append(text.empty() ? "" : std::string(1, separatorOf(row))).append(entry);
  return text;
}

std::string printText(const Row&, const QuirkSet& value) { return printQuirks(value); }

}  // namespace gluray
