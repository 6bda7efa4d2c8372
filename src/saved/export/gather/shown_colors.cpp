#include "saved/export/gather/shown_colors.h"

#include "parallel/loops.h"
#include "render/local/textured_triangle.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

namespace gluray::saved {
namespace {

using render::Surface;
using Fragment = scene::FragmentShading;

/// Not a number becomes 0.
glm::vec4 inRange(const glm::vec4& c) {
  glm::vec4 out;
  for (int k = 0; k < 4; ++k) out[k] = c[k] > 0 ? std::min(c[k], 1.0f) : 0.0f;
  return out;
}

glm::vec4 raised(const glm::vec4& c, float exponent) {
  if (exponent == 1) return c;
  return {std::pow(std::max(c.x, 0.0f), exponent), std::pow(std::max(c.y, 0.0f), exponent),
          std::pow(std::max(c.z, 0.0f), exponent), c.w};
}

struct Change {
  float exponent = 1;  // of red, green and blue
  bool ignoresAlpha = false;
  bool changes() const { return exponent != 1 || ignoresAlpha; }
  void operator()(const glm::vec4* in, glm::vec4* out) const {
    *out = inRange(raised(*in, exponent));
    if (ignoresAlpha) out->w = 1;
  }
};

/// An attribute of colours, in a form that keeps all that it has.
SourcePtr colorArray(const scene::MeshPtr& mesh, const scene::Attribute& colors, const CornersPtr& corners,
                     Pick pick, uint32_t offset, const Change& change) {
  const bool bytes = colors.format == scene::Format::unorm8x4 && !change.changes();
  SourcePtr all =
      attributeArray(mesh, colors, bytes ? Element::bytes4 : Element::float4, corners, pick, offset);
  return bytes ? all : changedArray<glm::vec4, glm::vec4>(std::move(all), Element::float4, change);
}

/// The same of an attribute of the snapshot, once for all meshes that have it.
SourcePtr sharedColors(SceneParts& parts, const scene::MeshPtr& mesh, const scene::Attribute& colors,
                       const CornersPtr& corners, Pick pick, uint32_t offset, const Change& change) {
  const size_t count = corners ? corners->count() : mesh->vertexCount;
  const size_t how = kColors + kSourceUses * (static_cast<size_t>(pick) * 2 + (change.ignoresAlpha ? 1 : 0));
  return parts.source({colors.data, corners.get(), colors.stride | size_t{offset} << 32,
                       count | size_t{std::bit_cast<uint32_t>(change.exponent)} << 32, how},
                      [&] { return colorArray(mesh, colors, corners, pick, offset, change); });
}

uint32_t materialOf(const Surface& s, uint32_t vertex) {
  const scene::Attribute& a = s.mesh->materials;
  uint32_t index = 0;
  if (a) std::memcpy(&index, a.data + static_cast<size_t>(vertex) * a.stride, sizeof index);
  return index < s.materialCount ? index : 0;
}

glm::vec4 diffuseOf(const Surface& s, uint32_t material) { return s.materials[material].front.diffuse; }

/// Whether the vertex colours are the surface's, by fixed function.
bool followsColors(const Surface& s) {
  const scene::Shading& shading = *s.lighting->shading;
  return s.colorsVary && (!shading.lighting || shading.colorMaterial.front != scene::ColorMaterial::off);
}

bool materialsVary(const Surface& s) {
  return s.lighting->shading->lighting && s.mesh->materials && s.materialCount > 1;
}

ShownColors fixedColors(const Surface& s, const CornersPtr& corners, SceneParts& parts) {
  const scene::Shading& shading = *s.lighting->shading;
  const Pick pick = shading.smooth || !corners ? Pick::vertex : Pick::last;
  if (followsColors(s))
    return {glm::vec4(1), sharedColors(parts, s.instance->mesh, s.mesh->colors, corners, pick, 0, {})};
  if (!shading.lighting) return {inRange(s.instance->color), nullptr};
  if (!materialsVary(s)) return {inRange(diffuseOf(s, 0)), nullptr};
  std::vector<glm::vec4> colors(s.mesh->vertexCount);
  for (uint32_t v = 0; v < s.mesh->vertexCount; ++v) colors[v] = diffuseOf(s, materialOf(s, v));
  const scene::Attribute attribute = ownAttribute(std::move(colors), scene::Format::float4);
  return {glm::vec4(1), colorArray(s.instance->mesh, attribute, corners, pick, 0, {})};
}

std::vector<glm::vec4> heightColors(const Surface& s, const scene::HeightColors& by) {
  std::vector<glm::vec4> colors(s.mesh->vertexCount, glm::vec4(1));
  for (uint32_t v = 0; v < s.mesh->vertexCount; ++v)
    for (int c = 0; c < 3; ++c) {
      const float height = by.scale[c] * (s.mesh->position(v)[by.axis] + by.offset[c]);
      colors[v][c] = std::pow(height > 0 ? std::min(height, 1.0f) : 0.0f, by.exponent[c]);
    }
  return colors;
}

std::vector<glm::vec4> normalColors(const Surface& s) {
  std::vector<glm::vec4> colors(s.mesh->vertexCount, glm::vec4(1));
  for (uint32_t v = 0; v < s.mesh->vertexCount; ++v) {
    const glm::vec3 given =
        s.mesh->normals ? glm::vec3(scene::fetch(s.mesh->normals, v)) : s.instance->normal;
    const glm::vec3 n = s.instance->normalMatrix * given;
    const float length = glm::length(n);
    colors[v] = glm::vec4(0.5f + 0.5f * (length > 0 ? n / length : glm::vec3(0)), 1);
  }
  return colors;
}

ShownColors programColors(const Surface& s, const CornersPtr& corners, SceneParts& parts, Notes& notes) {
  const Fragment& f = s.lighting->shading->fragment;
  const bool encodes = f.encoding != 1;
  const float encoding = encodes ? 1 / f.encoding : 1;
  ShownColors shown{inRange(raised(diffuseOf(s, 0), encoding)), nullptr};
  const Change change{f.colorExponent * encoding, f.ignoresAlpha};
  const scene::MeshPtr& mesh = s.instance->mesh;
  const auto own = [&](std::vector<glm::vec4> colors) {
    return colorArray(mesh, ownAttribute(std::move(colors), scene::Format::float4), corners, Pick::vertex, 0,
                      change);
  };
  if (f.normalColors) {
    notes.insert("colours that show directions were kept as seen from the viewer of this frame");
    shown.colors = own(normalColors(s));
  } else if (f.color == Fragment::Color::perTriangle) {
    shown.colors = sharedColors(parts, mesh, s.instance->triangleColors, corners, Pick::primitive,
                                s.instance->triangleOffset, change);
  } else if (f.color == Fragment::Color::height) {
    notes.insert("colours by height were written at vertices: between them they are interpolated");
    shown.colors = own(heightColors(s, f.height));
  } else if (f.color == Fragment::Color::vertices && s.colorsVary) {
    shown.colors = sharedColors(parts, mesh, s.mesh->colors, corners, Pick::vertex, 0, change);
  } else if (f.color == Fragment::Color::vertices) {
    glm::vec4 color;
    change(&s.instance->color, &color);
    shown.factor *= color;
  }
  return shown;
}

/// For each vertex, a corner of a primitive that it is: primitive * 3 + corner.
std::vector<size_t> cornersOfVertices(const scene::Mesh& mesh) {
  std::vector<size_t> found(mesh.vertexCount, 0);
  for (uint32_t t = mesh.triangleCount; t-- > 0;)
    for (uint32_t k = 0; k < 3; ++k) found[mesh.corner(t, k)] = size_t{3} * t + k;
  return found;
}

}  // namespace

glm::vec4 ShownColors::at(size_t vertex) const {
  if (!colors) return factor;
  if (colors->element() == Element::bytes4) {
    uint8_t bytes[4];
    colors->read(vertex, 1, reinterpret_cast<std::byte*>(bytes));
    return factor * glm::vec4(bytes[0], bytes[1], bytes[2], bytes[3]) / 255.0f;
  }
  glm::vec4 color;
  colors->read(vertex, 1, reinterpret_cast<std::byte*>(&color));
  return factor * color;
}

bool changeByTriangle(const Surface& s) {
  const scene::Shading& shading = *s.lighting->shading;
  if (scene::isProgram(shading)) return shading.fragment.color == Fragment::Color::perTriangle;
  return !shading.smooth && (followsColors(s) || materialsVary(s));
}

ShownColors shownColors(const Surface& s, const CornersPtr& corners, SceneParts& parts, Notes& notes) {
  return scene::isProgram(*s.lighting->shading) ? programColors(s, corners, parts, notes)
                                                : fixedColors(s, corners, parts);
}

ShownColors texturedColors(const Surface& s, const scene::Camera& camera,
                           const std::vector<scene::Texture>& textures, bool map, const ShownColors& before,
                           const CornersPtr& corners) {
  constexpr size_t kGrain = 4096;
  const bool factors = scene::isProgram(*s.lighting->shading);
  const size_t count = corners ? corners->count() : s.mesh->vertexCount;
  const std::vector<size_t> places = corners ? std::vector<size_t>() : cornersOfVertices(*s.mesh);
  std::vector<glm::vec4> colors(count);
  forPieces(count, kGrain, [&](size_t first, size_t last) {
    render::TexturedTriangle triangle(s, camera, textures);
    const render::WeightSteps none;  // a pixel of no size: the largest level
    for (size_t i = first; i < last; ++i) {
      const size_t place = corners ? size_t{3} * corners->primitiveOf(i) + i % 3 : places[i];
      const auto primitive = static_cast<uint32_t>(place / 3);
      const float u = place % 3 == 1 ? 1 : 0, v = place % 3 == 2 ? 1 : 0;
      const glm::vec4 primary = before.at(i);
      glm::vec4 texel[scene::kTextureUnits];
      if (map) {
        triangle.texels(primitive, u, v, {0, 0}, &none, texel);
        colors[i] = inRange(primary * texel[0]);
      } else if (factors) {
        colors[i] = inRange(primary * triangle.color(primitive, u, v, {0, 0}, glm::vec4(1), &none));
      } else {
        colors[i] = inRange(triangle.color(primitive, u, v, {0, 0}, primary, &none));
      }
    }
  });
  return {glm::vec4(1), ownArray(Element::float4, std::move(colors))};
}

}  // namespace gluray::saved
