#include "gl/programs/program_state.h"

#include "gl/programs/program_lights.h"
#include "gl/share_group.h"
#include "gl/state_queries.h"
#include "gl/texture.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace gluray::gl {
namespace {

/// Reads one program with the words of its family.
class ProgramReader {
 public:
  ProgramReader(const RealGl& real, ShareGroup& group, const RareState& has, TextureCache& textures,
                ProgramState& out)
      : real_(real),
        group_(group),
        has_(has),
        textures_(textures),
        out_(out),
        program_(out.known->program),
        family_(*out.known->family),
        uniforms_(program_, *out.uniforms) {}

  Reason read() {
    readTransform();
    readMaterial(family_.material, out_.material.front);
    out_.material.back = out_.material.front;
    out_.shading.fragment.backMaterial = uniforms_.has(family_.backMaterial.diffuseColor.uniform);
    if (out_.shading.fragment.backMaterial) readMaterial(family_.backMaterial, out_.material.back);
    readModel();
    out_.shading.fragment.lights = readLights(family_.lights, uniforms_, glm::vec3(viewer_));
    readFigures();
    readClipPlanes();
    readDepthOffset();
    if (const Reason reason = readNormals(); reason != Reason::traced) return reason;
    if (const Reason reason = readEdges(); reason != Reason::traced) return reason;
    if (const Reason reason = readColor(); reason != Reason::traced) return reason;
    return readTextures();
  }

 private:
  void readTransform() {
    out_.clipFromObject = *uniforms_.product(family_.clipFromObject);
    out_.eyeFromObject = uniforms_.product(family_.eyeFromObject);
    // Lights may be given in another space than the viewer's, such as the world; all is seen from the viewer.
    viewer_ = glm::vec3(uniforms_.vector(family_.viewer));
    if (out_.eyeFromObject)
      out_.eyeFromObject = glm::translate(glm::dmat4(1), -viewer_) * *out_.eyeFromObject;
    if (uniforms_.has(family_.normalMatrix))
      out_.normalMatrix = uniforms_.matrix3(family_.normalMatrix);
    else if (out_.eyeFromObject)
      out_.normalMatrix = glm::mat3(glm::transpose(glm::inverse(glm::dmat3(*out_.eyeFromObject))));
    else
      out_.normalMatrix = glm::mat3(1);
  }

  void readMaterial(const FamilyMaterial& m, scene::Material& material) {
    const auto product = [&](const FamilyValue& intensity, const FamilyValue& color, float otherwise) {
      return uniforms_.value(intensity, glm::vec4(otherwise)) * uniforms_.value(color, glm::vec4(1));
    };
    material.ambient = product(m.ambientIntensity, m.ambientColor, m.ambientColor.given() ? 1.0f : 0.0f);
    material.diffuse = product(m.diffuseIntensity, m.diffuseColor, 1);
    material.specular = product(m.specularIntensity, m.specularColor, m.specularColor.given() ? 1.0f : 0.0f);
    // Uniforms that the real OpenGL found to be without effect are not there.
    const auto isOff = [&](const FamilyValue& intensity, const FamilyValue& color) {
      return !color.uniform.empty() && !uniforms_.has(color.uniform) && !uniforms_.has(intensity.uniform);
    };
    if (isOff(m.specularIntensity, m.specularColor)) material.specular = glm::vec4(0);
    if (isOff(m.ambientIntensity, m.ambientColor)) material.ambient = glm::vec4(0);
    material.emission = glm::vec4(0, 0, 0, 1);
    material.shininess = uniforms_.number(m.shininess, 0);
    material.diffuse.a = uniforms_.number(m.opacity, 1);
  }

