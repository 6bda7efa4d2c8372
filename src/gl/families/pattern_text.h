// Texts of known code in which names stand for what programs have there: placeholders, "$name", for numbers
// or, before a parenthesis, for names of functions; slots, "@name" or "@name.part", for fragments of text.
// Part of known code (known_code.h). Any thread.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// A text in the normal form of glsl_statements.h, cut at its placeholders and slots.
class PatternText {
 public:
  struct Piece {
    enum class Kind { text, number, function, slot };
    Kind kind = Kind::text;
    std::string text;  // the text; of a placeholder, its name with "$"; of a slot, its group
    std::string part;  // of a slot; may be empty
  };
  explicit PatternText(std::string_view text);
  /// What it was made from: equal texts fit the same.
  const std::string& text() const { return text_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  bool isPlain() const;  // it has neither placeholders nor slots

 private:
  std::string text_;
  std::vector<Piece> pieces_;
};

/// Whether `name` may be that of a slot's group or part: a letter or _, then letters, digits and _.
bool isSlotName(std::string_view name);

/// "@group" or "@group.part".
std::string slotName(std::string_view group, std::string_view part);

}  // namespace gluray::gl
