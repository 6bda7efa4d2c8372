// Known statements that may compute something else, because others are missing, repeated or moved.
#include "gl/families/named_code.h"
#include "gl/glsl/glsl_tokens.h"

#include <algorithm>
#include <map>
#include <set>

namespace gluray::gl {
namespace {

/// Blocks by their first statement, and the set of all statements of blocks.
class Blocks {
 public:
  explicit Blocks(const NamedCode& known) {
    for (const KnownCode* code : known.sections()) {
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
  const NamedCode known(sections, names);
  const Blocks blocks(known);
  const std::vector<Hash128> hashes = known.hashesFor(statements);
  std::vector<std::string_view> stray;
  for (size_t i = 0; i < hashes.size(); ++i) {
    const bool inBlock = blocks.has(hashes[i]);
    const size_t length = inBlock ? blocks.lengthAt(hashes, i) : 0;
    if (length > 0) {
      i += length - 1;
      continue;
    }
    const bool again =
        !inBlock && statements.isRepeated(i) && computes(statements[i]) && known.has(hashes[i]);
    if ((inBlock || again) && std::find(stray.begin(), stray.end(), statements[i]) == stray.end())
      stray.push_back(statements[i]);
  }
  return stray;
}

std::vector<std::string> unwrittenNames(const GlslStatements& statements, const CodeSections& sections,
                                        const std::vector<std::string>& names) {
  std::vector<std::string> unwritten;
  std::set<std::string> all;
  const NamedCode known(sections, names);
  for (const KnownCode* code : known.sections()) all.insert(code->written().begin(), code->written().end());
  for (const std::string& name : all) {
    bool uses[3] = {};
    for (size_t i = 0; i < statements.size(); ++i) uses[static_cast<int>(useOf(name, statements[i]))] = true;
    if (uses[static_cast<int>(Use::read)] && !uses[static_cast<int>(Use::written)]) unwritten.push_back(name);
  }
  return unwritten;
}

}  // namespace gluray::gl
