#include "gl/families/known_code.h"

#include "gl/glsl/glsl_tokens.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace gluray::gl {
namespace {

std::vector<const KnownCode*> named(const CodeSections& sections, const std::vector<std::string>& names) {
  std::vector<const KnownCode*> known;
  known.reserve(names.size());
  for (const std::string& name : names)
    if (const auto it = sections.find(name); it != sections.end()) known.push_back(&it->second);
  return known;
}

bool isBefore(const Hash128& a, const Hash128& b) {
  return a.high != b.high ? a.high < b.high : a.low < b.low;
}

bool anyHas(const std::vector<const KnownCode*>& known, const Hash128& statement) {
  return std::any_of(known.begin(), known.end(), [&](const auto* code) { return code->has(statement); });
}

/// The pattern that the statement fits, and its numbers; null if there is none.
const StatementPattern* patternOf(std::string_view statement, const std::vector<const KnownCode*>& known,
                                  std::vector<float>& numbers) {
  for (const KnownCode* code : known)
    for (const StatementPattern& pattern : code->patterns()) {
      numbers.clear();
      if (pattern.fits(statement, numbers)) return &pattern;
    }
  return nullptr;
}

/// The statement's hash; if only a pattern makes it known, that of the pattern.
Hash128 knownHash(std::string_view statement, const std::vector<const KnownCode*>& known) {
  const Hash128 own = hashOf(statement);
  if (anyHas(known, own)) return own;
  std::vector<float> numbers;
  const StatementPattern* pattern = patternOf(statement, known, numbers);
  return pattern ? pattern->hash() : own;
}

std::vector<Hash128> knownHashes(const GlslStatements& statements,
                                 const std::vector<const KnownCode*>& known) {
  std::vector<Hash128> hashes;
  hashes.reserve(statements.size());
  for (size_t i = 0; i < statements.size(); ++i) hashes.push_back(knownHash(statements[i], known));
  return hashes;
}

}  // namespace

Hash128 KnownCode::hashOfKnown(std::string_view statement) {
  if (statement.find('$') != std::string_view::npos) patterns_.emplace_back(statement);
  return hashOf(statement);
}

void KnownCode::add(std::string_view text) {
  GlslStatements statements;
  statements.cut(text);
  statements_.reserve(statements_.size() + statements.size());
  for (size_t i = 0; i < statements.size(); ++i) statements_.push_back(hashOfKnown(statements[i]));
  sort();
}

