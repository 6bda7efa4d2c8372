#include "render/integrators/occluders.h"

#include "render/integrators/occluder_alpha.h"
#include "render/local/alpha_test.h"
#include "scene/secondary_scene.h"

#include <algorithm>

namespace gluray::render {
namespace {

/// Interpolated vertex colour.
glm::vec4 vertexColor(const scene::Mesh& mesh, const accel::Occluder& o) {
  const auto color = [&](uint32_t k) { return scene::fetch(mesh.colors, mesh.corner(o.primitive, k)); };
  return color(0) * (1 - o.u - o.v) + color(1) * o.u + color(2) * o.v;
}

glm::vec4 colorOfProgram(const Surface& s, const accel::Occluder& o) {
  using Color = scene::FragmentShading::Color;
  const scene::Instance& instance = *s.instance;
  const glm::vec4 material = s.materials[0].front.diffuse;
  const scene::FragmentShading& f = s.lighting->shading->fragment;
  glm::vec4 color(1);
  if (f.color == Color::perTriangle)
    color = scene::fetch(instance.triangleColors, instance.triangleOffset + o.primitive);
  else if (f.color == Color::vertices)
    color = s.colorsVary ? vertexColor(*s.mesh, o) : instance.color;
  if (f.colorExponent != 1)
    color = {glm::pow(glm::max(glm::vec3(color), 0.0f), glm::vec3(f.colorExponent)), color.a};
  return material * color;
}

glm::vec4 colorOfFixedFunction(const Surface& s, const accel::Occluder& o) {
  using Mode = scene::ColorMaterial;
  const scene::Shading& shading = *s.lighting->shading;
  if (!shading.lighting) return s.colorsVary ? vertexColor(*s.mesh, o) : s.instance->color;
  const Mode::Mode mode = shading.colorMaterial.front;
  if (s.colorsVary && (mode == Mode::diffuse || mode == Mode::ambientAndDiffuse))
    return vertexColor(*s.mesh, o);
  const scene::Attribute& materials = s.mesh->materials;
  uint32_t index = 0;
  if (materials) {
    const std::byte* at =
        materials.data + static_cast<size_t>(s.mesh->corner(o.primitive, 2)) * materials.stride;
    index = *reinterpret_cast<const uint32_t*>(at);
  }
  return s.materials[index < s.materialCount ? index : 0].front.diffuse;
}

}  // namespace

Occluders::Occluders(const scene::Snapshot& snapshot, const std::vector<Surface>& surfaces)
    : surfaces_(surfaces), snapshot_(snapshot), translucent_(snapshot.layers != nullptr), tested_(false) {
  const size_t count = scene::countAll(snapshot);
  bool clipped = false;
  for (size_t i = 0; i < count; ++i) {
    clipped |= !scene::instanceOf(snapshot, i).clipPlanes.empty();
    translucent_ |= scene::isBlended(snapshot, i);
    tested_ |= surfaces_[i].instance &&
               surfaces_[i].lighting->shading->alphaTest.function != scene::AlphaTest::always;
  }
  if (!clipped) return;
  planes_.resize(count);
  for (size_t i = 0; i < count; ++i) {
    const scene::Instance& instance = scene::instanceOf(snapshot, i);
    // A plane acts on eye coordinates; as a row vector it comes to object space by the modelview on its
    // right.
    for (const glm::dvec4& plane : instance.clipPlanes) planes_[i].push_back(plane * instance.eyeFromObject);
  }
}

bool Occluders::keeps(uint32_t instance, float alpha) const {
  const Surface& s = surfaces_[instance];
  return !s.instance || passes(s.lighting->shading->alphaTest, alpha);
}

bool Occluders::isThere(const accel::Occluder& occluder) const {
  if (!planes_.empty()) {
    const glm::dvec4 point(occluder.point, 1);
    for (const glm::dvec4& plane : planes_[occluder.instance])
      if (!(glm::dot(plane, point) >= 0)) return false;
  }
  const Surface& s = surfaces_[occluder.instance];
  if (!tested_ || !s.instance) return true;
  const scene::AlphaTest& test = s.lighting->shading->alphaTest;
  return test.function == scene::AlphaTest::always || passes(test, colorAt(s, occluder).a);
}

glm::vec4 Occluders::colorAt(const Surface& s, const accel::Occluder& occluder) const {
  if (s.lighting->shading->fragment.model != scene::FragmentShading::Model::off)
    return glm::clamp(colorOfProgram(s, occluder), 0.0f, 1.0f);
  glm::vec4 color = glm::clamp(colorOfFixedFunction(s, occluder), 0.0f, 1.0f);
  color.a = fragmentAlpha(s, occluder, color.a);
  return color;
}

glm::vec4 Occluders::surfaceAt(const accel::Occluder& occluder) const {
  if (!translucent_ || !scene::isBlended(snapshot_, occluder.instance)) return glm::vec4(1);
  const Surface& s = surfaces_[occluder.instance];
  if (!s.instance) return glm::vec4(1);
  return colorAt(s, occluder);
}

glm::vec3 Occluders::transmittanceOf(const accel::Occluder& occluder) const {
  const glm::vec4 color = surfaceAt(occluder);
  const float largest = std::max(color.r, std::max(color.g, color.b));
  const glm::vec3 hue = largest > 0 ? glm::vec3(color) / largest : glm::vec3(1);
  return (1 - color.a) * glm::mix(glm::vec3(1), hue, color.a);
}

bool Transmittance::blocks(const accel::Occluder& occluder) const noexcept {
  constexpr float kNothing = 0.5f / 255;  // less is not seen
  if (!occluders_.isThere(occluder)) return false;
  float& left = through[occluder.lane];
  left *= 1 - occluders_.opacityOf(occluder);
  return left < kNothing;
}

bool ColoredTransmittance::blocks(const accel::Occluder& occluder) const noexcept {
  constexpr float kNothing = 0.5f / 255;  // less is not seen
  if (!occluders_.isThere(occluder)) return false;
  if (occluder.instance == ignoredByLane[occluder.lane]) return false;
  if (std::binary_search(ignored_.begin(), ignored_.end(), occluder.instance)) return false;
  glm::vec3& left = through[occluder.lane];
  left *= occluders_.transmittanceOf(occluder);
  return std::max(left.r, std::max(left.g, left.b)) < kNothing;
}

}  // namespace gluray::render
