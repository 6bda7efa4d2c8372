#include "render/ground/ground_surface.h"

#include "render/lights/light_conversion.h"
#include "render/local/lighting_space.h"
#include "scene/effects.h"
#include "scene/secondary_scene.h"

#include <array>
#include <cstring>
#include <memory>

namespace gluray::render {
namespace {

using scene::FragmentLight;

/// Two triangles that face +z.
scene::MeshPtr squareMesh(float half) {
  struct Memory {
    std::array<float, 16> positions;  // with what readers of the last vertex may touch
    std::array<uint32_t, 8> indices;
  };
  const auto memory = std::make_shared<const Memory>(
      Memory{{-half, -half, 0, half, -half, 0, half, half, 0, -half, half, 0}, {0, 1, 2, 0, 2, 3}});
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->geometryId = hashBytes(memory->indices.data(), 24, hashBytes(memory->positions.data(), 48));
  mesh->triangleCount = 2, mesh->vertexCount = 4;
  mesh->positions = {memory, reinterpret_cast<const std::byte*>(memory->positions.data()), 12,
                     scene::Format::float3};
  mesh->indices = {memory, reinterpret_cast<const std::byte*>(memory->indices.data()), 4,
                   scene::Format::uint32};
  mesh->lower = {-half, -half, 0}, mesh->upper = {half, half, 0};
  mesh->sizeBytes = sizeof(Memory);
  return mesh;
}

/// The light at the viewer as fixed function has it.
scene::Light atViewer(const glm::vec3& color, const Viewer& away) {
  scene::Light light;
  light.diffuse = glm::vec4(color, 1);
  if (away.w == 0)
    light.position = glm::vec4(-glm::normalize(glm::dvec3(away)), 0);
  else
    light.position = glm::vec4(glm::dvec3(away) / away.w, 1);
  return light;
}

void takeLights(const scene::Snapshot& s, const scene::Instance& of, scene::Shading& to) {
  const scene::Shading& from = s.shadings[of.shading];
  to.lighting = true;
  if (!isProgram(from)) {
    to.lights = from.lights, to.globalAmbient = from.globalAmbient, to.localViewer = from.localViewer;
    return;
  }
  const Viewer away = glm::inverse(s.camera.clipFromEye)[2];
  const glm::dmat4 space = eyeFromLighting(of, from, away);
  for (const FragmentLight& light : from.fragment.lights)
    to.lights.push_back(light.kind == FragmentLight::headlight ? atViewer(light.color, away)
                                                               : fixedLight(sourceOf(light, space)));
}

}  // namespace

GroundSurface makeGround(const scene::Snapshot& s, const GroundPlace& place) {
  GroundSurface ground;
  scene::Shading& shading = ground.shading;
  shading.globalAmbient = {0, 0, 0, 1};
  shading.normalize = shading.twoSided = true;
  for (const scene::Instance& instance : s.instances) {
    if (!isLit(s.shadings[instance.shading])) continue;
    takeLights(s, instance, shading);
    break;
  }
  if (s.settings.lights.rig != LightRig::program) shading.lighting = true;
  scene::Instance& instance = ground.instance;
  instance.mesh = squareMesh(place.half);
  instance.worldFromObject = glm::mat4(place.worldFromObject);
  instance.eyeFromObject = s.eyeFromWorld * place.worldFromObject;
  instance.lightingFromObject = glm::mat4(instance.eyeFromObject);
  instance.order = UINT32_MAX;
  instance.ground = true;
  // What lights add up to on a catcher stays below 1, where it would be clamped: shadows are shares of it.
  constexpr float kDark = 1.0f / 16;
  const bool dark = scene::wantsCatcher(s.settings) && !scene::wantsPaths(s.settings);
  const glm::vec4 color = dark ? glm::vec4(glm::vec3(kDark), 1) : glm::vec4(s.settings.ground.color, 1);
  instance.color = color;
  scene::Material material;
  material.ambient = material.diffuse = color;
  instance.materials = {{material, material}};
  return ground;
}

}  // namespace gluray::render
