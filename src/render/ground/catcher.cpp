#include "render/ground/catcher.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {

void showTaken(const ColorRows& open, ColorRows& rows) {
  // Rec. 709
  const auto luminance = [](const ColorRows& r, int i) {
    return 0.2126f * r.value[0][i] + 0.7152f * r.value[1][i] + 0.0722f * r.value[2][i];
  };
  for (int i = 0; i < kLanes; ++i) {
    const float all = luminance(open, i), left = luminance(rows, i) / all;
    rows.value[3][i] = all > 0 && std::isfinite(left) ? 1 - std::clamp(left, 0.0f, 1.0f) : 0.0f;
    for (int c = 0; c < 3; ++c) rows.value[c][i] = 0;
  }
}

void CatcherLook::light(const ColoredHits& hits, ColorRows& rows) const noexcept {
  if (hits.instance != catcher_) return light_->light(hits, rows);
  ColorRows open = rows;
  light_->lightAlone(hits, open);
  light_->light(hits, rows);
  showTaken(open, rows);
}

namespace {

/// The shading of matte surfaces without lights.
scene::Shading unlitMatte() {
  scene::Shading shading;
  shading.fragment.model = scene::FragmentShading::Model::phong;
  shading.fragment.normals = scene::FragmentShading::Normals::triangles;
  return shading;
}

bool isMatte(const scene::Material& m) {
  const bool lit = m.ambient.r > 0 && m.ambient.g > 0 && m.ambient.b > 0;
  return lit && m.specular == glm::vec4(0, 0, 0, 1) && m.emission == glm::vec4(0, 0, 0, 1);
}

/// Whether all points of the surface have one look, of ambient light, that is not black.
bool isEvenlyLit(const FrameData& frame, size_t instance) {
  const scene::Instance& surface = frame.snapshot->instances[instance];
  if (surface.mesh->colors || surface.materials.size() != 1) return false;
  const scene::MaterialPair& material = surface.materials[0];
  return isMatte(material.front) && material.front == material.back &&
         frame.shadings()[frame.shadingOf(instance)] == unlitMatte();
}

}  // namespace

std::optional<float> caughtOcclusionOf(const FrameData& frame, const VisibilityIntegrator& integrator) {
  const bool plain = frame.snapshot->catches && frame.image->isPlain() && !frame.direct && !frame.tone &&
                     !frame.litTone && !frame.lamps && !frame.grown;
  if (!plain) return {};
  for (size_t i = 0; i < frame.snapshot->instances.size(); ++i)
    if (!isEvenlyLit(frame, i)) return {};
  return integrator.occlusionAlone();
}

void AllCaught::apply(const ColoredHits& hits, const Visibility& visibility, ColorRows& rows) const noexcept {
  ColorRows open = rows;
  light_->lightAlone(hits, open);
  light_->apply(hits, visibility, rows);
  showTaken(open, rows);
}

}  // namespace gluray::render
