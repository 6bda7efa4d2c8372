#include "gl/glsl/program_source.h"

#include "gl/glsl/glsl_conditions.h"
#include "gl/glsl/glsl_tokens.h"
#include "gl/glsl/shader_digest.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace gluray::gl {
namespace {

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

/// Whether the text includes named texts (ARB_shading_language_include), which are not known here.
bool includesTexts(std::string_view text) {
  if (text.find("include") == std::string_view::npos) return false;
  GlslTokens tokens(text);
  for (std::string_view token = tokens.nextToken(); !token.empty(); token = tokens.nextToken())
    if (tokens.isDirective() && tokens.nextToken() == "include") return true;
  return false;
}

}  // namespace

void ProgramSource::read() {
  if (isRead_) return;
  const std::shared_ptr<const ShaderTexts> texts = linked_ ? linked_ : readShaderTexts(real_, program_);
  source_.clear(), shaders_.clear();
  for (const ShaderTexts::Shader& shader : texts->shaders) {
    shaders_.push_back({shader.type, source_.size(), source_.size() + shader.text.size()});
    source_ += shader.text;
  }
  allRead_ = texts->all && !includesTexts(source_);
  isRead_ = true;
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

std::string ProgramSource::textOf(GLenum type) {
  read();
  std::string text;
  for (const Shader& s : shaders_)
    if (s.type == type) text.append(source_, s.begin, s.end - s.begin).push_back('\n');
  return text;
}

std::vector<std::pair<GLenum, Hash128>> ProgramSource::digests() {
  read();
  std::vector<std::pair<GLenum, Hash128>> all;
  for (const Shader& s : shaders_)
    all.emplace_back(s.type, digestOf(std::string_view(source_).substr(s.begin, s.end - s.begin)));
  return all;
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

const GlslStatements& ProgramSource::statements(const Cut& how) {
  if (hasStatements_ && cut_ == how) return statements_;
  const std::string& to = how.renamed.to;
  const bool clear = to.empty() || text().find(to) == std::string::npos;
  read();
  statements_ = {};
  hasStatements_ = true, cut_ = how;
  for (const Shader& s : shaders_) {
    std::string_view text = std::string_view(source_).substr(s.begin, s.end - s.begin);
    const std::optional<std::string> rest = how.resolved ? resolveConditions(text) : std::nullopt;
    if (how.resolved && !rest) return statements_ = {};
    if (rest) text = *rest;
    const std::string taken = how.decided.empty() ? "" : decideBranches(text, how.decided);
    if (!how.decided.empty()) text = taken;
    statements_.cut(text, clear ? how.renamed : GlslStatements::Renamed{}, {how.resolved, how.wholeMain});
  }
  return statements_;
}

}  // namespace gluray::gl
