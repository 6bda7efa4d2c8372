// The source of a program's shaders, queried when first needed. GL thread, context current.
#pragma once
#include "gl/families/glsl_statements.h"
#include "gl/real.h"

#include <string>
#include <vector>

namespace gluray::gl {

class ProgramSource {
 public:
  ProgramSource(const RealGl& real, GLuint program) : real_(real), program_(program) {}

  /// The concatenated texts of the attached shaders, without comments.
  const std::string& text();
  /// The same as statements; empty if no shader is attached. `renamed` replaces one name, unless the text has
  /// the new name already. Valid until the next call with another `renamed`.
  const GlslStatements& statements(const GlslStatements::Renamed& renamed = {});
  /// Whether the texts of all attached shaders could be read, among them a vertex and a fragment shader and,
  /// if `geometry`, a geometry shader.
  bool isWhole(bool geometry);

 private:
  struct Shader {
    GLenum type;
    size_t begin, end;  // of its text in source_
  };
  void read();
  bool readShader(GLuint shader);
  bool has(GLenum type) const;

  const RealGl& real_;
  GLuint program_;
  bool isRead_ = false, allRead_ = false, hasText_ = false, hasStatements_ = false;
  std::string source_, text_;  // source_: the original texts, concatenated
  std::vector<Shader> shaders_;
  GlslStatements statements_;
  GlslStatements::Renamed renamed_;
};

}  // namespace gluray::gl
