#include "gl/programs/program_source.h"

#include "gl/programs/glsl_statements.h"

#include <algorithm>

namespace gluray::gl {
namespace {

constexpr GLsizei kShaders = 8;  // more than there are stages

/// Appends GLSL without its comments.
void appendWithoutComments(std::string_view text, std::string& out) {
  for (size_t i = 0; i < text.size();) {
    if (text.compare(i, 2, "//") == 0) {
      i = std::min(text.find('\n', i), text.size());
    } else if (text.compare(i, 2, "/*") == 0) {
      const size_t end = text.find("*/", i + 2);
      i = end == std::string_view::npos ? text.size() : end + 2;
    } else {
      out += text[i++];
    }
  }
}

}  // namespace

/// Calls each(shader, bytes of its text).
template <class Each>
void ProgramSource::eachShader(Each&& each) const {
  GLuint shaders[kShaders] = {};
  GLsizei count = 0;
  real_.GetAttachedShaders(program_, kShaders, &count, shaders);
  for (GLsizei i = 0; i < count; ++i) {
    GLint length = 0;
    real_.GetShaderiv(shaders[i], GL_SHADER_SOURCE_LENGTH, &length);
    if (length > 0) each(shaders[i], static_cast<size_t>(length));
  }
}

const std::string& ProgramSource::text() {
  if (hasText_) return text_;
  size_t all = 0;
  eachShader([&](GLuint, size_t length) { all += length; });
  text_.clear(), text_.reserve(all);
  std::string one;
  eachShader([&](GLuint shader, size_t length) {
    one.resize(length);
    GLsizei written = 0;
    real_.GetShaderSource(shader, static_cast<GLsizei>(length), &written, one.data());
    appendWithoutComments({one.data(), static_cast<size_t>(written)}, text_);
  });
  hasText_ = true;
  return text_;
}

const std::vector<std::string_view>& ProgramSource::statements() {
  if (hasStatements_) return statements_;
  size_t all = 0;
  eachShader([&](GLuint, size_t length) { all += length; });
  code_.resize(all);
  statements_.clear(), statements_.reserve(256);
  size_t at = 0;
  eachShader([&](GLuint shader, size_t length) {
    GLsizei written = 0;
    if (at + length > all) return;  // another thread has given it another text
    real_.GetShaderSource(shader, static_cast<GLsizei>(length), &written, code_.data() + at);
    cutStatements({code_.data() + at, static_cast<size_t>(written)}, statements_);
    at += length;
  });
  hasStatements_ = true;
  return statements_;
}

}  // namespace gluray::gl
