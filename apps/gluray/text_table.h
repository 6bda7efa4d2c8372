// Aligned text for terminals.
#pragma once
#include <string>
#include <vector>

namespace gluray::launcher {

/// Rows of cells; columns are as wide as their widest cell, two blanks apart.
class TextTable {
 public:
  /// One letter a column: 'l' aligns its cells left, 'r' right.
  explicit TextTable(std::string sides) : sides_(std::move(sides)) {}
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  bool empty() const { return rows_.empty(); }
  /// Each line starts with `indent` and ends without blanks.
  std::string text(const std::string& indent) const;

 private:
  std::string sides_;
  std::vector<std::vector<std::string>> rows_;
};

/// `text` broken at blanks into lines of at most `width` characters (longer words stay whole), each after
/// `indent`.
std::string wrapped(const std::string& text, size_t width, const std::string& indent);

/// 12345678 -> "12 345 678".
std::string grouped(unsigned long long number);

/// A number with `digits` digits after the point.
std::string fixed(double number, int digits);

}  // namespace gluray::launcher
