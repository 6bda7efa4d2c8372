#include "gl/programs/renames.h"

#include <algorithm>

namespace gluray::gl {

bool isKnown(const std::string& name, const Family& f, const Renames& renamed) {
  const auto isTaken = [&](const auto& pair) { return pair.second == name; };
  return f.mentions(name) || std::any_of(renamed.begin(), renamed.end(), isTaken);
}

namespace {

/// The only sampler2D that the family does not mention; null if there is none or several.
const std::string* onlyUnknownTexture(const Program& p, const Family& f, const Renames& renamed) {
  const std::string* only = nullptr;
  for (const auto& [name, uniform] : p.uniforms) {
    if (uniform.type != GL_SAMPLER_2D || isKnown(name, f, renamed)) continue;
    if (only) return nullptr;
    only = &name;
  }
  return only;
}

}  // namespace

Renames renamedBy(const Program& program, const Family& family) {
  Renames renamed;
  const auto has = [&](const std::string& name) {
    return program.uniforms.contains(name) || program.attributes.contains(name);
  };
  for (const auto& [name, others] : family.alternatives) {
    const auto other = has(name) ? others.end() : std::find_if(others.begin(), others.end(), has);
    if (other != others.end()) renamed[name] = *other;
  }
  if (!family.anyTexture.empty() && !has(family.anyTexture))
    if (const std::string* other = onlyUnknownTexture(program, family, renamed))
      renamed[family.anyTexture] = *other;
  return renamed;
}

}  // namespace gluray::gl
