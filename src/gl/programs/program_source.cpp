#include "gl/programs/program_source.h"

#include <algorithm>
#include <string_view>

namespace gluray::gl {
namespace {

constexpr GLsizei kShaders = 32;  // a stage may have several; isWhole() is false for programs with more

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

void ProgramSource::read() {
  if (isRead_) return;
  source_.clear(), shaders_.clear(), shaders_.reserve(kShaders);
  GLuint shaders[kShaders] = {};
  GLint attached = 0;
  GLsizei count = 0;
  real_.GetProgramiv(program_, GL_ATTACHED_SHADERS, &attached);
  real_.GetAttachedShaders(program_, kShaders, &count, shaders);
  count = std::clamp(count, 0, kShaders);
  allRead_ = count == attached;
  for (GLsizei i = 0; i < count; ++i) allRead_ = readShader(shaders[i]) && allRead_;
  isRead_ = true;
}

/// False if the shader has no text or not all of it could be read.
bool ProgramSource::readShader(GLuint shader) {
  GLint type = 0, length = 0;  // length includes the terminating 0
  real_.GetShaderiv(shader, GL_SHADER_TYPE, &type);
  real_.GetShaderiv(shader, GL_SHADER_SOURCE_LENGTH, &length);
  if (length <= 0) return false;
  const size_t begin = source_.size();
  GLsizei written = 0;
  source_.resize(begin + static_cast<size_t>(length));
  real_.GetShaderSource(shader, length, &written, source_.data() + begin);
  source_.resize(begin + static_cast<size_t>(std::clamp(written, 0, length - 1)));
  shaders_.push_back({static_cast<GLenum>(type), begin, source_.size()});
  return written == length - 1;  // else another thread has changed the text
}

bool ProgramSource::has(GLenum type) const {
  const auto is = [&](const Shader& s) { return s.type == type && s.end > s.begin; };
  return std::any_of(shaders_.begin(), shaders_.end(), is);
}

bool ProgramSource::isWhole(bool geometry) {
  read();
  return allRead_ && has(GL_VERTEX_SHADER) && has(GL_FRAGMENT_SHADER) &&
         (!geometry || has(GL_GEOMETRY_SHADER));
}

const std::string& ProgramSource::text() {
  if (hasText_) return text_;
  read();
  text_.clear(), text_.reserve(source_.size());
  for (const Shader& s : shaders_)
    appendWithoutComments(std::string_view(source_).substr(s.begin, s.end - s.begin), text_);
  hasText_ = true;
  return text_;
}

const GlslStatements& ProgramSource::statements(const GlslStatements::Renamed& renamed) {
  if (hasStatements_ && renamed_ == renamed) return statements_;
  const bool clear = renamed.to.empty() || text().find(renamed.to) == std::string::npos;
  read();
  statements_ = {};
  for (const Shader& s : shaders_)
    statements_.cut(std::string_view(source_).substr(s.begin, s.end - s.begin),
                    clear ? renamed : GlslStatements::Renamed{});
  hasStatements_ = true, renamed_ = renamed;
  return statements_;
}

}  // namespace gluray::gl
