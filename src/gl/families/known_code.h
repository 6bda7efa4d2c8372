// Named sections of shader statements whose effect families describe. A shader program with other statements
// computes something that we do not know. Format: docs/program-families.md. Any thread.
#pragma once
#include "base/hash.h"
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
  /// Adds all statements of `text`.
  void add(std::string_view text);
  /// Adds blocks: statements that must occur together, in this order. Empty lines separate blocks.
  void addBlocks(std::string_view text);
  /// Adds a name that some statement of a shader program must write if another one reads it.
  void addWritten(const std::string& name) { written_.insert(name); }
  /// Adds the digest of a whole shader (shader_digest.h).
  void addShader(const Hash128& digest) { shaders_.push_back(digest); }
  void add(const KnownCode& more);
  bool has(Hash128 statement) const;
  size_t size() const { return statements_.size(); }
  const std::vector<std::vector<Hash128>>& blocks() const { return blocks_; }
  const std::vector<Hash128>& shaders() const { return shaders_; }
  const std::set<std::string>& written() const { return written_; }
  /// Programs of families that name the section have all its blocks.
  bool complete = false;
  /// Note for users about shader programs that have one of these statements; may be empty.
  std::string note;

 private:
  void sort();
  std::vector<Hash128> statements_;  // sorted
  std::vector<std::vector<Hash128>> blocks_;
  std::vector<Hash128> shaders_;
  std::set<std::string> written_;
};

/// Sections of known code by name.
using CodeSections = std::map<std::string, KnownCode, std::less<>>;

inline Hash128 hashOf(std::string_view statement) { return hashBytes(statement.data(), statement.size()); }

/// Those of `statements` that none of the sections `names` has, in order, without repetitions.
std::vector<std::string_view> unknownStatements(const GlslStatements& statements,
                                                const CodeSections& sections,
                                                const std::vector<std::string>& names);

/// Those of `statements`, without repetitions, that belong to a block of the sections but occur without the
/// rest of it, and known ones outside blocks that compute something a second time in one shader.
std::vector<std::string_view> strayStatements(const GlslStatements& statements, const CodeSections& sections,
                                              const std::vector<std::string>& names);

/// Digests of whole shaders that the sections `names` know; if there are any, statements do not count.
std::vector<Hash128> knownShaders(const CodeSections& sections, const std::vector<std::string>& names);

/// Names of addWritten() that some of `statements` reads and none writes.
std::vector<std::string> unwrittenNames(const GlslStatements& statements, const CodeSections& sections,
                                        const std::vector<std::string>& names);

/// Those of the sections `names` that are complete and have a block that `statements` lack.
std::vector<std::string> incompleteSections(const GlslStatements& statements, const CodeSections& sections,
                                            const std::vector<std::string>& names);

/// The notes of those sections of `names` that have any of the statements, joined by "; ".
std::string notesOn(const GlslStatements& statements, const CodeSections& sections,
                    const std::vector<std::string>& names);

}  // namespace gluray::gl
