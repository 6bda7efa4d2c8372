#include "text_table.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace gluray::launcher {

std::string TextTable::text(const std::string& indent) const {
  std::vector<size_t> widths(sides_.size(), 0);
  for (const auto& row : rows_)
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string all;
  for (const auto& row : rows_) {
    std::string line = indent;
    for (size_t i = 0; i < row.size(); ++i) {
      const size_t blanks = widths[i] - row[i].size();
      if (i) line.append(2, ' ');
      if (sides_[i] == 'r') line.append(blanks, ' ');
      line.append(row[i]);
      if (sides_[i] != 'r') line.append(blanks, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    all.append(line).append("\n");
  }
  return all;
}

std::string wrapped(const std::string& text, size_t width, const std::string& indent) {
  std::string all, line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > width) {
      all.append(indent).append(line).append("\n");
      line.clear();
    }
    line.append(line.empty() ? "" : " ").append(word);
  }
  if (!line.empty()) all.append(indent).append(line).append("\n");
  return all;
}

std::string grouped(unsigned long long number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (size_t i = 0; i < digits.size(); ++i) {
    if (i && (digits.size() - i) % 3 == 0) text.push_back(' ');
    text.push_back(digits[i]);
  }
  return text;
}

std::string fixed(double number, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return text;
}

}  // namespace gluray::launcher
