#include "gl/programs/known_code.h"

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

bool isBefore(const Hash128& a, const Hash128& b) {
  return a.high != b.high ? a.high < b.high : a.low < b.low;
}

}  // namespace

void KnownCode::add(std::string_view text) {
  GlslStatements statements;
  statements.cut(text);
  statements_.reserve(statements_.size() + statements.size());
  for (size_t i = 0; i < statements.size(); ++i) statements_.push_back(hashOf(statements[i]));
  sort();
}

void KnownCode::add(const KnownCode& more) {
  if (note.empty()) note = more.note;
  statements_.insert(statements_.end(), more.statements_.begin(), more.statements_.end());
  sort();
}

void KnownCode::sort() {
  std::sort(statements_.begin(), statements_.end(), isBefore);
  statements_.erase(std::unique(statements_.begin(), statements_.end()), statements_.end());
}

bool KnownCode::has(Hash128 statement) const {
  return std::binary_search(statements_.begin(), statements_.end(), statement, isBefore);
}

std::vector<std::string_view> unknownStatements(const GlslStatements& statements,
                                                const CodeSections& sections,
                                                const std::vector<std::string>& names) {
  std::vector<const KnownCode*> known;
  known.reserve(names.size());
  for (const std::string& name : names)
    if (const auto it = sections.find(name); it != sections.end()) known.push_back(&it->second);
  std::vector<std::string_view> unknown;
  for (size_t i = 0; i < statements.size(); ++i) {
    const std::string_view statement = statements[i];
    const Hash128 hash = hashOf(statement);
    const auto has = [&](const KnownCode* code) { return code->has(hash); };
    if (std::any_of(known.begin(), known.end(), has)) continue;
    if (std::find(unknown.begin(), unknown.end(), statement) == unknown.end()) unknown.push_back(statement);
  }
  return unknown;
}

std::string notesOn(const GlslStatements& statements, const CodeSections& sections,
                    const std::vector<std::string>& names) {
  std::string notes;
  for (const std::string& name : names) {
    const auto it = sections.find(name);
    if (it == sections.end() || it->second.note.empty()) continue;
    bool found = false;
    for (size_t i = 0; i < statements.size() && !found; ++i) found = it->second.has(hashOf(statements[i]));
    if (found) notes.append(notes.empty() ? "" : "; ").append(it->second.note);
  }
  return notes;
}

}  // namespace gluray::gl
