#include "gl/programs/match.h"

#include "gl/families/variable_types.h"
#include "gl/glsl/glsl_types.h"
#include "gl/glsl/program_source.h"
#include "gl/glsl/shader_digest.h"
#include "gl/programs/built_in_uniforms.h"
#include "gl/programs/evaluated_functions.h"
#include "gl/programs/nearest_family.h"
#include "gl/programs/renames.h"
#include "gl/programs/vertex_inputs.h"
#include "gl/real/extensions.h"

#include <algorithm>
#include <cstdlib>

namespace gluray::gl {
namespace {

void needActive(const Program& p, const Family& f, std::vector<std::string>& out) {
  for (const std::string& name : f.active)
    if (!p.isActive(name)) out.push_back(about("lacks ", name));
  const auto active = [&](const std::string& name) { return p.isActive(name); };
  if (!f.any.empty() && std::none_of(f.any.begin(), f.any.end(), active))
    out.push_back(about("has none of ", f.any.front(), f.any.size() > 1 ? " ..." : ""));
}

void needSource(ProgramSource& program, const Family& f, std::vector<std::string>& out) {
  if (f.sourceHas.empty() && f.sourceLacks.empty()) return;
  const std::string& source = program.text();
  for (const std::string& text : f.sourceHas)
    if (source.find(text) == std::string::npos) out.push_back(about("lacks in its source ", text));
  for (const std::string& text : f.sourceLacks)
    if (source.find(text) != std::string::npos) out.push_back(about("has in its source ", text));
}

/// The program's statements, with its texture renamed to the name that the family uses.
const GlslStatements& statementsFor(const Family& f, const Program& p, ProgramSource& source) {
  const auto other = p.renamed.find(f.anyTexture);
  ProgramSource::Cut how{{}, f.resolvesConditions, f.wholeMain, f.decided};
  if (other != p.renamed.end()) how.renamed = {other->second, other->first};
  return source.statements(how);
}

/// Requires a vertex and a fragment shader whose digests are `known`, and no other shaders.
void needShaders(ProgramSource& source, const std::vector<Hash128>& known, std::vector<std::string>& out) {
  const auto digests = source.digests();
  if (!source.isWhole(false) || digests.size() != 2)
    return out.push_back("has no two shaders that could be read");
  for (const auto& [type, digest] : digests)
    if (std::ranges::count(known, digest) == 0)
      out.push_back(std::string("has an unknown ") + (type == GL_VERTEX_SHADER ? "vertex" : "fragment") +
                    " shader, " + textOf(digest));
}

/// Requires one word for each group of slots, and values for the words that the family's keys take.
void needWords(const GlslStatements& statements, const Family& f, const CodeSections& code,
               std::vector<std::string>& out) {
  SlotWords words;
  if (const std::string group = readWords(statements, code, f.code, words); !group.empty())
    return out.push_back(about("has no word whose fragments stand in all slots ", group));
  for (const SlotChoice& choice : f.slotChoices())
    if (const auto word = words.find(choice.slot); word != words.end() && !choice.has(word->second))
      out.push_back(about("has none of the fragments that the family needs in the slots ", choice.slot));
}

/// Requires all statements, or whole shaders, to be in the family's sections of code.
void needCode(const Program& program, ProgramSource& source, const Family& f, const CodeSections& code,
              std::vector<std::string>& out) {
  if (f.code.empty()) return;
  if (const std::vector<Hash128> known = knownShaders(code, f.code); !known.empty())
    return needShaders(source, known, out);
  GlslStatements statements = statementsFor(f, program, source);
  if (!source.isWhole(f.geometryShader) || statements.size() == 0)
    return out.push_back("has no source that could be read");
  if (!needFunctions(statements, f, code, out)) return;
  for (const std::string_view statement : unknownStatements(statements, code, f.code))
    out.push_back(about("has the unknown statement ", std::string(statement)));
  for (const std::string_view statement : strayStatements(statements, code, f.code))
    out.push_back(
        about("has the statement ", std::string(statement), " twice, or without the rest of its block"));
  for (const std::string& name : unwrittenNames(statements, code, f.code))
    out.push_back(about("reads ", name, ", which it does not write"));
  for (const std::string& section : incompleteSections(statements, code, f.code))
    out.push_back(about("lacks statements of the code section ", section));
  PlaceholderValues values;
  if (const std::string name = readPlaceholders(statements, code, f.code, values); !name.empty())
    return out.push_back(about("has different numbers for ", name));
  for (const auto& [name, value] : values)
    if (!f.mentions(name)) out.push_back(about("has a number for ", name, ", which the family does not use"));
  needWords(statements, f, code, out);
}

void refuseActive(const RealGl& real, const Program& p, const Family& f, std::vector<std::string>& out) {
  for (const std::string& name : f.absent)
    if (p.isActive(name)) out.push_back(about("has ", name));
  for (const std::string& name : f.absentOutputs)
    if (hasOutput(real, p, name)) out.push_back(about("has output ", name));
}

/// Whether the family is of programs that read this number of the vertex or instance.
bool isNumber(const Family& f, const std::string& name) {
  if (name == "gl_VertexID") return f.pulling.given() || f.impostors.instances;
  return name == "gl_InstanceID" && f.impostors.instances;
}

void needMentioned(const Program& p, const Family& f, std::vector<std::string>& out) {
  if (!f.strict) return;
  const auto check = [&](const char* kind, const std::string& name, GLenum type) {
    if (isKnown(name, f, p.renamed)) return;
    const std::string after = " (" + std::string(glslName(type)) + "), which the family does not describe";
    out.push_back(about(kind, name, after));
  };
  for (const auto& [name, uniform] : p.uniforms) check("has uniform ", name, uniform.type);
  // Implementations list more of these than programs use. Statements show which are used.
  // gl_DepthRange is fixed function's name for state that all draws have; statements show its use.
  const auto isDepthRange = [&](const std::string& name) {
    return !f.code.empty() && name.starts_with("gl_DepthRange");
  };
  if (!f.hasBuiltInVertices())
    for (const auto& [name, type] : p.builtInUniforms)
      if (!isDepthRange(name)) check("has uniform ", name, type);
  for (const auto& [name, attribute] : p.attributes)
    if (!isNumber(f, name)) check("has attribute ", name, attribute.type);
}

/// Requires what tracing needs from any program.
void needSources(const Program& p, const Family& f, std::vector<std::string>& out) {
  if (!f.rasteriseBecause.empty()) return;
  if (p.geometryShader && !f.geometryShader) out.push_back("has a geometry shader");
  if (!p.geometryShader && f.geometryShader) out.push_back("lacks a geometry shader");
  if (p.tessellation) out.push_back("has tessellation shaders");
  if (p.writes) out.push_back("writes into buffers or images");
  if (!hasVertexInput(p, f, f.position))
    out.push_back(about(f.pulling.given() ? "lacks uniform " : "lacks attribute ", f.position));
  if (f.pulling.given() && !p.uniform(f.pulling.pointIds))
    out.push_back(about("lacks uniform ", f.pulling.pointIds));
  for (const std::string& name : f.clipFromObject)
    if (!name.starts_with('$') && !p.uniform(name)) out.push_back(about("lacks uniform ", name));
  if (!f.impostors.projection.empty() && !p.uniform(f.impostors.projection))
    out.push_back(about("lacks uniform ", f.impostors.projection));
  for (const std::string* name : {&f.impostors.axis, &f.impostors.corners, &f.impostors.end})
    if (!name->empty() && !p.attribute(*name)) out.push_back(about("lacks attribute ", *name));
  const bool normals = f.volume.given() || f.impostors.given() || hasVertexInput(p, f, f.normal) ||
                       p.uniform(f.triangleNormals);
  if (!normals && f.model != Family::Model::unlit && f.withoutNormals == Family::NoNormals::refuse)
    out.push_back(about("lacks attribute ", f.normal));
}

/// `unknown` is set if the program fits except for its statements.
std::vector<std::string> obstacles(const RealGl& real, const Program& program, const Family& family,
                                   const CodeSections& code, ProgramSource& source, bool& unknown) {
  std::vector<std::string> out;
  unknown = false;
  if (!program.linked) return {"is not linked"};
  needActive(program, family, out);
  refuseActive(real, program, family, out);
  needSources(program, family, out);
  needTypes(program, family, out);
  needMentioned(program, family, out);
  if (out.empty()) needSource(source, family, out);
  if (!out.empty()) return out;
  needCode(program, source, family, code, out);
  unknown = !out.empty();
  return out;
}

int occurrences(const std::string& part, const std::string& text) {
  int count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

/// The number that follows the first occurrence of `before`; 0 if there is none.
float numberAfter(const std::string& before, const std::string& text) {
  const size_t at = text.find(before);
  return at == std::string::npos ? 0 : std::strtof(text.c_str() + at + before.size(), nullptr);
}

}  // namespace

std::vector<std::string> obstacles(const RealGl& real, Program program, const Family& family,
                                   const CodeSections& code) {
  program.renamed = renamedBy(program, family);
  nameBuiltIns(program, family);
  ProgramSource source(real, program);
  bool unknown = false;
  return obstacles(real, program, family, code, source, unknown);
}

namespace {

/// Records the family that the program fits, and its notes and light counts.
void setFamily(KnownProgram& known, const std::shared_ptr<const Family>& family, const FamilyList& families,
               ProgramSource& source) {
  known.family = family;
  known.why = family->rasteriseBecause;
  known.unknownCode = false;
  const FamilyLights& lights = family->lights;
  if (!lights.countInSource.empty()) known.lightCount = occurrences(lights.countInSource, source.text());
  if (!lights.noHighlightInSource.empty())
    known.highlightCount = known.lightCount - occurrences(lights.noHighlightInSource, source.text());
  if (const std::string& before = family->pbr.prefilteredMaxLevelInSource; !before.empty())
    known.prefilteredMaxLevel = numberAfter(before, source.text());
  const auto has = [&](const std::string& text) {
    return !text.empty() && occurrences(text, source.text()) > 0;
  };
  known.ignoresOpacity = has(family->material.unusedOpacityInSource);
  known.discardsInvisible = has(family->discardsInvisibleInSource);
  if (family->code.empty()) return;
  GlslStatements statements = statementsFor(*family, known.program, source);
  takeFunctions(statements, families.code, family->code, known.functionNames);
  if (!known.functionNames.empty()) known.functions = functionsOf(source);
  known.note = notesOn(statements, families.code, family->code);
  readPlaceholders(statements, families.code, family->code, known.placeholders);
  readWords(statements, families.code, family->code, known.words);
}

/// What users should know of the program in use with this OpenGL; empty if nothing.
std::string noteOnOpenGl(const RealGl& real, const Program& program, ProgramSource& source) {
  if (program.geometryShader || !program.linked ||
      !misnumbersPrimitives(real.GetString(GL_RENDERER), real.GetString(GL_VERSION)) ||
      source.text().find("gl_PrimitiveID") == std::string::npos)
    return "";
  return "this version of Mesa numbers triangles wrongly where a shader program reads gl_PrimitiveID and has "
         "no geometry shader: the real OpenGL's picture may be wrong, and the traced one differs from it";
}

/// Finds the family of `known`, whose source is `source`.
void findFamily(const RealGl& real, KnownProgram& known, const FamilyList& families, ProgramSource& source) {
  NearestFamily nearest;
  for (const auto& family : families) {
    if (!family->rasteriseBecause.empty() && !family->decided.empty()) continue;  // findOthers()
    bool unknown = false;
    known.program.renamed = renamedBy(known.program, *family);
    nameBuiltIns(known.program, *family);
    std::vector<std::string> found = obstacles(real, known.program, *family, families.code, source, unknown);
    if (found.empty()) return setFamily(known, family, families, source);
    nearest.take(known.program, *family, unknown, std::move(found));
  }
  known.program.renamed.clear();
  dropBuiltIns(known.program);
  known.unknownCode = nearest.fitsButForCode();
  known.why = known.program.linked ? "no family fits" + nearest.text() : "not linked";
}

void addNote(KnownProgram& known, const std::string& note) {
  if (!note.empty()) known.note.append(known.note.empty() ? "" : "; ").append(note);
}

/// Whether no draw can have the values of both families: a uniform of the program must differ.
bool excludeEachOther(const Program& program, const Family& a, const Family& b) {
  return std::ranges::any_of(a.decided, [&](const auto& value) {
    const auto other = b.decided.find(value.first);
    return other != b.decided.end() && other->second != value.second && program.uniform(value.first);
  });
}

/// Finds KnownProgram::others. The first family that fits wins for each set of values.
void findOthers(const RealGl& real, KnownProgram& known, const FamilyList& families, ProgramSource& source,
                const std::string& note) {
  if (!known.family || known.family->decided.empty()) return;
  for (const auto& family : families) {
    const auto excludes = [&](const KnownProgram& found) {
      return excludeEachOther(found.program, *found.family, *family);
    };
    if (family->decided.empty() || !excludes(known) ||
        !std::ranges::all_of(known.others, [&](const auto& found) { return excludes(*found); }))
      continue;
    auto other = std::make_shared<KnownProgram>();
    other->program = known.program;
    dropBuiltIns(other->program);
    other->program.renamed = renamedBy(other->program, *family);
    nameBuiltIns(other->program, *family);
    bool unknown = false;
    if (!obstacles(real, other->program, *family, families.code, source, unknown).empty()) continue;
    setFamily(*other, family, families, source);
    addNote(*other, note);
    known.others.push_back(std::move(other));
  }
}

}  // namespace

std::shared_ptr<const KnownProgram> recognise(const RealGl& real, GLuint name, const FamilyList& families,
                                              std::shared_ptr<const ShaderTexts> texts) {
  auto known = std::make_shared<KnownProgram>();
  known->program = reflect(real, name);
  known->program.texts = std::move(texts);
  ProgramSource source(real, known->program);
  findFamily(real, *known, families, source);
  const std::string note = noteOnOpenGl(real, known->program, source);
  addNote(*known, note);
  findOthers(real, *known, families, source, note);
  return known;
}

}  // namespace gluray::gl
