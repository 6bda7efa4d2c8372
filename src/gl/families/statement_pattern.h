// Known statements with placeholders: "$name" stands for any number, whose value the family uses. Part of
// known code (known_code.h). Any thread.
#pragma once
#include "base/hash.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// Numbers of a shader program by the names of the placeholders, with "$", in whose place they stand.
using PlaceholderValues = std::map<std::string, float, std::less<>>;

inline bool isPlaceholder(std::string_view name) { return name.starts_with('$'); }

class StatementPattern {
 public:
  /// `statement` in the normal form of glsl_statements.h, with placeholders.
  explicit StatementPattern(std::string_view statement);
  /// Whether `statement`, in normal form, has a number for each placeholder and is the same otherwise. Adds
  /// the numbers to `numbers`, in the order of names().
  bool fits(std::string_view statement, std::vector<float>& numbers) const;
  /// Names of the placeholders in their order, with "$".
  const std::vector<std::string>& names() const { return names_; }
  const Hash128& hash() const { return hash_; }  // of the statement with its placeholders

 private:
  std::vector<std::string> texts_;  // before each placeholder, and after the last one
  std::vector<std::string> names_;
  Hash128 hash_;
};

}  // namespace gluray::gl
