// Reads members of what a program answers, which nobody trusts, as text for people.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gluray::launcher {

/// All throw std::runtime_error with one line where a member is missing or of another type. Null is nothing
/// where a function returns an optional, and "-" in texts.
class AnswerReader {
 public:
  /// `value` must outlive the reader. Throws if it is no object.
  explicit AnswerReader(const nlohmann::json& value);

  /// Unprintable characters are escaped.
  std::string text(const char* name) const;
  bool flag(const char* name) const;
  std::optional<double> number(const char* name) const;
  /// From 0 to 2^53.
  std::optional<int64_t> whole(const char* name) const;
  /// As many numbers as `count` says; empty: null.
  std::vector<double> numbers(const char* name, size_t count) const;
  /// A list of texts, with `sign` between them; "-": the list is empty.
  std::string texts(const char* name, char sign) const;
  const nlohmann::json& list(const char* name) const;

  /// With as many digits as people read.
  std::string numberText(const char* name) const;
  std::string wholeText(const char* name) const;
  std::string numbersText(const char* name, size_t count) const;

 private:
  const nlohmann::json& member(const char* name) const;
  const nlohmann::json& value_;
};

/// Six significant digits.
std::string shortNumber(double number);

}  // namespace gluray::launcher
