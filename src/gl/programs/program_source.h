// The source of a program's shaders, asked of the real OpenGL when it is first needed. GL thread, context
// current.
#pragma once
#include "gl/families/glsl_statements.h"
#include "gl/real.h"

#include <string>
#include <vector>

namespace gluray::gl {

class ProgramSource {
 public:
  ProgramSource(const RealGl& real, GLuint program) : real_(real), program_(program) {}

  /// Texts of the shaders that are attached, one after the other, without comments.
  const std::string& text();
  /// The same as statements; empty where no shader is attached. A name may read as another one that the text
  /// does not have. Valid until they are asked for with another name.
  const GlslStatements& statements(const GlslStatements::Renamed& renamed = {});
  /// Whether the text of every attached shader could be read, and one of them is a vertex shader, one a
  /// fragment shader, and where `geometry` is true one a geometry shader.
  bool isWhole(bool geometry);

 private:
  struct Shader {
    GLenum type;
    size_t begin, end;  // of its text
  };
  void read();
  bool readShader(GLuint shader);
  bool has(GLenum type) const;

  const RealGl& real_;
  GLuint program_;
  bool isRead_ = false, allRead_ = false, hasText_ = false, hasStatements_ = false;
  std::string source_, text_;  // source_: as it was given, one shader after the other
  std::vector<Shader> shaders_;
  GlslStatements statements_;
  GlslStatements::Renamed renamed_;
};

}  // namespace gluray::gl
