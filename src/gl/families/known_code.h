// Named sections of shader statements whose effect families describe. A shader program with other statements
// may compute something else. Format: docs/program-families.md. Any thread.
#pragma once
#include "base/hash.h"
#include "gl/families/statement_pattern.h"
#include "gl/glsl/glsl_statements.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// Statements in the normal form of glsl_statements.h.
class KnownCode {
 public:
  /// A slot that a statement or a fragment has.
  struct SlotUse {
    std::string group, part;
    std::string within;  // group of the fragment; empty: it is a statement
    std::string place;   // of the text, for mistakes
  };
  /// Adds all statements of `text`. They may have placeholders and slots (pattern_text.h). `place` names the
  /// text in mistakes.
  /// `wholeMain`: main is one statement.
  void add(std::string_view text, const std::string& place = "", bool wholeMain = false);
  /// Adds blocks: statements that must occur together, in this order. Empty lines separate blocks.
  void addBlocks(std::string_view text, const std::string& place = "");
  /// Adds a word to a group of slots.
  void addWord(const std::string& group, const std::string& word, const std::string& place = "") {
    fragments_.addWord(group, word, place);
  }
  /// Programs must have one of the words of the group.
  void requireWord(const std::string& group) { fragments_.require(group); }
  /// Adds a fragment that may stand in the slot "@group.part" of programs with this word.
  void addFragment(const std::string& group, const std::string& word, const std::string& part,
                   std::string_view text, const std::string& place = "");
  /// Adds a name that must be written by some statement of a shader program if another one reads it.
  void addWritten(const std::string& name) { written_.insert(name); }
  /// Adds the digest of a whole shader (shader_digest.h).
  void addShader(const Hash128& digest) { shaders_.push_back(digest); }
  void add(const KnownCode& more);
  bool has(Hash128 statement) const;
  const std::vector<StatementPattern>& patterns() const { return patterns_; }
  const SlotFragments& fragments() const { return fragments_; }
  const std::vector<SlotUse>& slotUses() const { return slotUses_; }
  size_t size() const { return statements_.size(); }
  const std::vector<std::vector<Hash128>>& blocks() const { return blocks_; }
  const std::vector<Hash128>& shaders() const { return shaders_; }
  const std::set<std::string>& written() const { return written_; }
  /// A program of a family that names the section must contain all its blocks.
  bool complete = false;
  /// Note for users about shader programs that have one of these statements; may be empty.
  std::string note;

 private:
  void sort();
  /// Hash of a statement, which is kept as a pattern if it has placeholders or slots.
  Hash128 hashOfKnown(std::string_view statement, const std::string& place);
  void addUses(const PatternText& text, const std::string& group, const std::string& place);
  std::vector<Hash128> statements_;  // sorted
  std::vector<StatementPattern> patterns_;
  SlotFragments fragments_;
  std::vector<SlotUse> slotUses_;
  std::vector<std::vector<Hash128>> blocks_;
  std::vector<Hash128> shaders_;
  std::set<std::string> written_;
};

/// Sections of known code by name.
using CodeSections = std::map<std::string, KnownCode, std::less<>>;

inline Hash128 hashOf(std::string_view statement) { return hashBytes(statement.data(), statement.size()); }

/// The statements that none of the sections `names` contains, in order, without repetitions.
std::vector<std::string_view> unknownStatements(const GlslStatements& statements,
                                                const CodeSections& sections,
                                                const std::vector<std::string>& names);

/// Statements, without repetitions, that break the rules of known code: statements of a block that occur
/// without the rest of it, and known statements outside blocks that compute something a second time in one
/// shader.
std::vector<std::string_view> strayStatements(const GlslStatements& statements, const CodeSections& sections,
                                              const std::vector<std::string>& names);

/// Digests of whole shaders that the sections `names` contain. If there are any, shaders are compared instead
/// of statements.
std::vector<Hash128> knownShaders(const CodeSections& sections, const std::vector<std::string>& names);

/// Names of addWritten() that one of `statements` reads and none writes.
std::vector<std::string> unwrittenNames(const GlslStatements& statements, const CodeSections& sections,
                                        const std::vector<std::string>& names);

/// Adds the numbers that stand in `statements` for placeholders of the sections `names` to `values`. Returns
/// the name of a placeholder for which there are different numbers; empty if there is none.
std::string readPlaceholders(const GlslStatements& statements, const CodeSections& sections,
                             const std::vector<std::string>& names, PlaceholderValues& values);

/// Names of functions by the placeholders that stand for them.
using FunctionNames = std::map<std::string, std::string, std::less<>>;

/// Finds the functions that stand for placeholders of the sections `names`, and takes these and all functions
/// that they call away from `statements`: they are evaluated in place of being compared. Returns the name of
/// a placeholder or function that is not unique, or is called elsewhere, too; empty if there is none.
std::string takeFunctions(GlslStatements& statements, const CodeSections& sections,
                          const std::vector<std::string>& names, FunctionNames& functions);

/// Finds the word of each group of slots that the statements have: the first one whose fragments stand in all
/// of its slots. Sets `words`, or returns the name of a group that has none, with "@"; empty if all have one.
std::string readWords(const GlslStatements& statements, const CodeSections& sections,
                      const std::vector<std::string>& names, SlotWords& words);

/// The complete sections among `names` that have a block missing from `statements`.
std::vector<std::string> incompleteSections(const GlslStatements& statements, const CodeSections& sections,
                                            const std::vector<std::string>& names);

/// The notes of the sections among `names` that contain any of the statements, joined by "; ".
std::string notesOn(const GlslStatements& statements, const CodeSections& sections,
                    const std::vector<std::string>& names);

}  // namespace gluray::gl