  void readModel() {
    scene::FragmentShading& f = out_.shading.fragment;
    using Model = scene::FragmentShading::Model;
    f.model = family_.model == Family::Model::pbr     ? Model::pbr
              : family_.model == Family::Model::phong ? Model::phong
                                                      : Model::unlit;
    f.specular = family_.specular == Family::Specular::half ? scene::FragmentShading::Specular::half
                                                            : scene::FragmentShading::Specular::reflect;
    f.flipBackFaces = family_.flipBackFaces;
    f.parallelView = uniforms_.integer(family_.parallelView) != 0;
    if (!family_.pbr.given()) return;
    f.pbr.metallic = uniforms_.number(family_.pbr.metallic, 0);
    f.pbr.roughness = uniforms_.number(family_.pbr.roughness, 0.5f);
    f.pbr.baseF0 = uniforms_.number(family_.pbr.baseF0, 0.04f);
    f.pbr.edgeTint = glm::vec3(uniforms_.value(family_.pbr.edgeTint, glm::vec4(1)));
    f.pbr.emissive = glm::vec3(uniforms_.value(family_.pbr.emissive, glm::vec4(0)));
  }

  void readFigures() {
    const FamilyFigures& f = family_.figures;
    out_.figures = {};
    if (!f.given()) return;
    out_.figures.cards = f.cards;
    out_.figures.fades = f.fades;
    out_.figures.parallelView = out_.shading.fragment.parallelView;
    out_.figures.inside = uniforms_.number(f.inside, 1) < 0;
    out_.figures.radiusDivisor = uniforms_.number(f.radiusDivisor, 1);
    out_.figures.axisMatrix = out_.normalMatrix;
    const bool attribute = !f.radius.uniform.empty() && program_.attribute(f.radius.uniform);
    out_.figures.grows = f.grows;
    out_.figures.size = glm::vec2(uniforms_.value(f.size, glm::vec4(0)));
    out_.figures.bulge = uniforms_.number(f.bulge, 0);
    out_.figures.bulgeDepth = uniforms_.number(f.bulgeDepth, 0);
    constexpr float kUnit = 1.0f / 65000.0f;  // that VTK counts in
    out_.figures.depthBias = uniforms_.number(f.depthBias, 0) * kUnit;
    out_.figureRadius = attribute ? current(f.radius.uniform).x : uniforms_.number(f.radius, 1);
  }

  void readClipPlanes() {
    out_.clipPlanes.clear();
    const ProgramUniform* planes =
        family_.clipPlanes.empty() ? nullptr : program_.uniform(family_.clipPlanes);
    if (!planes) return;
    // Behind the last one that counts lies memory that nobody set.
    int count = planes->count;
    if (uniforms_.has(family_.clipPlaneCount))
      count = std::min(count, uniforms_.integer(family_.clipPlaneCount));
    for (int i = 0; i < count; ++i) {
      const glm::vec4 plane = uniforms_.vector(family_.clipPlanes, i);
      if (family_.clipCenters)
        out_.figures.centerPlanes.push_back(plane);
      else
        out_.clipPlanes.emplace_back(plane);
    }
  }

  void readDepthOffset() {
    out_.depthOffset = {};
    if (!family_.depthOffset.given() && !family_.depthFactor.given()) return;
    // VTK counts in units of 1/65000.
    out_.depthOffset = {uniforms_.number(family_.depthFactor, 0), uniforms_.number(family_.depthOffset, 0),
                        1.0f / 65000.0f, true};
    if (out_.depthOffset.factor == 0 && out_.depthOffset.units == 0) out_.depthOffset = {};
  }

  Reason readNormals() {
    scene::FragmentShading& f = out_.shading.fragment;
    using Normals = scene::FragmentShading::Normals;
    f.normals = Normals::vertices;
    out_.triangleNormals = {};
    if (const ProgramUniform* sampler = samplerNamed(family_.triangleNormals)) {
      f.normals = Normals::perTriangle;
      return readBuffer(*sampler, out_.triangleNormals, out_.triangleNormalCount);
    }
    if (!program_.attribute(family_.normal))
      f.normals = Normals::triangles;
    else
      out_.normal = glm::vec3(current(family_.normal));
    return Reason::traced;
  }

