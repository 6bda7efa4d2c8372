#include "render/local/honest_look.h"

namespace gluray::render {
namespace {

using Mode = scene::ColorMaterial;
using Fragment = scene::FragmentShading;

Mode::Mode honestMode(Mode::Mode mode) {
  return mode == Mode::diffuse || mode == Mode::ambientAndDiffuse ? Mode::ambientAndDiffuse : Mode::off;
}

/// Fixed function lights materials by an ambient light of 1 alone: their ambient colour becomes the diffuse
/// one.
void makeHonest(scene::Shading& s) {
  s.lights.clear();
  s.globalAmbient = glm::vec4(1);
  s.colorMaterial = {honestMode(s.colorMaterial.front), honestMode(s.colorMaterial.back)};
  s.colorSum = false;
  s.fog.mode = scene::Fog::off;
  s.fragment.lights.clear();
  if (s.fragment.model != Fragment::Model::off) s.fragment.model = Fragment::Model::unlit;
  s.fragment.matcap.clear(), s.fragment.backFactor = 1;
}

scene::Material honestOf(const scene::Material& m, const Fragment& fragment) {
  scene::Material honest;
  honest.diffuse = m.diffuse;
  if (fragment.model != Fragment::Model::off && fragment.color != Fragment::Color::material)
    honest.diffuse = {1, 1, 1, m.diffuse.a};
  // A program's unlit colour is the sum of both.
  honest.ambient = fragment.model == Fragment::Model::off ? m.diffuse : glm::vec4(0, 0, 0, 1);
  honest.specular = honest.emission = {0, 0, 0, 1};
  return honest;
}

}  // namespace

HonestLook::HonestLook(const scene::Snapshot& snapshot)
    : shadings_(snapshot.shadings), materials_(snapshot.instances.size()) {
  for (scene::Shading& shading : shadings_) makeHonest(shading);
}

void HonestLook::apply(size_t instance, Surface& surface) {
  std::vector<scene::MaterialPair>& materials = materials_[instance];
  materials.assign(surface.materials, surface.materials + surface.materialCount);
  const Fragment& fragment = surface.lighting->shading->fragment;
  for (scene::MaterialPair& pair : materials)
    pair = {honestOf(pair.front, fragment), honestOf(pair.back, fragment)};
  surface.materials = materials.data();
}

}  // namespace gluray::render
