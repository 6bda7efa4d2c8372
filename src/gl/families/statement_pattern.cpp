#include "gl/families/statement_pattern.h"

#include "gl/glsl/glsl_tokens.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace gluray::gl {
namespace {

/// A decimal number at the front of `text`, and its length; nullopt if there is none.
std::optional<std::pair<float, size_t>> numberIn(std::string_view text) {
  if (text.empty() || !(isDigit(text[0]) || (text[0] == '.' && text.size() > 1 && isDigit(text[1]))))
    return std::nullopt;
  const std::string_view token = GlslTokens(text).nextToken();
  const size_t digits = token.ends_with('f') || token.ends_with('F') ? token.size() - 1 : token.size();
  float number = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + digits, number);
  if (error != std::errc() || end != token.data() + digits || !std::isfinite(number)) return std::nullopt;
  return std::pair(number, token.size());
}

/// The name at the front of `text`; empty if there is none.
std::string_view nameIn(std::string_view text) {
  if (text.empty() || !isWordPart(text[0]) || isDigit(text[0])) return {};
  const auto end = std::find_if_not(text.begin(), text.end(), isWordPart);
  return text.substr(0, static_cast<size_t>(end - text.begin()));
}

/// Compares a statement with patterns. Follows all ways to read it at once, as the set of positions that they
/// have reached: the time grows with the lengths of both, not with the number of ways.
class Matcher {
 public:
  Matcher(std::string_view statement, const Slots& slots) : statement_(statement), slots_(slots) {}

  bool fits(const PatternText& pattern, PatternMatch& match) {
    if (!contains(endsOf(pattern, 0), statement_.size())) return false;
    read(pattern, 0, statement_.size(), match);
    return true;
  }

 private:
  using Piece = PatternText::Piece;
  using Positions = std::vector<size_t>;  // sorted

  static bool contains(const Positions& positions, size_t position) {
    return std::ranges::binary_search(positions, position);
  }

  /// Whether the normal form has a space between tokens with these ends.
  static bool needsSpace(char before, char after) {
    return (isWordPart(before) && isWordPart(after)) || (before == '.' && isDigit(after));
  }

  /// Start of the token that follows `at`, the end of one; the statement's size if there is none.
  size_t tokenFrom(size_t at) const {
    if (at == 0 || at >= statement_.size()) return at;
    const char before = statement_[at - 1];
    if (needsSpace(before, statement_[at])) return statement_.size();  // amid a token
    const bool space =
        statement_[at] == ' ' && at + 1 < statement_.size() && needsSpace(before, statement_[at + 1]);
    return space ? at + 1 : at;
  }

  /// Where the piece may end if it begins at `at`.
  Positions endsOf(const Piece& piece, size_t at) {
    if (piece.kind == Piece::Kind::slot) return endsOfSlot(piece, at);
    const size_t from = tokenFrom(at);
    const std::string_view rest = statement_.substr(from);
    if (piece.kind == Piece::Kind::text)
      return rest.starts_with(piece.text) ? Positions{from + piece.text.size()} : Positions{};
    if (piece.kind == Piece::Kind::function) {
      const size_t name = nameIn(rest).size();
      return name > 0 ? Positions{from + name} : Positions{};
    }
    const auto number = numberIn(rest);
    return number ? Positions{from + number->second} : Positions{};
  }

  const Positions& endsOfSlot(const Piece& slot, size_t at) {
    const auto [known, added] = slotEnds_.try_emplace({slot.text, slot.part, at});
    if (!added) return known->second;
    Positions ends{at};  // it may be empty
    if (depth_ < kMaxDepth) {
      ++depth_;
      slots_.findFragment(slot.text, slot.part, [&](const PatternText& fragment) {
        const Positions more = endsOf(fragment, at);
        ends.insert(ends.end(), more.begin(), more.end());
        return false;
      });
      --depth_;
    }
    return slotEnds_[{slot.text, slot.part, at}] = unique(std::move(ends));
  }

  static Positions unique(Positions positions) {
    std::ranges::sort(positions);
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    return positions;
  }

  /// Where the pieces of a pattern may begin and, last, where it may end; empty if it does not fit.
  std::vector<Positions> stages(const PatternText& pattern, size_t at) {
    std::vector<Positions> stages{{at}};
    for (const Piece& piece : pattern.pieces()) {
      Positions next;
      for (const size_t from : stages.back()) {
        const Positions ends = endsOf(piece, from);
        next.insert(next.end(), ends.begin(), ends.end());
      }
      if (next.empty()) return {};
      stages.push_back(unique(std::move(next)));
    }
    return stages;
  }

  Positions endsOf(const PatternText& pattern, size_t at) {
    std::vector<Positions> all = stages(pattern, at);
    return all.empty() ? Positions{} : std::move(all.back());
  }

  /// Adds what stands for the placeholders and slots of a pattern that fits [at, end).
  void read(const PatternText& pattern, size_t at, size_t end, PatternMatch& match) {
    const std::vector<Positions> all = stages(pattern, at);
    const std::vector<Piece>& pieces = pattern.pieces();
    Positions ends(pieces.size() + 1, end);  // of one way
    for (size_t i = pieces.size(); i-- > 0;)
      ends[i] = *std::ranges::find_if(
          all[i], [&](size_t from) { return contains(endsOf(pieces[i], from), ends[i + 1]); });
    for (size_t i = 0; i < pieces.size(); ++i) {
      if (pieces[i].kind == Piece::Kind::number)
        match.numbers.push_back({pieces[i].text, numberIn(statement_.substr(tokenFrom(ends[i])))->first});
      if (pieces[i].kind == Piece::Kind::function)
        match.functions.push_back({pieces[i].text, nameIn(statement_.substr(tokenFrom(ends[i])))});
      if (pieces[i].kind == Piece::Kind::slot) readSlot(pieces[i], ends[i], ends[i + 1], match);
    }
  }

  void readSlot(const Piece& slot, size_t at, size_t end, PatternMatch& match) {
    const PatternText* found = nullptr;
    if (at != end)
      slots_.findFragment(slot.text, slot.part, [&](const PatternText& fragment) {
        if (!contains(endsOf(fragment, at), end)) return false;
        found = &fragment;
        return true;
      });
    match.slots.push_back({slot.text, slot.part, found ? std::string_view(found->text()) : ""});
    if (found) read(*found, at, end, match);
  }

  static constexpr int kMaxDepth = 16;  // of slots in fragments, whatever files say
  std::string_view statement_;
  const Slots& slots_;
  std::map<std::tuple<std::string_view, std::string_view, size_t>, Positions> slotEnds_;
  int depth_ = 0;
};

}  // namespace

bool StatementPattern::fits(std::string_view statement, const Slots& slots, PatternMatch& match) const {
  match = {};
  const auto isText = [](const PatternText::Piece& piece) {
    return piece.kind == PatternText::Piece::Kind::text;
  };
  // Most statements differ in the first or the last text.
  const std::vector<PatternText::Piece>& pieces = text_.pieces();
  if (isText(pieces.front()) && !statement.starts_with(pieces.front().text)) return false;
  if (isText(pieces.back()) && !statement.ends_with(pieces.back().text)) return false;
  return Matcher(statement, slots).fits(text_, match);
}

}  // namespace gluray::gl
