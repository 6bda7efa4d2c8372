#include "gl/programs/match.h"

#include <algorithm>

namespace gluray::gl {
namespace {

std::string quoted(const std::string& name) { return "\"" + name + "\""; }

void needActive(const Program& p, const Family& f, std::vector<std::string>& out) {
  for (const std::string& name : f.active)
    if (!p.isActive(name)) out.push_back("lacks " + quoted(name));
  const auto active = [&](const std::string& name) { return p.isActive(name); };
  if (!f.any.empty() && std::none_of(f.any.begin(), f.any.end(), active))
    out.push_back("has none of " + quoted(f.any.front()) + (f.any.size() > 1 ? " ..." : ""));
}

void refuseActive(const RealGl& real, const Program& p, const Family& f, std::vector<std::string>& out) {
  for (const std::string& name : f.absent)
    if (p.isActive(name)) out.push_back("has " + quoted(name));
  for (const std::string& name : f.absentOutputs)
    if (hasOutput(real, p, name)) out.push_back("has output " + quoted(name));
}

void needMentioned(const Program& p, const Family& f, std::vector<std::string>& out) {
  if (!f.strict) return;
  for (const auto& [name, place] : p.uniforms)
    if (!f.mentions(name))
      out.push_back("has uniform " + quoted(name) + ", of which the family says nothing");
  for (const auto& [name, place] : p.attributes)
    if (!f.mentions(name))
      out.push_back("has attribute " + quoted(name) + ", of which the family says nothing");
}

/// What tracing needs of any program.
void needSources(const Program& p, const Family& f, std::vector<std::string>& out) {
  if (!f.rasteriseBecause.empty()) return;
  if (p.geometryShader) out.push_back("has a geometry shader");
  if (p.tessellation) out.push_back("has tessellation shaders");
  if (!p.attribute(f.position)) out.push_back("lacks attribute " + quoted(f.position));
  for (const std::string& name : f.clipFromObject)
    if (!p.uniform(name)) out.push_back("lacks uniform " + quoted(name));
  const bool normals = p.attribute(f.normal) || p.uniform(f.triangleNormals);
  if (!normals && f.model != Family::Model::unlit && f.withoutNormals == Family::NoNormals::refuse)
    out.push_back("lacks attribute " + quoted(f.normal));
}

}  // namespace

std::vector<std::string> obstacles(const RealGl& real, const Program& program, const Family& family) {
  std::vector<std::string> out;
  if (!program.linked) return {"is not linked"};
  needActive(program, family, out);
  refuseActive(real, program, family, out);
  needSources(program, family, out);
  needMentioned(program, family, out);
  return out;
}

std::shared_ptr<const KnownProgram> recognise(const RealGl& real, GLuint name, const FamilyList& families) {
  auto known = std::make_shared<KnownProgram>();
  known->program = reflect(real, name);
  std::vector<std::string> fewest;
  const Family* nearest = nullptr;
  for (const auto& family : families) {
    const std::vector<std::string> found = obstacles(real, known->program, *family);
    if (found.empty()) {
      known->family = family;
      known->why = family->rasteriseBecause;
      return known;
    }
    // A family that is never traced tells nobody what to change.
    if (family->rasteriseBecause.empty() && (!nearest || found.size() < fewest.size()))
      nearest = family.get(), fewest = found;
  }
  known->why = known->program.linked ? "no family fits" : "not linked";
  if (nearest && known->program.linked) {
    known->why += "; nearest: " + nearest->name;
    for (size_t i = 0; i < fewest.size() && i < 4; ++i) known->why += (i ? ", " : ", but it ") + fewest[i];
    if (fewest.size() > 4) known->why += " and " + std::to_string(fewest.size() - 4) + " more";
  }
  return known;
}

}  // namespace gluray::gl
