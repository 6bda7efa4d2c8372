#include "gl/families/known_code.h"

#include "gl/families/named_code.h"

#include <algorithm>
#include <map>
#include <utility>

namespace gluray::gl {

Hash128 KnownCode::hashOfKnown(std::string_view statement, const std::string& place) {
  if (statement.find_first_of("$@") != std::string_view::npos) {
    patterns_.emplace_back(statement);
    addUses(patterns_.back().text(), "", place);
  }
  return hashOf(statement);
}

void KnownCode::addUses(const PatternText& text, const std::string& group, const std::string& place) {
  for (const PatternText::Piece& piece : text.pieces())
    if (piece.kind == PatternText::Piece::Kind::slot)
      slotUses_.push_back({piece.text, piece.part, group, place});
}

void KnownCode::addFragment(const std::string& group, const std::string& word, const std::string& part,
                            std::string_view text, const std::string& place) {
  const PatternText fragment(normalForm(text));
  fragments_.addFragment(group, word, part, fragment);
  addUses(fragment, group, place);
}

void KnownCode::add(std::string_view text, const std::string& place, bool wholeMain) {
  GlslStatements statements;
  statements.cut(text, {}, {.wholeMain = wholeMain});
  statements_.reserve(statements_.size() + statements.size());
  for (size_t i = 0; i < statements.size(); ++i) statements_.push_back(hashOfKnown(statements[i], place));
  sort();
}

void KnownCode::addBlocks(std::string_view text, const std::string& place) {
  while (!text.empty()) {
    const size_t end = std::min(text.find("\n\n"), text.size());
    GlslStatements statements;
    statements.cut(text.substr(0, end));
    std::vector<Hash128> block;
    for (size_t i = 0; i < statements.size(); ++i) block.push_back(hashOfKnown(statements[i], place));
    statements_.insert(statements_.end(), block.begin(), block.end());
    if (!block.empty()) blocks_.push_back(std::move(block));
    text.remove_prefix(std::min(end + 2, text.size()));
  }
  sort();
}

void KnownCode::add(const KnownCode& more) {
  if (note.empty()) note = more.note;
  complete = complete || more.complete;
  blocks_.insert(blocks_.end(), more.blocks_.begin(), more.blocks_.end());
  shaders_.insert(shaders_.end(), more.shaders_.begin(), more.shaders_.end());
  written_.insert(more.written_.begin(), more.written_.end());
  statements_.insert(statements_.end(), more.statements_.begin(), more.statements_.end());
  patterns_.insert(patterns_.end(), more.patterns_.begin(), more.patterns_.end());
  fragments_.add(more.fragments_);
  slotUses_.insert(slotUses_.end(), more.slotUses_.begin(), more.slotUses_.end());
  sort();
}

void KnownCode::sort() {
  std::sort(statements_.begin(), statements_.end(), isBefore);
  statements_.erase(std::unique(statements_.begin(), statements_.end()), statements_.end());
}

bool KnownCode::has(Hash128 statement) const {
  return std::binary_search(statements_.begin(), statements_.end(), statement, isBefore);
}

NamedCode::NamedCode(const CodeSections& sections, const std::vector<std::string>& names) {
  sections_.reserve(names.size());
  for (const std::string& name : names)
    if (const auto it = sections.find(name); it != sections.end()) {
      sections_.push_back(&it->second);
      slots_.add(it->second.fragments());
    }
}

bool NamedCode::has(const Hash128& statement) const {
  return std::ranges::any_of(sections_, [&](const auto* code) { return code->has(statement); });
}

namespace {

const StatementPattern* patternIn(const KnownCode& section, std::string_view statement, const Slots& slots,
                                  PatternMatch& match) {
  for (const StatementPattern& pattern : section.patterns())
    if (pattern.fits(statement, slots, match)) return &pattern;
  return nullptr;
}

}  // namespace

const StatementPattern* NamedCode::patternOf(std::string_view statement, PatternMatch& match) const {
  match = {};
  if (has(hashOf(statement))) return nullptr;
  for (const KnownCode* section : sections_)
    if (const StatementPattern* pattern = patternIn(*section, statement, slots_, match)) return pattern;
  return nullptr;
}

bool NamedCode::hasLike(const KnownCode& section, std::string_view statement) const {
  PatternMatch match;
  return section.has(hashOf(statement)) || patternIn(section, statement, slots_, match);
}

Hash128 NamedCode::hashFor(std::string_view statement) const {
  PatternMatch match;
  const StatementPattern* pattern = patternOf(statement, match);
  return pattern ? pattern->hash() : hashOf(statement);
}

std::vector<Hash128> NamedCode::hashesFor(const GlslStatements& statements) const {
  std::vector<Hash128> hashes;
  hashes.reserve(statements.size());
  for (size_t i = 0; i < statements.size(); ++i) hashes.push_back(hashFor(statements[i]));
  return hashes;
}

std::vector<Hash128> knownShaders(const CodeSections& sections, const std::vector<std::string>& names) {
  std::vector<Hash128> all;
  const NamedCode known(sections, names);
  for (const KnownCode* code : known.sections())
    all.insert(all.end(), code->shaders().begin(), code->shaders().end());
  return all;
}

std::vector<std::string_view> unknownStatements(const GlslStatements& statements,
                                                const CodeSections& sections,
                                                const std::vector<std::string>& names) {
  const NamedCode known(sections, names);
  std::vector<std::string_view> unknown;
  for (size_t i = 0; i < statements.size(); ++i) {
    const std::string_view statement = statements[i];
    if (known.has(known.hashFor(statement))) continue;
    if (std::find(unknown.begin(), unknown.end(), statement) == unknown.end()) unknown.push_back(statement);
  }
  return unknown;
}

std::string readPlaceholders(const GlslStatements& statements, const CodeSections& sections,
                             const std::vector<std::string>& names, PlaceholderValues& values) {
  const NamedCode known(sections, names);
  PatternMatch match;
  for (size_t i = 0; i < statements.size(); ++i) {
    if (!known.patternOf(statements[i], match)) continue;
    for (const PatternMatch::Number& number : match.numbers) {
      const auto [it, added] = values.emplace(number.name, number.value);
      if (!added && it->second != number.value) return it->first;
    }
  }
  return "";
}

std::string readWords(const GlslStatements& statements, const CodeSections& sections,
                      const std::vector<std::string>& names, SlotWords& words) {
  const NamedCode known(sections, names);
  std::map<std::string, std::vector<std::string>> possible;  // by groups: words that fit all slots so far
  PatternMatch match;
  for (size_t i = 0; i < statements.size(); ++i) {
    if (!known.patternOf(statements[i], match)) continue;
    for (const PatternMatch::Slot& slot : match.slots) {
      const std::vector<std::string> fit = known.slots().wordsWith(slot.group, slot.part, slot.text);
      const auto [it, added] = possible.try_emplace(slotName(slot.group, ""), fit);
      std::erase_if(it->second, [&](const auto& word) { return std::ranges::find(fit, word) == fit.end(); });
      if (it->second.empty()) return it->first;
    }
  }
  for (const auto& [group, fit] : possible) words[group] = fit.front();
  return "";
}

std::vector<std::string> incompleteSections(const GlslStatements& statements, const CodeSections& sections,
                                            const std::vector<std::string>& names) {
  const std::vector<Hash128> hashes = NamedCode(sections, names).hashesFor(statements);
  const auto stands = [&](const std::vector<Hash128>& block) {
    return std::search(hashes.begin(), hashes.end(), block.begin(), block.end()) != hashes.end();
  };
  std::vector<std::string> incomplete;
  for (const std::string& name : names) {
    const auto it = sections.find(name);
    if (it == sections.end() || !it->second.complete) continue;
    const std::vector<std::vector<Hash128>>& blocks = it->second.blocks();
    if (!std::all_of(blocks.begin(), blocks.end(), stands)) incomplete.push_back(name);
  }
  return incomplete;
}

std::string notesOn(const GlslStatements& statements, const CodeSections& sections,
                    const std::vector<std::string>& names) {
  const NamedCode known(sections, names);
  std::string notes;
  for (const std::string& name : names) {
    const auto it = sections.find(name);
    if (it == sections.end() || it->second.note.empty()) continue;
    bool found = false;
    for (size_t i = 0; i < statements.size() && !found; ++i) found = known.hasLike(it->second, statements[i]);
    if (found) notes.append(notes.empty() ? "" : "; ").append(it->second.note);
  }
  return notes;
}

}  // namespace gluray::gl
