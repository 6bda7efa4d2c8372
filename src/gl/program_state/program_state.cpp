#include "gl/program_state/program_state.h"

#include "gl/basics/affine.h"
#include "gl/glsl/built_in_variables.h"
#include "gl/program_state/program_lights.h"
#include "gl/program_state/program_reader.h"
#include "gl/programs/vertex_inputs.h"
#include "gl/real/clip_depths.h"
#include "gl/real/state_queries.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace gluray::gl {

Reason ProgramReader::read() {
  if (const Reason reason = checkNeutral(); reason != Reason::traced) return reason;
  if (const Reason reason = checkBuiltInState(); reason != Reason::traced) return reason;
  if (const Reason reason = readPulled(); reason != Reason::traced) return reason;
  if (const Reason reason = readTransform(); reason != Reason::traced) return reason;
  readMaterial(family_.material, out_.material.front);
  readBackMaterial();
  readModel();
  out_.shading.fragment.lights =
      readLights(family_.lights, uniforms_, glm::vec3(viewer_), out_.material.front.shininess, *out_.known);
  turnLights();
  readFog();
  if (const Reason reason = readImpostors(); reason != Reason::traced) return reason;
  readClipPlanes();
  if (const Reason reason = readWindow(); reason != Reason::traced) return reason;
  readDepthOffset();
  if (const Reason reason = readNormals(); reason != Reason::traced) return reason;
  if (const Reason reason = readEdges(); reason != Reason::traced) return reason;
  if (const Reason reason = readTexcoordMatrix(); reason != Reason::traced) return reason;
  if (const Reason reason = readColor(); reason != Reason::traced) return reason;
  if (const Reason reason = readBackVisibility(); reason != Reason::traced) return reason;
  if (const Reason reason = readEnabled(); reason != Reason::traced) return reason;
  if (const Reason reason = readTextures(); reason != Reason::traced) return reason;
  if (const Reason reason = readMatcap(); reason != Reason::traced) return reason;
  return readPbr();
}

Reason ProgramReader::checkNeutral() {
  for (const auto& [name, value] : family_.decided) {
    const std::string now = uniforms_.unlike(name, {value});
    if (!now.empty())
      return refuse("uniform \"" + name + "\" is " + now + ", but the family covers only " +
                    inWords({value}));
  }
  for (const auto& [name, value] : family_.neutral) {
    const std::string now = uniforms_.unlike(name, value);
    if (!now.empty())
      return refuse("uniform \"" + name + "\" is " + now + ", but the family covers only " +
                    (value.empty() ? "the identity" : inWords(value)));
  }
  return Reason::traced;
}

std::string builtInColorObstacle(const RealGl& real, const Family& family) {
  if (integer(real, GL_SHADE_MODEL) != GL_SMOOTH) return "glShadeModel is GL_FLAT";
  if (isOn(real, GL_VERTEX_PROGRAM_TWO_SIDE)) return "GL_VERTEX_PROGRAM_TWO_SIDE is on";
  GLint clamps = GL_TRUE;  // before OpenGL 3.0 vertex colours are always clamped
  if (family.clampedColors) real.GetIntegerv(GL_CLAMP_VERTEX_COLOR, &clamps);
  return clamps == GL_TRUE ? "" : "GL_CLAMP_VERTEX_COLOR is not GL_TRUE";
}

Reason ProgramReader::checkBuiltInState() {
  if (!family_.hasBuiltInVertices()) return Reason::traced;
  if (std::string why = builtInColorObstacle(real_, family_); !why.empty()) return refuse(std::move(why));
  const auto isOfMaterial = [](const std::string& name) {
    using Of = BuiltInUniform::Of;
    const Of of = builtInUniform(name).of;
    return of == Of::material || of == Of::product || of == Of::sceneColor;
  };
  if (isOn(real_, GL_COLOR_MATERIAL) && std::ranges::any_of(family_.mentioned, isOfMaterial))
    return refuse("GL_COLOR_MATERIAL is on");
  return Reason::traced;
}