  Reason readEdges() {
    scene::FragmentShading& f = out_.shading.fragment;
    const ProgramUniform* sampler = samplerNamed(family_.edgeFlags);
    f.edges = sampler != nullptr;
    out_.triangleEdges = {};
    if (!sampler) return Reason::traced;
    GLint viewport[4] = {};
    real_.GetIntegerv(GL_VIEWPORT, viewport);
    if (uniforms_.has(family_.edgeViewport) &&
        uniforms_.vector(family_.edgeViewport) !=
            glm::vec4(viewport[0], viewport[1], viewport[2], viewport[3]))
      return Reason::program;
    f.edgeWidth = uniforms_.number(family_.edgeWidth, 1);
    f.edgeColor = glm::vec3(uniforms_.value(family_.edgeColor, glm::vec4(0)));
    return readBuffer(*sampler, out_.triangleEdges, out_.triangleEdgeCount);
  }

  Reason readColor() {
    scene::FragmentShading& f = out_.shading.fragment;
    using Color = scene::FragmentShading::Color;
    f.color = Color::material;
    f.colorIsDiffuseOnly = family_.colorIsDiffuseOnly;
    f.map.clear();
    out_.triangleColors = {};
    out_.opaqueTriangleColors = true;
    out_.instanceColors = false;
    out_.triangleOffset = static_cast<uint32_t>(uniforms_.integer(family_.triangleOffset));
    out_.overridden = uniforms_.integer(family_.uniformColors) != 0;
    if (out_.overridden) return readOpacityBeneath();
    Reason reason = Reason::traced;
    if (const ProgramUniform* sampler = samplerNamed(family_.triangleColors)) {
      f.color = Color::perTriangle;
      reason = readBuffer(*sampler, out_.triangleColors, out_.triangleColorCount);
      if (reason == Reason::traced)
        out_.opaqueTriangleColors = textures_.isOpaque(out_.triangleColors, out_.triangleColorCount);
    } else if (const ProgramUniform* map = samplerNamed(family_.colorMap)) {
      f.color = Color::map;
      reason = readMap(*map);
    } else if (!family_.color.empty() && program_.attribute(family_.color)) {
      f.color = Color::vertices;
      out_.color = current(family_.color);
    } else if (!family_.instanceColor.empty() && program_.attribute(family_.instanceColor)) {
      f.color = Color::vertices;
      out_.instanceColors = true;
    } else {
      return Reason::traced;
    }
    // The material's own colours give way; its intensities stay.
    const FamilyMaterial& m = family_.material;
    scene::Material& material = out_.material.front;
    material.diffuse =
        glm::vec4(glm::vec3(uniforms_.value(m.diffuseIntensity, glm::vec4(1))), material.diffuse.a);
    if (!family_.colorIsDiffuseOnly)
      material.ambient = uniforms_.value(m.ambientIntensity, glm::vec4(m.ambientColor.given() ? 1.0f : 0.0f));
    if (f.backMaterial)
      f.backMaterial = false, reason = Reason::program;  // their colours are mixed otherwise
    out_.material.back = out_.material.front;
    return reason;
  }

  /// Colours that the material's own stand in for have their opacity still. That of vertices is the mesh's.
  Reason readOpacityBeneath() {
    out_.color = glm::vec4(1);
    if (const ProgramUniform* sampler = samplerNamed(family_.triangleColors)) {
      scene::Attribute colors;
      uint32_t count = 0;
      const Reason reason = readBuffer(*sampler, colors, count);
      if (reason != Reason::traced) return reason;
      return textures_.isOpaque(colors, count) ? Reason::traced : Reason::program;
    }
    if (const ProgramUniform* map = samplerNamed(family_.colorMap)) {
      scene::Texture texture;
      const Reason reason = textures_.bound(real_, has_, unitOf(*map), map->type, texture);
      if (reason != Reason::traced) return reason;
      return texture.image->opaque ? Reason::traced : Reason::program;
    }
    if (!family_.instanceColor.empty() && program_.attribute(family_.instanceColor)) return Reason::program;
    if (!family_.color.empty() && program_.attribute(family_.color)) out_.color = current(family_.color);
    return Reason::traced;
  }

