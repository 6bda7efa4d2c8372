#include "saved/export/formats/glb_lights.h"

#include "saved/export/arrays/linear_colors.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::saved {

using nlohmann::json;
using scene::LightSource;

WorldBox::WorldBox(const ExportedScene& scene, const ExportedView& view) {
  if (view.nodes.empty()) return;
  lower = glm::dvec3(std::numeric_limits<double>::infinity()), upper = -lower;
  for (const ExportedNode& node : view.nodes) {
    const ExportedMesh& mesh = scene.meshes[node.mesh];
    for (int corner = 0; corner < 8; ++corner) {
      glm::dvec4 p(0, 0, 0, 1);
      for (int c = 0; c < 3; ++c) p[c] = corner >> c & 1 ? mesh.upper[c] : mesh.lower[c];
      const glm::dvec3 world(node.worldFromMesh * p);
      lower = glm::min(lower, world), upper = glm::max(upper, world);
    }
  }
}

ExportedLight fileLight(ExportedLight light, const WorldBox& box) {
  constexpr double kFar = 2;  // radii of the box
  LightSource& source = light.source;
  const glm::dvec3 way = box.middle() - glm::dvec3(source.position);
  const glm::vec3& fading = source.attenuation;
  if (source.kind != LightSource::Kind::point || fading.y != 0 || fading.z != 0 || !(fading.x > 0) ||
      !(glm::length(way) > kFar * box.radius()))
    return light;
  source.kind = LightSource::Kind::distant, source.strength /= fading.x;
  source.direction = glm::vec3(glm::normalize(way));
  return light;
}

std::optional<json> lightOf(const ExportedLight& light, const WorldBox& box) {
  const LightSource& source = light.source;
  const bool distant = source.kind == LightSource::Kind::distant;
  const double distance = glm::length(glm::dvec3(source.position) - box.middle());
  double reached = 1;
  if (!distant) {
    const glm::dvec3 a(source.attenuation);
    reached = 1 / std::max(a.x + distance * (a.y + distance * a.z), 1e-6);
  }
  const glm::vec3 displayed = source.strength * static_cast<float>(reached) * source.color;
  const glm::vec3 linear(linearOf(glm::vec4(glm::max(displayed, glm::vec3(0)), 1)));
  const float most = std::max({linear.r, linear.g, linear.b});
  if (!(most > 0) || !std::isfinite(most)) return {};
  // A white surface reflects 1 / pi of its illuminance; at a distance d that is the intensity by d^2.
  const double intensity = glm::pi<double>() * most * (distant ? 1 : distance * distance);
  const glm::vec3 color = linear / most;
  json out = {{"type", "directional"}, {"color", {color.r, color.g, color.b}}, {"intensity", intensity}};
  if (distant) return out;
  out["type"] = "point";
  if (source.kind != LightSource::Kind::spot) return out;
  out["type"] = "spot";
  const double outer =
      std::clamp(std::acos(std::clamp<double>(source.coneCosine, -1, 1)), 1e-3, glm::half_pi<double>());
  out["spot"] = {{"innerConeAngle", source.coneExponent > 0 ? 0 : 0.999 * outer}, {"outerConeAngle", outer}};
  return out;
}

}  // namespace gluray::saved