Reason ProgramReader::readImpostors() {
  const FamilyImpostors& f = family_.impostors;
  out_.impostors = {};
  const std::string& ofPulled = family_.pulling.size;
  out_.pixelSize = f.given()          ? uniforms_.number(f.size, 0)
                   : ofPulled.empty() ? 0
                                      : uniforms_.number(ofPulled);
  out_.lineSize = uniforms_.number(family_.lineSize, 0);
  if (!f.given()) return Reason::traced;
  out_.impostors.billboards = f.billboards;
  out_.impostors.fades = f.fades;
  out_.impostors.gaussian = f.gaussian, out_.impostors.antialiased = f.antialiased;
  out_.impostors.outline = uniforms_.number(f.outline, 0);
  out_.impostors.parallelView = out_.shading.fragment.parallelView;
  out_.impostors.inside = uniforms_.number(f.inside, 1) < 0;
  out_.impostors.radiusDivisor = uniforms_.number(f.radiusDivisor, 1);
  out_.impostors.axisMatrix = out_.normalMatrix;
  const bool attribute = !f.radius.uniform.empty() && program_.attribute(f.radius.uniform);
  out_.impostors.grows = f.grows;
  out_.impostors.size = glm::vec2(uniforms_.value(f.size, glm::vec4(0)));
  out_.impostors.inPixels = f.inPixels;
  out_.impostors.longer = uniforms_.number(f.longer, 0);
  if (!f.viewport.empty()) out_.usedViewport = uniforms_.vector(f.viewport);
  out_.impostors.bulge = uniforms_.number(f.bulge, 0);
  // Flat ones have no uniform that tells; their depth follows from the matrices.
  if (scene::isSizedInPixels(f.shape) && f.bulge.uniform.empty() && out_.impostors.bulge == 0)
    out_.impostors.parallelView = glm::dvec3(glm::row(out_.clipFromObject, 3)) == glm::dvec3(0);
  out_.impostors.bulgeDepth = uniforms_.number(f.bulgeDepth, 0);
  constexpr float kUnit = 1.0f / 65000.0f;  // VTK's unit of depth bias
  out_.impostors.depthBias = uniforms_.number(f.depthBias, 0) * kUnit;
  out_.impostorRadius = attribute ? current(f.radius.uniform).x : uniforms_.number(f.radius, 1);
  if (f.sent) return readSentBillboards();
  return f.shape == scene::Shape::splats ? readSplats() : Reason::traced;
}

Reason ProgramReader::readSplats() {
  const FamilyImpostors& f = family_.impostors;
  const glm::mat4 projection = uniforms_.matrix4(f.projection);
  out_.impostors.size = {projection[0].x, projection[1].y};
  const float scale = uniforms_.number(f.scale, 1);
  if (!(scale > 0)) return refuse("uniform \"" + f.scale.uniform + "\" is not above 0");
  out_.impostors.radiusDivisor = 1 / scale;
  const glm::vec3 lowpass(uniforms_.value(f.lowpass, glm::vec4(0)));
  const bool adds = lowpass.x >= 0 && lowpass.z >= 0 && lowpass.y * lowpass.y <= lowpass.x * lowpass.z;
  if (!adds || !std::isfinite(lowpass.x + lowpass.z))
    return refuse("uniform \"" + f.lowpass.uniform + "\" is no covariance");
  out_.impostors.lowpass = lowpass;
  // Smaller billboards would clip the ellipse.
  const float bounds = uniforms_.number(f.billboardScale, 1);
  if (!(bounds >= 1)) return refuse("uniform \"" + f.billboardScale.uniform + "\" is below 1");
  if (!out_.impostors.fillsBillboard()) return out_.eyeFromObject ? Reason::traced : Reason::program;
  if (!std::isfinite(bounds)) return refuse("uniform \"" + f.billboardScale.uniform + "\" is infinite");
  out_.impostors.billboardScale = bounds;
  if (!out_.eyeFromObject) return Reason::program;
  return Reason::traced;
}

void ProgramReader::readClipPlanes() {
  out_.clipPlanes.clear();
  const ProgramUniform* planes = family_.clipPlanes.empty() ? nullptr : program_.uniform(family_.clipPlanes);
  if (!planes) return;
  // Elements beyond the count are not initialised.
  int count = planes->count;
  if (uniforms_.has(family_.clipPlaneCount))
    count = std::min(count, uniforms_.integer(family_.clipPlaneCount));
  for (int i = 0; i < count; ++i) {
    const glm::vec4 plane = uniforms_.vector(family_.clipPlanes, i);
    if (family_.clipCenters)
      out_.impostors.centerPlanes.push_back(plane);
    else
      out_.clipPlanes.emplace_back(plane);
  }
}

void ProgramReader::readDepthOffset() {
  out_.depthOffset = {};
  const auto writes = [&](const FamilyValue& v) { return !v.constant.empty() || uniforms_.has(v.uniform); };
  out_.shading.fragment.writesDepth = writes(family_.depthOffset) || writes(family_.depthFactor);
  if (!family_.depthOffset.given() && !family_.depthFactor.given()) return;
  // VTK's unit is 1/65000.
  out_.depthOffset = {uniforms_.number(family_.depthFactor, 0), uniforms_.number(family_.depthOffset, 0),
                      1.0f / 65000.0f, true};
  if (out_.depthOffset.factor == 0 && out_.depthOffset.units == 0) out_.depthOffset = {};
}

Reason ProgramReader::readNormals() {
  scene::FragmentShading& f = out_.shading.fragment;
  using Normals = scene::FragmentShading::Normals;
  f.normals = Normals::vertices;
  out_.triangleNormals = {};
  if (const ProgramUniform* sampler = samplerNamed(family_.triangleNormals)) {
    f.normals = Normals::perTriangle;
    const Reason reason = readBuffer(*sampler, out_.triangleNormals, out_.triangleNormalCount);
    if (reason != Reason::traced) return reason;
    return shiftTriangles(family_.triangleOffset, out_.triangleNormals, out_.triangleNormalCount);
  }
  if (!hasVertexInput(program_, family_, family_.normal))
    f.normals = Normals::triangles;
  else
    out_.normal = glm::vec3(current(family_.normal));
  return Reason::traced;
}