  const ProgramUniform* samplerNamed(const std::string& name) const {
    return name.empty() ? nullptr : program_.uniform(name);
  }
  GLint unitOf(const ProgramUniform& sampler) const { return (*out_.uniforms)[sampler.first].integers[0]; }

  Reason readMap(const ProgramUniform& sampler) {
    scene::Texture texture;
    if (const Reason reason = textures_.bound(real_, has_, unitOf(sampler), sampler.type, texture);
        reason != Reason::traced)
      return reason;
    const bool simple = (texture.target == scene::TextureTarget::texture2D ||
                         texture.target == scene::TextureTarget::texture1D) &&
                        texture.wrapS == scene::Wrap::clampToEdge &&
                        texture.wrapT == scene::Wrap::clampToEdge &&
                        texture.mipFilter == scene::MipFilter::none && texture.magFilter == texture.minFilter;
    if (!simple) return Reason::textureFormat;
    out_.texcoord = current(family_.texcoord);
    out_.shading.fragment.map.push_back(std::move(texture));
    return Reason::traced;
  }

  Reason readBuffer(const ProgramUniform& sampler, scene::Attribute& attribute, uint32_t& count) {
    return textures_.buffer(real_, group_, unitOf(sampler), attribute, count);
  }

  Reason readTextures() {
    out_.shading.textures.clear();
    if (uniforms_.has(family_.texturesOnBack) && uniforms_.integer(family_.texturesOnBack) == 0)
      return Reason::program;
    for (const std::string& name : family_.textures) {
      const ProgramUniform* sampler = samplerNamed(name);
      if (!sampler) continue;
      scene::Texture texture;
      const Reason reason = textures_.bound(real_, has_, unitOf(*sampler), sampler->type, texture);
      if (reason != Reason::traced) return reason;
      texture.env = scene::TexEnv::modulate;
      texture.unit = 0;  // all look at the family's one coordinate
      out_.texcoord = current(family_.texcoord);
      out_.shading.textures.push_back(std::move(texture));
    }
    return Reason::traced;
  }

  /// What an attribute is where it is not an array.
  glm::vec4 current(const std::string& name) const {
    glm::vec4 value(0, 0, 0, 1);
    const ProgramAttribute* a = name.empty() ? nullptr : program_.attribute(name);
    if (a && a->location >= 0)
      real_.GetVertexAttribfv(static_cast<GLuint>(a->location), GL_CURRENT_VERTEX_ATTRIB,
                              glm::value_ptr(value));
    return value;
  }

  const RealGl& real_;
  ShareGroup& group_;
  const RareState& has_;
  TextureCache& textures_;
  ProgramState& out_;
  const Program& program_;
  const Family& family_;
  const UniformReader uniforms_;
  glm::dvec3 viewer_{0};
};

bool isSane(const ProgramState& s) {
  const auto finite = [](const glm::dmat4& m) {
    const double d = glm::determinant(m);
    return std::isfinite(d) && d != 0;
  };
  return finite(s.clipFromObject) && (!s.eyeFromObject || finite(*s.eyeFromObject));
}

}  // namespace

void readProgram(const RealGl& real, ShareGroup& group, const RareState& has, TextureCache& textures,
                 ProgramState& state) {
  if (!state.known->family) {
    state.reason = Reason::program;
    return;
  }
  if (!state.known->family->rasteriseBecause.empty()) {
    state.reason = Reason::programPass;
    if (state.known->family->pass != Family::Pass::none)
      state.uniforms = readUniforms(real, state.known->program);
    return;
  }
  state.uniforms = readUniforms(real, state.known->program);
  state.reason = ProgramReader(real, group, has, textures, state).read();
  if (state.reason == Reason::traced && !isSane(state)) state.reason = Reason::singularMatrix;
}

}  // namespace gluray::gl
