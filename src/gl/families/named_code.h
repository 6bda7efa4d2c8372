// The sections of known code that a family names, searched together. Private to this folder.
#pragma once
#include "gl/families/known_code.h"

#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

inline bool isBefore(const Hash128& a, const Hash128& b) {
  return a.high != b.high ? a.high < b.high : a.low < b.low;
}

class NamedCode {
 public:
  NamedCode(const CodeSections& sections, const std::vector<std::string>& names);
  const std::vector<const KnownCode*>& sections() const { return sections_; }
  const Slots& slots() const { return slots_; }
  bool has(const Hash128& statement) const;
  /// The pattern that makes the statement known, and what stands for its placeholders and slots; null if
  /// there is none, or if it is known itself.
  const StatementPattern* patternOf(std::string_view statement, PatternMatch& match) const;
  /// Whether one of the sections has the statement, or a pattern that it fits.
  bool hasLike(const KnownCode& section, std::string_view statement) const;
  /// The statement's hash; if only a pattern makes it known, that of the pattern.
  Hash128 hashFor(std::string_view statement) const;
  std::vector<Hash128> hashesFor(const GlslStatements& statements) const;

 private:
  std::vector<const KnownCode*> sections_;
  Slots slots_;
};

}  // namespace gluray::gl
