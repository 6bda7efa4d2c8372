#include "saved/export/gather/shown_textures.h"

#include "render/local/texgen.h"

#include <cmath>
#include <utility>

namespace gluray::saved {
namespace {

using scene::BaseFormat;
using scene::TexEnv;
using scene::Texture;
using scene::TextureTarget;
using scene::Wrap;
using Texels = ExportedTexture::Texels;

Wrap exportedWrap(Wrap wrap, Notes& notes) {
  if (wrap == Wrap::repeat || wrap == Wrap::clampToEdge || wrap == Wrap::mirroredRepeat) return wrap;
  notes.insert("textures that end in a border colour, or are mirrored once, end in the colour of their edge");
  return Wrap::clampToEdge;
}

/// Coordinates (s, t, r, q) of a vertex after generation and the texture matrix.
glm::vec4 coordinatesAt(const render::Surface& s, const Texture& t, const scene::Attribute* given,
                        uint32_t vertex) {
  glm::vec4 at = given ? scene::fetch(*given, vertex) : s.instance->texcoordOf(t.unit);
  if (t.texGen.on()) {
    render::TexGenVertex in;
    in.object = glm::vec4(s.mesh->position(vertex), 1);
    in.eye = glm::vec3(s.eyeFromObject * in.object);
    const scene::Attribute& normals = s.mesh->normals;
    in.normal =
        s.eyeFromObjectNormal * (normals ? glm::vec3(scene::fetch(normals, vertex)) : s.instance->normal);
    const float length = glm::length(in.normal);
    if (s.lighting->shading->normalize && length > 0)
      in.normal /= length;
    else if (s.lighting->shading->rescaleNormal)
      in.normal *= s.rescale;
    at = render::generateCoordinates(t.texGen, in, at);
  }
  return t.textureMatrix * at;
}

bool hasNoQ(const scene::Attribute& a) { return a.format != scene::Format::float4; }

struct KeepFinite {
  void operator()(const glm::vec2* in, glm::vec2* out) const {
    for (int c = 0; c < 2; ++c) (*out)[c] = std::isfinite((*in)[c]) ? (*in)[c] : 0;
  }
};

/// What a part of GL_COMBINE makes of the texture and the result before.
enum class Mix : uint8_t { product, texture, before, other };

Mix mixOf(const scene::Combine::Part& part, scene::Combine::Operand operand) {
  using Combine = scene::Combine;
  const auto is = [&](int i, bool texture) {
    const Combine::Argument& a = part.arguments[static_cast<size_t>(i)];
    const bool fits = texture ? a.source == Combine::texture
                              : a.source == Combine::previous || a.source == Combine::primary;
    return fits && a.operand == operand;
  };
  if (part.scale != 1) return Mix::other;
  if (part.function == Combine::replace)
    return is(0, true) ? Mix::texture : is(0, false) ? Mix::before : Mix::other;
  const bool both = (is(0, true) && is(1, false)) || (is(0, false) && is(1, true));
  return part.function == Combine::modulate && both ? Mix::product : Mix::other;
}

/// `white`: the result before is white.
std::optional<TextureEffect> effectOfCombine(const scene::Combine& combine, bool white) {
  const Mix color = mixOf(combine.rgb, scene::Combine::color),
            alpha = mixOf(combine.alphaPart, scene::Combine::alpha);
  if (color == Mix::other || alpha == Mix::other || (color == Mix::before && alpha != Mix::product))
    return {};
  TextureEffect effect{white || color != Mix::texture, white || alpha != Mix::texture, Texels::all};
  if (color == Mix::before) effect.texels = Texels::white;
  if (alpha == Mix::before) effect.texels = Texels::opaque;
  return effect;
}

}  // namespace

std::optional<ExportedTexture> exportedTexture(const Texture& t, Notes& notes) {
  const bool flat = t.target == TextureTarget::texture1D || t.target == TextureTarget::texture2D ||
                    t.target == TextureTarget::rectangle;
  if (!flat || !t.image || t.image->width < 1 || t.image->height < 1 || t.image->depth != 1) return {};
  if (!t.image->normalised) notes.insert("colours of textures beyond 1 were cut off there");
  ExportedTexture out;
  out.image = t.image;
  out.wrapS = exportedWrap(t.wrapS, notes);
  out.wrapT = t.target == TextureTarget::texture1D ? Wrap::clampToEdge : exportedWrap(t.wrapT, notes);
  out.magFilter = t.magFilter, out.minFilter = t.minFilter, out.mipFilter = t.mipFilter;
  return out;
}

std::optional<SourcePtr> exportedCoordinates(const render::Surface& s, const Texture& t,
                                             const CornersPtr& corners) {
  const scene::MeshPtr& mesh = s.instance->mesh;
  const scene::Attribute* given = mesh->texcoordsOf(t.unit);
  const bool plain =
      !t.texGen.on() && t.textureMatrix == glm::mat4(1) && t.target == TextureTarget::texture2D;
  if (given && plain && hasNoQ(*given)) {
    SourcePtr all = attributeArray(mesh, *given, Element::float2, corners);
    if (mesh->moderate) return all;
    return changedArray<glm::vec2, glm::vec2>(std::move(all), Element::float2, KeepFinite());
  }
  const glm::vec2 size =
      t.target == TextureTarget::rectangle ? glm::vec2(t.image->width, t.image->height) : glm::vec2(1);
  std::vector<glm::vec2> all(mesh->vertexCount);
  float q = 0;
  for (uint32_t v = 0; v < mesh->vertexCount; ++v) {
    const glm::vec4 at = coordinatesAt(s, t, given, v);
    if (v == 0) q = at.w;
    if (at.w != q || q == 0) return {};  // divided at each pixel
    all[v] = glm::vec2(at) / q / size;
    if (t.target == TextureTarget::texture1D) all[v].y = 0.5f;
    KeepFinite()(&all[v], &all[v]);
  }
  return attributeArray(mesh, ownAttribute(std::move(all), scene::Format::float2), Element::float2, corners);
}

std::optional<TextureEffect> effectOf(const scene::Shading& shading, const Texture& t, bool opaque) {
  const BaseFormat format = t.image->baseFormat;
  const bool noAlpha = format == BaseFormat::rgb || format == BaseFormat::luminance;
  const scene::FragmentShading& f = shading.fragment;
  const Texels dropped =
      scene::isProgram(shading) && f.texturesFirst && f.texturesKeepAlpha ? Texels::opaque : Texels::all;
  // Programs multiply by the environment's result for a white fragment.
  const bool white = scene::isProgram(shading);
  switch (t.env) {
    case TexEnv::modulate:
      if (format == BaseFormat::alpha) return TextureEffect{true, true, Texels::white};
      return TextureEffect{true, true, noAlpha ? Texels::opaque : dropped};
    case TexEnv::replace:
      if (format == BaseFormat::alpha) {
        if (!opaque && !white) return {};
        return TextureEffect{true, true, Texels::white};
      }
      return TextureEffect{white, white || noAlpha, noAlpha ? Texels::opaque : dropped};
    case TexEnv::decal:
      if (!noAlpha && !t.image->opaque) return {};
      return TextureEffect{white, true, Texels::opaque};
    case TexEnv::combine: return effectOfCombine(t.combine, white);
    default: return {};
  }
}

Texture asMap(Texture map) {
  map.wrapS = map.wrapT = Wrap::clampToEdge;
  map.minFilter = map.magFilter, map.mipFilter = scene::MipFilter::none;
  map.target = TextureTarget::texture2D;
  map.unit = 0, map.texGen = {}, map.env = TexEnv::modulate;
  // Programs transform s and t only.
  glm::mat4 m(1);
  for (int c : {0, 1, 3})
    for (int r : {0, 1}) m[c][r] = map.textureMatrix[c][r];
  map.textureMatrix = m;
  return map;
}

}  // namespace gluray::saved
