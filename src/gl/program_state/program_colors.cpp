// ProgramReader: the source of a shader program's colours, and whether they are opaque.
#include "gl/program_state/program_reader.h"
#include "gl/programs/vertex_inputs.h"

#include <algorithm>
#include <utility>

namespace gluray::gl {

Reason ProgramReader::readColor() {
  scene::FragmentShading& f = out_.shading.fragment;
  using Color = scene::FragmentShading::Color;
  f.color = Color::material;
  f.colorIsDiffuseOnly = family_.colorIsDiffuseOnly;
  f.map.clear();
  f.colorExponent = 1;
  out_.triangleColors = {};
  out_.opaqueTriangleColors = true;
  out_.instanceColors = false;
  out_.triangleOffset =  // of pulled vertices: shiftTriangles()
      out_.pulled ? 0 : static_cast<uint32_t>(uniforms_.integer(family_.triangleOffset));
  out_.overridden = uniforms_.integer(family_.uniformColors) != 0;
  if (out_.overridden) return readOpacityBeneath();
  if (family_.height.given()) return readHeightColors();
  Reason reason = Reason::traced;
  if (const ProgramUniform* sampler = samplerNamed(family_.triangleColors)) {
    f.color = Color::perTriangle;
    reason = readBuffer(*sampler, out_.triangleColors, out_.triangleColorCount);
    if (reason == Reason::traced)
      reason = shiftTriangles(family_.triangleOffset, out_.triangleColors, out_.triangleColorCount);
    if (reason == Reason::traced)
      out_.opaqueTriangleColors = textures_.isOpaque(out_.triangleColors, out_.triangleColorCount);
  } else if (const ProgramUniform* map = samplerNamed(family_.colorMap)) {
    f.color = Color::map;
    reason = readMap(*map);
  } else if (hasVertexInput(program_, family_, family_.color)) {
    f.color = Color::vertices;
    out_.color = current(family_.color);
  } else if (!family_.instanceColor.empty() && program_.attribute(family_.instanceColor)) {
    f.color = Color::vertices;
    out_.instanceColors = true;
  } else {
    return Reason::traced;
  }
  // The colours from this source replace the material's colours. The material's intensities stay.
  const FamilyMaterial& m = family_.material;
  scene::Material& material = out_.material.front;
  material.diffuse =
      glm::vec4(glm::vec3(uniforms_.value(m.diffuseIntensity, glm::vec4(1))), material.diffuse.a);
  if (!family_.colorIsDiffuseOnly)
    material.ambient = uniforms_.value(m.ambientIntensity, glm::vec4(m.ambientColor.given() ? 1.0f : 0.0f));
  if (reason == Reason::traced && f.backMaterial) reason = readBackColors();
  if (!f.backMaterial) out_.material.back = material;
  return reason == Reason::traced ? readColorExponent() : reason;
}

Reason ProgramReader::readColorExponent() {
  const float exponent = uniforms_.number(family_.colorExponent, 1);
  if (exponent == 1) return Reason::traced;
  if (!(exponent > 0)) return refuse("the exponent of its colours is not above 0");
  out_.shading.fragment.colorExponent = exponent;
  const glm::vec3 power(exponent);
  for (scene::Material* m : {&out_.material.front, &out_.material.back})
    for (glm::vec4* color : {&m->ambient, &m->diffuse})
      *color = glm::vec4(glm::pow(glm::max(glm::vec3(*color), 0.0f), power), color->a);
  return Reason::traced;
}

Reason ProgramReader::readBackColors() {
  const FamilyMaterial& m = family_.backMaterial;
  if (isActive(m.diffuseIntensity, m.diffuseColor) || isActive(m.ambientIntensity, m.ambientColor))
    return refuse("back faces have their own colours, and front faces take their colours from elsewhere");
  const scene::Material& front = out_.material.front;
  scene::Material& back = out_.material.back;
  back.ambient = front.ambient;
  back.diffuse = glm::vec4(glm::vec3(front.diffuse), back.diffuse.a);
  return Reason::traced;
}

Reason ProgramReader::readHeightColors() {
  scene::HeightColors& height = out_.shading.fragment.height;
  out_.shading.fragment.color = scene::FragmentShading::Color::height;
  height.axis = family_.height.axis;
  for (int c = 0; c < 3; ++c) {
    height.scale[c] = uniforms_.number(family_.height.scale[c], 1);
    height.offset[c] = uniforms_.number(family_.height.offset[c], 0);
    height.exponent[c] = uniforms_.number(family_.height.exponent[c], 1);
    if (!(height.exponent[c] > 0)) return refuse("an exponent of colours is not above 0");
  }
  return Reason::traced;
}

Reason ProgramReader::readOpacityBeneath() {
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

/// The program divides by w at each vertex and then interpolates. This equals our matrix only if w is
/// constant.
Reason ProgramReader::readTexcoordMatrix() {
  texcoordMatrix_ = uniforms_.matrix4(family_.texcoordMatrix);
  const glm::mat4& m = texcoordMatrix_;
  // Coordinates are (s, t, 0, 1).
  const bool divides = !family_.hasBuiltInVertices();  // built-in vertices are not divided
  if (m[0].w != 0 || m[1].w != 0 || !(m[3].w != 0) || (!divides && (m[2].w != 0 || m[3].w != 1)))
    return refuse("matrix \"" + family_.texcoordMatrix + "\" divides texture coordinates");
  if (m[3].w != 1) texcoordMatrix_ /= m[3].w;
  return Reason::traced;
}

Reason ProgramReader::readMap(const ProgramUniform& sampler) {
  scene::Texture texture;
  if (const Reason reason = textures_.bound(real_, has_, unitOf(sampler), sampler.type, texture);
      reason != Reason::traced)
    return reason;
  const bool simple =
      (texture.target == scene::TextureTarget::texture2D ||
       texture.target == scene::TextureTarget::texture1D) &&
      texture.wrapS == scene::Wrap::clampToEdge &&
      (texture.target == scene::TextureTarget::texture1D || texture.wrapT == scene::Wrap::clampToEdge) &&
      texture.mipFilter == scene::MipFilter::none && texture.magFilter == texture.minFilter;
  if (!simple) return Reason::textureFormat;
  out_.texcoord = current(mapTexcoord(program_, family_));
  texture.textureMatrix = texcoordMatrix_;
  if (family_.mapLow.given() || family_.mapHigh.given()) {
    const float low = uniforms_.number(family_.mapLow, 0), high = uniforms_.number(family_.mapHigh, 1);
    if (!(high > low)) return refuse("the range of its colour map is empty");
    texture.textureMatrix[0].x /= high - low, texture.textureMatrix[3].x -= low / (high - low);
  }
  out_.shading.fragment.map.push_back(std::move(texture));
  return Reason::traced;
}

Reason ProgramReader::readMatcap() {
  std::vector<scene::Texture>& images = out_.shading.fragment.matcap;
  images.clear();
  for (const std::string& name : family_.matcap) {
    const ProgramUniform* sampler = samplerNamed(name);
    if (!sampler) return refuse("sampler \"" + name + "\" is not active");
    scene::Texture& image = images.emplace_back();
    if (const Reason reason = textures_.bound(real_, has_, unitOf(*sampler), sampler->type, image);
        reason != Reason::traced)
      return reason;
    if (image.magFilter != image.minFilter || image.mipFilter != scene::MipFilter::none)
      return refuse("an image of its colours by normals is magnified in another way than reduced");
    if (image.maxAnisotropy > 1) return Reason::textureAnisotropy;
  }
  return Reason::traced;
}

Reason ProgramReader::readTextures() {
  out_.shading.textures.clear();
  scene::FragmentShading& f = out_.shading.fragment;
  f.texturesFirst = family_.texturesFirst, f.texturesKeepAlpha = family_.texturesDiffuseOnly;
  if (uniforms_.has(family_.texturesIf) && uniforms_.integer(family_.texturesIf) == 0) return Reason::traced;
  f.texturesOnBack = !uniforms_.has(family_.texturesOnBack) || uniforms_.integer(family_.texturesOnBack) != 0;
  for (const std::string& name : family_.textures) {
    const ProgramUniform* sampler = samplerNamed(name);
    if (!sampler) continue;
    scene::Texture texture;
    if (const Reason reason = readTexture(*sampler, texture); reason != Reason::traced) return reason;
    out_.shading.textures.push_back(std::move(texture));
    if (family_.texturesReplaceAlpha) f.ignoresAlpha = true;
  }
  if (!family_.texturesDiffuseOnly || out_.shading.textures.empty()) return Reason::traced;
  const auto isDark = [](const scene::Material& m) { return glm::vec3(m.ambient) == glm::vec3(0); };
  if (f.color == scene::FragmentShading::Color::material)
    f.colorIsDiffuseOnly = true;  // all that the textures change is diffuse
  else if (!f.colorIsDiffuseOnly && !(isDark(out_.material.front) && isDark(out_.material.back)))
    return refuse("it has textures of its diffuse colours alone, and ambient ones from elsewhere");
  return Reason::traced;
}

Reason ProgramReader::readTexture(const ProgramUniform& sampler, scene::Texture& texture) {
  const Reason reason = textures_.bound(real_, has_, unitOf(sampler), sampler.type, texture);
  if (reason != Reason::traced) return reason;
  const bool second = hasTwoTexcoords(program_, family_);
  texture.env = scene::TexEnv::modulate;
  texture.unit = second ? 1 : 0;  // the unit that has the family's texture coordinate
  texture.textureMatrix = texcoordMatrix_;
  (second ? out_.texcoordAbove : out_.texcoord) = current(family_.texcoord);
  return Reason::traced;
}

bool showsOpacityBeneath(const ProgramState& program, const scene::Mesh& mesh, const glm::vec4& color) {
  return program.overridden && !(mesh.colors ? mesh.opaqueColors : color.a >= 1);
}

bool hasNegativeColors(const scene::Mesh& mesh, const glm::vec4& color) {
  const auto negative = [](const glm::vec4& c) { return !(std::min({c.r, c.g, c.b}) >= 0); };
  if (!mesh.colors) return negative(color);
  if (mesh.colors.format == scene::Format::unorm8x4) return false;
  for (uint32_t i = 0; i < mesh.vertexCount; ++i)
    if (negative(scene::fetch(mesh.colors, i))) return true;
  return false;
}

bool drawsOpaque(const ProgramState& program, const scene::Mesh& mesh, const glm::vec4& color) {
  using Color = scene::FragmentShading::Color;
  const scene::FragmentShading& f = program.shading.fragment;
  if (program.material.front.diffuse.a < 1 || program.impostors.fillsBillboard()) return false;
  if (f.edges && f.edgesAlone) return false;
  if (f.backMaterial && program.material.back.diffuse.a < 1) return false;
  if (showsOpacityBeneath(program, mesh, color)) return false;
  if (f.color == Color::vertices && !f.ignoresAlpha && !program.instanceColors &&
      !(mesh.colors ? mesh.opaqueColors : color.a >= 1))
    return false;
  if (f.color == Color::map && !f.map.front().image->opaque) return false;
  if (f.color == Color::perTriangle && !program.opaqueTriangleColors) return false;
  if (f.texturesKeepAlpha) return true;
  return std::all_of(program.shading.textures.begin(), program.shading.textures.end(),
                     [](const scene::Texture& t) { return t.image->opaque; });
}

}  // namespace gluray::gl
