// Known statements with placeholders and slots. Part of known code (known_code.h). Any thread.
#pragma once
#include "base/hash.h"
#include "gl/families/pattern_text.h"
#include "gl/families/slot_fragments.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// Numbers of a shader program by the names of the placeholders, with "$", in whose place they stand.
using PlaceholderValues = std::map<std::string, float, std::less<>>;

inline bool isPlaceholder(std::string_view name) { return name.starts_with('$'); }

/// What stands in a statement for the placeholders and slots of a pattern, in their order, with those of
/// fragments. Refers to the pattern and its fragments.
struct PatternMatch {
  struct Number {
    std::string_view name;
    float value;
  };
  struct Slot {
    std::string_view group, part;
    std::string_view text;  // of the fragment, with its own placeholders and slots; empty: nothing is there
  };
  struct Function {
    std::string_view name;    // of the placeholder
    std::string_view called;  // the function's, in the statement
  };
  std::vector<Number> numbers;
  std::vector<Function> functions;
  std::vector<Slot> slots;
};

class StatementPattern {
 public:
  /// `statement` in the normal form of glsl_statements.h, with placeholders and slots.
  explicit StatementPattern(std::string_view statement)
      : text_(statement), hash_(hashBytes(statement.data(), statement.size())) {}
  /// Whether `statement`, in normal form, has a number or a name for each placeholder, a fragment of `slots`
  /// or nothing for each slot, and is the same otherwise. Then sets `match`, of several ways to read it to
  /// one.
  bool fits(std::string_view statement, const Slots& slots, PatternMatch& match) const;
  const PatternText& text() const { return text_; }
  const Hash128& hash() const { return hash_; }  // of the statement with its placeholders and slots

 private:
  PatternText text_;
  Hash128 hash_;
};

}  // namespace gluray::gl
