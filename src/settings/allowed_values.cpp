#include "settings/values.h"

#include <charconv>

namespace gluray {
namespace {

std::string numberText(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

/// " from 0 (all cores) to 1024"; empty without a range.
std::string rangeOf(const Row& row) {
  if (!row.ranged) return "";
  std::string text = " from " + numberText(row.least);
  if (!row.leastMeans.empty()) text.append(" (").append(row.leastMeans).append(")");
  text.append(" to ").append(numberText(row.most));
  return row.unit.empty() ? text : text.append(" ").append(row.unit);
}

std::string wordsOf(const Row& row) {
  std::string text;
  for (size_t i = 0; i < row.words.size(); ++i)
    text.append(i == 0 ? "" : i + 1 == row.words.size() ? " or " : ", ").append(row.words[i].word);
  return text;
}

}  // namespace

std::string allowedValues(const Row& row) {
  switch (row.type) {
    case Type::boolean: return "on, off, true, false, 1 or 0";
    case Type::integer:
    case Type::real: return "a number" + rangeOf(row);
    case Type::choice: return wordsOf(row);
    case Type::color: return "#rrggbb, or three numbers" + rangeOf(row) + " with commas between them";
    case Type::vector: return "three numbers" + rangeOf(row) + " with commas between them";
    case Type::quirks: return "NAME=on or NAME=off, with commas between them";
    default: return "";
  }
}

}  // namespace gluray