void KnownCode::addBlocks(std::string_view text) {
  while (!text.empty()) {
    const size_t end = std::min(text.find("\n\n"), text.size());
    GlslStatements statements;
    statements.cut(text.substr(0, end));
    std::vector<Hash128> block;
    for (size_t i = 0; i < statements.size(); ++i) block.push_back(hashOfKnown(statements[i]));
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
  sort();
}

void KnownCode::sort() {
  std::sort(statements_.begin(), statements_.end(), isBefore);
  statements_.erase(std::unique(statements_.begin(), statements_.end()), statements_.end());
}

bool KnownCode::has(Hash128 statement) const {
  return std::binary_search(statements_.begin(), statements_.end(), statement, isBefore);
}

std::vector<Hash128> knownShaders(const CodeSections& sections, const std::vector<std::string>& names) {
  std::vector<Hash128> all;
  for (const KnownCode* code : named(sections, names))
    all.insert(all.end(), code->shaders().begin(), code->shaders().end());
  return all;
}

std::vector<std::string_view> unknownStatements(const GlslStatements& statements,
                                                const CodeSections& sections,
                                                const std::vector<std::string>& names) {
  const std::vector<const KnownCode*> known = named(sections, names);
  std::vector<std::string_view> unknown;
  for (size_t i = 0; i < statements.size(); ++i) {
    const std::string_view statement = statements[i];
    if (anyHas(known, knownHash(statement, known))) continue;
    if (std::find(unknown.begin(), unknown.end(), statement) == unknown.end()) unknown.push_back(statement);
  }
  return unknown;
}

namespace {

/// Blocks by their first statement, and the set of all statements of blocks.
class Blocks {
 public:
  explicit Blocks(const std::vector<const KnownCode*>& known) {
    for (const KnownCode* code : known) {
      for (const std::vector<Hash128>& block : code->blocks()) {
        byFirst_.emplace(block.front(), &block);
        members_.insert(block.begin(), block.end());
      }
    }
  }
  bool has(const Hash128& statement) const { return members_.contains(statement); }
  /// Length of the longest whole block that begins at statement `i`; 0: none.
  size_t lengthAt(const std::vector<Hash128>& statements, size_t i) const {
    size_t longest = 0;
    const auto [begin, end] = byFirst_.equal_range(statements[i]);
    for (auto it = begin; it != end; ++it) {
      const std::vector<Hash128>& block = *it->second;
      const bool fits =
          block.size() <= statements.size() - i &&
          std::equal(block.begin(), block.end(), statements.begin() + static_cast<std::ptrdiff_t>(i));
      if (fits) longest = std::max(longest, block.size());
    }
    return longest;
  }

 private:
  using Before = decltype(&isBefore);
  std::multimap<Hash128, const std::vector<Hash128>*, Before> byFirst_{isBefore};
  std::set<Hash128, Before> members_{isBefore};
};

/// Whether the statement computes something when it is repeated.
bool computes(std::string_view statement) {
  return statement[0] != '#' && statement.substr(0, 4) != "for(" &&
         statement.find('=') != std::string_view::npos;
}

/// Whether the statement writes the name at `at`, `size` long: "name[i].xy=", "vec3 name=".
bool isWrite(std::string_view statement, size_t at, size_t size) {
  size_t end = at + size;
  const auto isPlace = [](char c) { return c == '.' || c == '[' || c == ']' || isWordPart(c); };
  while (end < statement.size() && isPlace(statement[end])) ++end;
  return end < statement.size() && statement[end] == '=' && statement.substr(end, 2) != "==";
}

enum class Use { none, read, written };

/// How a statement uses a name. A statement that reads and writes it counts as reading.
Use useOf(std::string_view name, std::string_view statement) {
  Use use = Use::none;
  for (size_t at = statement.find(name); at != std::string_view::npos; at = statement.find(name, at + 1)) {
    const size_t end = at + name.size();
    if ((at > 0 && isWordPart(statement[at - 1])) || (end < statement.size() && isWordPart(statement[end])))
      continue;
    if (!isWrite(statement, at, name.size())) return Use::read;
    use = Use::written;
  }
  return use;
}

}  // namespace

std::vector<std::string_view> strayStatements(const GlslStatements& statements, const CodeSections& sections,
                                              const std::vector<std::string>& names) {
  const std::vector<const KnownCode*> known = named(sections, names);
  const Blocks blocks(known);
  const std::vector<Hash128> hashes = knownHashes(statements, known);
  std::vector<std::string_view> stray;
  for (size_t i = 0; i < hashes.size(); ++i) {
    const bool inBlock = blocks.has(hashes[i]);
    const size_t length = inBlock ? blocks.lengthAt(hashes, i) : 0;
    if (length > 0) {
      i += length - 1;
      continue;
    }
    const bool again =
        !inBlock && statements.isRepeated(i) && computes(statements[i]) && anyHas(known, hashes[i]);
    if ((inBlock || again) && std::find(stray.begin(), stray.end(), statements[i]) == stray.end())
      stray.push_back(statements[i]);
  }
  return stray;
}

std::vector<std::string> unwrittenNames(const GlslStatements& statements, const CodeSections& sections,
                                        const std::vector<std::string>& names) {
  std::vector<std::string> unwritten;
  std::set<std::string> all;
  for (const KnownCode* code : named(sections, names))
    all.insert(code->written().begin(), code->written().end());
  for (const std::string& name : all) {
    bool uses[3] = {};
    for (size_t i = 0; i < statements.size(); ++i) uses[static_cast<int>(useOf(name, statements[i]))] = true;
    if (uses[static_cast<int>(Use::read)] && !uses[static_cast<int>(Use::written)]) unwritten.push_back(name);
  }
  return unwritten;
}

std::string readPlaceholders(const GlslStatements& statements, const CodeSections& sections,
                             const std::vector<std::string>& names, PlaceholderValues& values) {
  const std::vector<const KnownCode*> known = named(sections, names);
  std::vector<float> numbers;
  for (size_t i = 0; i < statements.size(); ++i) {
    if (anyHas(known, hashOf(statements[i]))) continue;
    const StatementPattern* pattern = patternOf(statements[i], known, numbers);
    for (size_t k = 0; pattern && k < numbers.size(); ++k) {
      const auto [it, added] = values.emplace(pattern->names()[k], numbers[k]);
      if (!added && it->second != numbers[k]) return it->first;
    }
  }
  return "";
}

std::vector<std::string> incompleteSections(const GlslStatements& statements, const CodeSections& sections,
                                            const std::vector<std::string>& names) {
  const std::vector<Hash128> hashes = knownHashes(statements, named(sections, names));
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
  std::string notes;
  for (const std::string& name : names) {
    const auto it = sections.find(name);
    if (it == sections.end() || it->second.note.empty()) continue;
    bool found = false;
    for (size_t i = 0; i < statements.size() && !found; ++i)
      found = it->second.has(knownHash(statements[i], {&it->second}));
    if (found) notes.append(notes.empty() ? "" : "; ").append(it->second.note);
  }
  return notes;
}

}  // namespace gluray::gl
