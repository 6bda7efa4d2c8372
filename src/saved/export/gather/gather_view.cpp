#include "saved/export/gather/gather_view.h"

#include "render/lights/light_conversion.h"
#include "render/local/lighting_space.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace gluray::saved {
namespace {

using scene::LightSource;
using scene::Shading;

bool isSmall(double value, double against) {
  constexpr double kTolerance = 2e-3;  // matrices of programs are floats
  return std::abs(value) <= kTolerance * against;
}

ExportedLight inWorld(const LightSource& source, const glm::dmat4& worldFromEye) {
  ExportedLight light{source, false};
  light.source.position = glm::vec3(worldFromEye * glm::dvec4(source.position, 1));
  light.source.direction = glm::vec3(glm::normalize(glm::dmat3(worldFromEye) * glm::dvec3(source.direction)));
  return light;
}

ExportedLight headlight(const glm::vec3& color) {
  LightSource source;
  source.color = color;
  return {source, true};
}

bool isBlack(const LightSource& light) { return light.color == glm::vec3(0) || light.strength == 0; }

/// The lights of a surface that is lit, in world space.
std::vector<ExportedLight> lightsOf(const scene::Snapshot& s, const scene::Instance& instance,
                                    const glm::dmat4& worldFromEye) {
  const Shading& shading = s.shadings[instance.shading];
  std::vector<ExportedLight> lights;
  const auto add = [&](ExportedLight light) {
    if (!isBlack(light.source)) lights.push_back(std::move(light));
  };
  if (!scene::isProgram(shading)) {
    for (const scene::Light& light : shading.lights) add(inWorld(render::sourceOf(light), worldFromEye));
    return lights;
  }
  const glm::dmat4 eyeFrom = render::eyeFromLighting(instance, shading, frame::Viewer(s).away());
  for (const scene::FragmentLight& light : shading.fragment.lights)
    add(light.kind == scene::FragmentLight::headlight
            ? headlight(light.color)
            : inWorld(render::sourceOf(light, eyeFrom), worldFromEye));
  return lights;
}

/// Lights of programs are in the spaces of their surfaces: those of one kind count as equal.
bool haveEqualLights(const Shading& a, const Shading& b) {
  return scene::isProgram(a) == scene::isProgram(b) && a.lights == b.lights &&
         a.fragment.lights.size() == b.fragment.lights.size();
}

}  // namespace

void gatherCamera(const scene::Camera& camera, const glm::dmat4& eyeFromWorld, ExportedView& view,
                  Notes& notes) {
  constexpr const char* kOther = "a camera that is neither a perspective nor a parallel view was left out";
  scene::Snapshot seen;  // without surfaces
  seen.camera = camera, seen.eyeFromWorld = eyeFromWorld;
  try {
    const frame::Viewer viewer(seen);
    const NearPlane plane(camera);
    const double width = glm::length(plane.right), height = glm::length(plane.up);
    const glm::dvec3 sight = plane.middle - viewer.position();
    const bool right = isSmall(glm::dot(plane.right, plane.up), width * height);
    const bool mirrored = plane.isMirrored() != (glm::determinant(eyeFromWorld) < 0);
    const frame::CameraDescription described = frame::describeCamera(seen);
    const double numbers =
        described.angle + described.height + described.near + described.far + width / height;
    if (!right || mirrored || !std::isfinite(numbers) || !(described.far > described.near) ||
        (viewer.isPerspective() && !(described.near > 0))) {
      notes.insert(kOther);
      return;
    }
    const double aside = glm::length(sight);
    if (viewer.isPerspective() && !(isSmall(glm::dot(sight, plane.right), aside * width) &&
                                    isSmall(glm::dot(sight, plane.up), aside * height)))
      notes.insert("a camera whose image is not about its axis was written as one whose is");
    view.camera = described, view.aspect = width / height;
  } catch (const std::exception&) { notes.insert(kOther); }
}

void gatherLights(const ViewBatches& batches, const glm::dmat4& worldFromEye, ExportedView& view,
                  Notes& notes) {
  const Shading* chosen = nullptr;
  for (const auto& [s, viewFromEye] : batches)
    for (const scene::Instance& instance : s->instances) {
      const Shading& shading = s->shadings[instance.shading];
      if (!scene::isLit(shading) || instance.ground || &shading == chosen) continue;
      if (!chosen) {
        chosen = &shading;
        view.lights = lightsOf(*s, instance, worldFromEye * viewFromEye);
      } else if (!haveEqualLights(*chosen, shading)) {
        notes.insert("of lights that shine on some surfaces alone, those of the first surface were written");
        break;
      }
    }
  if (chosen && chosen->fragment.pbr.environment.on())
    notes.insert("light from images of an environment was left out");
  const auto hasPlace = [](const ExportedLight& light) {
    return light.source.kind != LightSource::Kind::distant;
  };
  if (std::any_of(view.lights.begin(), view.lights.end(), hasPlace))
    notes.insert(
        "lights at places were approximated: in files they fade by the square of the distance, or shine "
        "from one direction");
}

}  // namespace gluray::saved
