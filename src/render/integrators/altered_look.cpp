#include "render/integrators/altered_look.h"

#include <algorithm>

namespace gluray::render {
namespace {

using Fragment = scene::FragmentShading;
using Tracking = scene::ColorMaterial;

constexpr glm::vec4 kNone{0, 0, 0, 1};

void blacken(glm::vec4& color) { color = {0, 0, 0, color.a}; }

/// glColorMaterial, as far as it concerns the diffuse colour, which shows as the ambient one.
Tracking::Mode ofDiffuse(Tracking::Mode mode) {
  const bool diffuse = mode == Tracking::diffuse || mode == Tracking::ambientAndDiffuse;
  return diffuse ? Tracking::ambientAndDiffuse : Tracking::off;
}

/// Lit by one ambient light alone.
void lightByAmbient(scene::Shading& s, const glm::vec4& ambient) {
  s.lights.clear();
  s.globalAmbient = ambient;
  s.separateSpecular = false;
}

void toAlbedo(scene::Shading& s) {
  s.fog.mode = scene::Fog::off;
  s.alphaTest.function = scene::AlphaTest::always;
  if (!isLit(s)) return;
  if (!isProgram(s)) {
    lightByAmbient(s, glm::vec4(1));
    s.colorMaterial = {ofDiffuse(s.colorMaterial.front), ofDiffuse(s.colorMaterial.back)};
    return;
  }
  s.fragment.model = Fragment::Model::unlit;
  s.fragment.edgeColor = glm::vec3(0);
}

void toAlbedoWithoutEdges(scene::Shading& s) {
  toAlbedo(s);
  s.fragment.edges = false;
}

void reflectOnly(const scene::Shading& before, scene::Material& m) {
  if (!isLit(before)) return;
  m.ambient = isProgram(before) ? kNone : m.diffuse;
  blacken(m.emission), blacken(m.specular);
}

void materialsToAlbedo(const scene::Shading& before, scene::MaterialPair& pair) {
  reflectOnly(before, pair.front), reflectOnly(before, pair.back);
}

void toEmission(scene::Shading& s) {
  s.fog.mode = scene::Fog::off;
  s.alphaTest.function = scene::AlphaTest::always;
  if (!isLit(s)) return;
  if (!isProgram(s)) {
    const auto ofEmission = [](Tracking::Mode mode) {
      return mode == Tracking::emission ? mode : Tracking::off;
    };
    lightByAmbient(s, kNone);
    s.colorMaterial = {ofEmission(s.colorMaterial.front), ofEmission(s.colorMaterial.back)};
    return;
  }
  if (s.fragment.model == Fragment::Model::pbr) {
    // The emission, which becomes the ambient colour, is multiplied by its texture and nothing else.
    const scene::PbrSurface& pbr = s.fragment.pbr;
    const bool textured = pbr.emission >= 0;
    s.fragment.color = Fragment::Color::material;
    s.fragment.colorIsDiffuseOnly = !textured, s.fragment.edges = false;
    if (textured) s.textures = {pbr.textures[static_cast<size_t>(pbr.emission)]};
  }
  s.fragment.model = Fragment::Model::unlit;
  s.fragment.backColor = glm::vec3(0);
}

void toEmissionWithoutEdges(scene::Shading& s) {
  toEmission(s);
  s.fragment.edges = false;
}

void emitOnly(const scene::Shading& before, scene::Material& m) {
  if (!isLit(before)) return;
  if (before.fragment.model == Fragment::Model::pbr) m.ambient = glm::vec4(before.fragment.pbr.emissive, 1);
  blacken(m.diffuse), blacken(m.specular);
}

void materialsToEmission(const scene::Shading& before, scene::MaterialPair& pair) {
  emitOnly(before, pair.front), emitOnly(before, pair.back);
}

bool isBlack(const glm::vec4& color) { return glm::vec3(color) == glm::vec3(0); }

bool emits(const scene::Shading& s, const scene::Material& m) {
  if (s.fragment.model == Fragment::Model::pbr) return s.fragment.pbr.emissive != glm::vec3(0);
  return !isBlack(isProgram(s) ? m.ambient : m.emission);
}

bool emits(const Surface& surface) {
  if (!surface.instance) return false;
  const scene::Instance& instance = *surface.instance;
  const scene::Shading& s = *surface.lighting->shading;
  const auto tracked = [](Tracking::Mode mode) { return mode == Tracking::emission; };
  if (!isLit(s)) return false;
  if (!isProgram(s) && (tracked(s.colorMaterial.front) || tracked(s.colorMaterial.back))) return true;
  return std::any_of(instance.materials.begin(), instance.materials.end(),
                     [&](const auto& pair) { return emits(s, pair.front) || emits(s, pair.back); });
}

}  // namespace

bool paintsEdges(const scene::Snapshot& snapshot) {
  return std::any_of(snapshot.shadings.begin(), snapshot.shadings.end(),
                     [](const scene::Shading& s) { return isProgram(s) && s.fragment.edges; });
}

AlteredLook::AlteredLook(const FrameData& frame, AlterShading alterShading, AlterMaterials alterMaterials)
    : materials_(frame.surfaces.size()), surfaces_(frame.surfaces) {
  shadings_.reserve(frame.lightings.size()), lightings_.reserve(frame.lightings.size());
  for (const Lighting& lighting : frame.lightings) {
    alterShading(shadings_.emplace_back(*lighting.shading));
    lightings_.emplace_back(shadings_.back());
  }
  for (size_t i = 0; i < surfaces_.size(); ++i) {
    Surface& surface = surfaces_[i];
    if (!surface.instance) continue;  // nothing to hit
    const scene::Shading& before = *surface.lighting->shading;
    surface.lighting = &lightings_[static_cast<size_t>(surface.lighting - frame.lightings.data())];
    materials_[i].assign(surface.materials, surface.materials + surface.materialCount);
    for (scene::MaterialPair& pair : materials_[i]) alterMaterials(before, pair);
    surface.materials = materials_[i].data();
  }
}

SurfaceColors surfaceColors(const FrameData& frame, bool edges) {
  SurfaceColors colors;
  colors.albedo =
      std::make_unique<AlteredLook>(frame, edges ? toAlbedo : toAlbedoWithoutEdges, materialsToAlbedo);
  const scene::Snapshot& snapshot = *frame.snapshot;
  const bool any = std::any_of(frame.surfaces.begin(), frame.surfaces.end(),
                               [](const Surface& surface) { return emits(surface); });
  if (any || (edges && paintsEdges(snapshot)))
    colors.emission = std::make_unique<AlteredLook>(frame, edges ? toEmission : toEmissionWithoutEdges,
                                                    materialsToEmission);
  return colors;
}

}  // namespace gluray::render
