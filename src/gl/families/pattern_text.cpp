#include "gl/families/pattern_text.h"

#include "gl/glsl/glsl_tokens.h"

#include <algorithm>

namespace gluray::gl {
namespace {

std::string_view takeWord(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), isWordPart);
  const std::string_view word = text.substr(0, static_cast<size_t>(end - text.begin()));
  text.remove_prefix(word.size());
  return word;
}

PatternText::Piece takeSlot(std::string_view& text) {
  PatternText::Piece slot{PatternText::Piece::Kind::slot, std::string(takeWord(text)), ""};
  if (slot.text.empty() || text.size() < 2 || text[0] != '.' || !isWordPart(text[1])) return slot;
  text.remove_prefix(1);
  slot.part = takeWord(text);
  return slot;
}

}  // namespace

PatternText::PatternText(std::string_view text) : text_(text) {
  while (!text.empty()) {
    const char kind = text[0];
    if (kind == '$' || kind == '@') {
      text.remove_prefix(1);
      if (kind == '@') {
        pieces_.push_back(takeSlot(text));
      } else {
        std::string name = "$";
        name += takeWord(text);
        const bool function = text.starts_with('(');
        pieces_.push_back({function ? Piece::Kind::function : Piece::Kind::number, std::move(name), ""});
      }
      // The space only keeps the name apart from the next word.
      if (text.size() > 1 && text[0] == ' ' && isWordPart(text[1])) text.remove_prefix(1);
    } else {
      const size_t end = std::min(text.find_first_of("$@"), text.size());
      pieces_.push_back({Piece::Kind::text, std::string(text.substr(0, end)), ""});
      text.remove_prefix(end);
    }
  }
}

bool PatternText::isPlain() const {
  return std::ranges::all_of(pieces_, [](const Piece& p) { return p.kind == Piece::Kind::text; });
}

bool isSlotName(std::string_view name) {
  return !name.empty() && !isDigit(name[0]) && std::ranges::all_of(name, isWordPart);
}

std::string slotName(std::string_view group, std::string_view part) {
  std::string name = "@";
  name += group;
  if (!part.empty()) (name += '.') += part;
  return name;
}

}  // namespace gluray::gl