Reason ProgramReader::readEdges() {
  scene::FragmentShading& f = out_.shading.fragment;
  f.edges =
      !family_.edgeFlags.empty() && (family_.edgesIf.empty() || uniforms_.integer(family_.edgesIf) != 0);
  out_.triangleEdges = {};
  f.edgesAlone = f.edges && family_.edgesAlone;
  out_.shading.alphaTest = {};
  if (f.edgesAlone) out_.shading.alphaTest.function = scene::AlphaTest::greater;  // than 0
  if (!f.edges) return Reason::traced;
  if (!family_.edgesUnless.empty() && uniforms_.integer(family_.edgesUnless) != 0)
    return refuse("uniform \"" + family_.edgesUnless + "\" is not 0, but the triangles have edges");
  GLint viewport[4] = {};
  real_.GetIntegerv(GL_VIEWPORT, viewport);
  if (uniforms_.has(family_.edgeViewport) &&
      uniforms_.vector(family_.edgeViewport) != glm::vec4(viewport[0], viewport[1], viewport[2], viewport[3]))
    return refuse("uniform \"" + family_.edgeViewport + "\" is not the viewport");
  f.edgeWidth = uniforms_.number(family_.edgeWidth, 1);
  f.edgesGrow = family_.edgesGrow;
  f.edgeOpacity = uniforms_.number(family_.edgeOpacity, 1);
  f.edgeColor = glm::vec3(uniforms_.value(family_.edgeColor, glm::vec4(0)));
  if (out_.pulled && out_.pulled->indexed) return refuse("its edges need vertices in order");
  const ProgramUniform* sampler = samplerNamed(family_.edgeFlags);
  const bool all = !family_.edgeFlagsIf.empty() && uniforms_.integer(family_.edgeFlagsIf) == 0;
  if (!sampler || all) return Reason::traced;
  const Reason reason = readBuffer(*sampler, out_.triangleEdges, out_.triangleEdgeCount);
  if (reason != Reason::traced || !out_.pulled) return reason;
  // Hidden edges have no weight at any width there.
  if (f.edgeWidth < 1) return refuse("edges are thinner than a pixel");
  return shiftTriangles(family_.edgeFlagsOffset, out_.triangleEdges, out_.triangleEdgeCount);
}

Reason ProgramReader::readBuffer(const ProgramUniform& sampler, scene::Attribute& attribute,
                                 uint32_t& count) {
  return textures_.buffer(real_, group_, unitOf(sampler), attribute, count);
}

glm::vec4 ProgramReader::current(const std::string& name) const {
  glm::vec4 value(0, 0, 0, 1);
  const ProgramAttribute* a = name.empty() ? nullptr : program_.attribute(name);
  if (a && a->location >= 0)
    real_.GetVertexAttribfv(static_cast<GLuint>(a->location), GL_CURRENT_VERTEX_ATTRIB,
                            glm::value_ptr(value));
  return value;
}

namespace {

/// Lets the program have that of its families whose values (Family::decided) its uniforms have; the first
/// one if none has.
void chooseFamily(ProgramState& s) {
  const auto fits = [&](const KnownProgram& known) {
    const UniformReader uniforms(known.program, *s.uniforms, known.placeholders);
    return std::ranges::all_of(known.family->decided, [&](const auto& value) {
      return uniforms.unlike(value.first, {value.second}).empty();
    });
  };
  if (fits(*s.known)) return;
  const auto& others = s.known->others;
  const auto found = std::ranges::find_if(others, [&](const auto& other) { return fits(*other); });
  if (found != others.end()) s.known = std::shared_ptr<const KnownProgram>(*found);
}

bool isSane(const ProgramState& s) {
  return isInvertible(s.clipFromObject) && (!s.eyeFromObject || isInvertible(*s.eyeFromObject));
}

}  // namespace

void readProgram(const RealGl& real, ShareGroup& group, const RareState& has, TextureCache& textures,
                 ProgramState& state, bool solids) {
  state.why.clear();
  state.pulled.reset();
  if (const Reason reason = reasonWithoutFamily(*state.known); reason != Reason::traced) {
    state.reason = reason;
    return;
  }
  const bool several = !state.known->others.empty();
  if (several) {
    state.uniforms = readUniforms(real, state.known->program);
    chooseFamily(state);
  }
  if (state.known->family->onlySolids && !solids) {
    state.reason = state.known->family->drawsLines() ? Reason::lines : Reason::program;
    return;
  }
  if (!state.known->family->rasteriseBecause.empty()) {
    state.reason = Reason::programPass;
    if (state.known->family->pass != Family::Pass::none && !several)
      state.uniforms = readUniforms(real, state.known->program);
    return;
  }
  if (!several) state.uniforms = readUniforms(real, state.known->program);
  if (state.known->family->volume.given()) {
    state.reason = Reason::volume;
    return;
  }
  state.reason = ProgramReader(real, group, has, textures, state).read();
  if (state.reason == Reason::traced && !isSane(state)) state.reason = Reason::singularMatrix;
}

}  // namespace gluray::gl
