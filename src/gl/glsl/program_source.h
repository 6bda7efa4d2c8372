// The source of a shader program's shaders. GL thread, context current.
#pragma once
#include "base/hash.h"
#include "gl/glsl/glsl_branches.h"
#include "gl/glsl/glsl_statements.h"
#include "gl/glsl/program.h"
#include "gl/glsl/shader_texts.h"
#include "gl/real/real.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gluray::gl {

class ProgramSource {
 public:
  /// Uses the shaders' texts from link time. If these are not known, it reads the shaders that are attached
  /// when a text is first needed.
  ProgramSource(const RealGl& real, const Program& program)
      : real_(real), program_(program.name), linked_(program.texts) {}

  /// The concatenated texts of the shaders, without comments.
  const std::string& text();
  /// How the text is cut into statements.
  struct Cut {
    GlslStatements::Renamed renamed;  // replaces one name, unless the text already has the new name
    bool resolved = false;            // without the lines that conditions exclude (glsl_conditions.h), and
                                      // without functions and constants that are not used
    bool wholeMain = false;           // main is one statement
    DecidedValues decided;            // with the branches that follow from these values (glsl_branches.h)
    bool operator==(const Cut&) const = default;
  };
  /// The text as statements; empty if there is no text, or its lines cannot be resolved. Valid until the next
  /// call with another `how`.
  const GlslStatements& statements(const Cut& how);
  /// Type and digest (shader_digest.h) of each shader.
  std::vector<std::pair<GLenum, Hash128>> digests();
  /// The texts of all shaders of one type, concatenated.
  std::string textOf(GLenum type);
  /// Whether the texts of all shaders could be read, and these include a vertex shader, a fragment shader
  /// and, if `geometry`, a geometry shader.
  bool isWhole(bool geometry);

 private:
  struct Shader {
    GLenum type;
    size_t begin, end;  // of its text in source_
  };
  void read();
  bool has(GLenum type) const;

  const RealGl& real_;
  GLuint program_;
  std::shared_ptr<const ShaderTexts> linked_;
  bool isRead_ = false, allRead_ = false, hasText_ = false, hasStatements_ = false;
  std::string source_, text_;  // source_: the original texts, concatenated
  std::vector<Shader> shaders_;
  GlslStatements statements_;
  Cut cut_;  // of statements_
};

}  // namespace gluray::gl
