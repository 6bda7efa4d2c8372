// Statements of shaders whose effect families describe, in named sections: a program that has others computes
// something that nobody has told us. Format: docs/program-families.md. Any thread.
#pragma once
#include "base/hash.h"
#include "gl/families/glsl_statements.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// Statements in the normal form of glsl_statements.h.
class KnownCode {
 public:
  /// Adds all statements of `text`.
  void add(std::string_view text);
  /// Adds statements that stand one behind the other, all of them: blocks are parted by empty lines.
  void addBlocks(std::string_view text);
  /// Adds a name that some statement of the program must write where another one reads it.
  void addWritten(const std::string& name) { written_.insert(name); }
  void add(const KnownCode& more);
  bool has(Hash128 statement) const;
  size_t size() const { return statements_.size(); }
  const std::vector<std::vector<Hash128>>& blocks() const { return blocks_; }
  const std::set<std::string>& written() const { return written_; }
  /// What users are to know of programs that have one of these statements; empty: nothing.
  std::string note;

 private:
  void sort();
  std::vector<Hash128> statements_;  // sorted
  std::vector<std::vector<Hash128>> blocks_;
  std::set<std::string> written_;
};

/// Sections of known code by name.
using CodeSections = std::map<std::string, KnownCode, std::less<>>;

inline Hash128 hashOf(std::string_view statement) { return hashBytes(statement.data(), statement.size()); }

/// Those of `statements` that none of the sections `names` has, each of them once, in their order.
std::vector<std::string_view> unknownStatements(const GlslStatements& statements,
                                                const CodeSections& sections,
                                                const std::vector<std::string>& names);

/// Those of `statements`, each of them once, that stand without the rest of a block that the sections have
/// them in, and known ones of no block that compute something a second time in one shader.
std::vector<std::string_view> strayStatements(const GlslStatements& statements, const CodeSections& sections,
                                              const std::vector<std::string>& names);

/// Names that `statements` read and none of them writes, though the sections say that they must be written.
std::vector<std::string> unwrittenNames(const GlslStatements& statements, const CodeSections& sections,
                                        const std::vector<std::string>& names);

/// Notes of those sections of `names` of which there are statements, one after the other.
std::string notesOn(const GlslStatements& statements, const CodeSections& sections,
                    const std::vector<std::string>& names);

}  // namespace gluray::gl
