// Known code: functions of programs that are evaluated.
#include "gl/families/known_code.h"
#include "gl/families/named_code.h"

#include <algorithm>
#include <set>
#include <utility>

namespace gluray::gl {
namespace {

bool hasFunctions(const KnownCode& section) {
  return std::ranges::any_of(section.patterns(), [](const StatementPattern& pattern) {
    return std::ranges::any_of(pattern.text().pieces(), [](const PatternText::Piece& piece) {
      return piece.kind == PatternText::Piece::Kind::function;
    });
  });
}

/// The functions of a program, and which of them are taken away.
class TakenFunctions {
 public:
  explicit TakenFunctions(const GlslStatements& statements) : statements_(statements) {
    for (size_t i = 0; i < statements.size(); ++i)
      if (const std::string_view name = definedBy(statements[i]); !name.empty()) defined_[name].push_back(i);
  }

  /// Takes a function and those that it calls. False: there are different ones of a name, or none.
  bool take(std::string_view name) {
    if (!taken_.insert(name).second) return true;
    const auto found = defined_.find(name);
    if (found == defined_.end()) return false;
    const std::string_view text = statements_[found->second.front()];
    if (!std::ranges::all_of(found->second, [&](size_t i) { return statements_[i] == text; })) return false;
    bool whole = true;
    eachWord(text, [&](std::string_view word) { whole = whole && (!defined_.contains(word) || take(word)); });
    return whole;
  }
  bool has(std::string_view name) const { return taken_.contains(name); }
  /// For each statement.
  std::vector<bool> places() const {
    std::vector<bool> all(statements_.size());
    for (const std::string_view name : taken_)
      for (const size_t i : defined_.at(name)) all[i] = true;
    return all;
  }

 private:
  const GlslStatements& statements_;
  std::map<std::string_view, std::vector<size_t>> defined_;
  std::set<std::string_view> taken_;
};

/// A taken function that the statement calls elsewhere than at its placeholders; empty: there is none.
std::string calledElsewhere(std::string_view statement, const TakenFunctions& taken,
                            const PatternMatch& match) {
  std::string found;
  std::map<std::string_view, int> calls;
  eachWord(statement, [&](std::string_view word) { calls[word] += taken.has(word); });
  for (const PatternMatch::Function& function : match.functions) --calls[function.called];
  for (const auto& [name, count] : calls)
    if (count != 0) found = name;
  return found;
}

}  // namespace

std::string takeFunctions(GlslStatements& statements, const CodeSections& sections,
                          const std::vector<std::string>& names, FunctionNames& functions) {
  const NamedCode known(sections, names);
  if (!std::ranges::any_of(known.sections(), [](const KnownCode* code) { return hasFunctions(*code); }))
    return "";
  std::vector<PatternMatch> matches(statements.size());
  TakenFunctions taken(statements);
  for (size_t i = 0; i < statements.size(); ++i) {
    if (!known.patternOf(statements[i], matches[i])) matches[i] = {};
    for (const PatternMatch::Function& function : matches[i].functions) {
      const auto [it, added] = functions.emplace(function.name, function.called);
      if (it->second != function.called) return it->first;
      if (added && !taken.take(function.called)) return it->second;
    }
  }
  const std::vector<bool> places = taken.places();
  for (size_t i = 0; i < statements.size(); ++i)
    if (!places[i])
      if (std::string name = calledElsewhere(statements[i], taken, matches[i]); !name.empty()) return name;
  statements.drop(places);
  return "";
}

}  // namespace gluray::gl
