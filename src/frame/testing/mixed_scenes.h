// Scenes whose pixels mix samples or layers, for the tests of denoising.
#pragma once
#include "frame/testing/lit_scene.h"
#include "render/testing/test_ball.h"

#include <memory>
#include <vector>

namespace gluray::frame::test {

enum class Floor { none, plane };

/// Coloured balls, over a floor or not, with ambient occlusion, seen from above by a perspective camera.
inline scene::Snapshot balls(int size, Floor floor = Floor::plane, int rays = 16) {
  std::vector<scene::MeshPtr> meshes;
  const auto add = [&](const glm::vec3& center, float radius) {
    meshes.push_back(gluray::test::ballMesh(96, radius, center));
    auto& mesh = const_cast<scene::Mesh&>(*meshes.back());
    mesh.lower = center - radius, mesh.upper = center + radius;
  };
  add({-1.1f, 0.6f, 0.2f}, 0.6f), add({0.1f, 0.9f, -0.6f}, 0.9f), add({1.2f, 0.4f, 0.5f}, 0.4f);
  add({0.3f, 0.3f, 1.0f}, 0.3f), add({-0.3f, 0.2f, 1.2f}, 0.2f), add({0.8f, 0.15f, 1.3f}, 0.15f);
  if (floor == Floor::plane) meshes.push_back(plane({0, 0, 0}, {0, 0, 40}, {40, 0, 0}));
  scene::Snapshot s = gluray::test::makeSnapshot(meshes, size);
  s.camera.clipFromEye = glm::perspective(glm::radians(35.0), 1.0, 0.1, 1000.0);
  s.eyeFromWorld = glm::lookAt(glm::dvec3(0, 2.6, 5.5), glm::dvec3(0, 0.5, 0), glm::dvec3(0, 1, 0));
  const glm::vec4 colors[] = {{0.9f, 0.3f, 0.2f, 1}, {0.3f, 0.5f, 0.9f, 1}, {0.95f, 0.85f, 0.3f, 1},
                              {0.3f, 0.8f, 0.4f, 1}, {0.9f, 0.9f, 0.9f, 1}, {0.6f, 0.3f, 0.8f, 1},
                              {0.8f, 0.8f, 0.8f, 1}};
  for (size_t i = 0; i < s.instances.size(); ++i) {
    scene::Instance& instance = s.instances[i];
    instance.eyeFromObject = s.eyeFromWorld;
    instance.color = i + 1 == meshes.size() && floor == Floor::plane ? colors[6] : colors[i];
    instance.order = static_cast<uint32_t>(i);
  }
  s.settings.ao.enabled = true;
  s.settings.ao.samples = rays;
  s.settings.ao.radius = 100;
  s.settings.noise = 0.003f;
  return s;
}

inline scene::Snapshot averaged(scene::Snapshot s, int spp = 16) {
  s.settings.spp = spp;
  return s;
}

/// The same balls, translucent, in layers over an opaque background.
inline scene::Snapshot layered(scene::Snapshot s, float opacity = 0.5f) {
  for (scene::Instance& instance : s.instances) instance.color.a = opacity;
  auto layers = std::make_shared<scene::Layers>();
  layers->opaqueDepth.assign(static_cast<size_t>(s.region.width * s.region.height), -1.0f);
  s.layers = layers;
  return s;
}

/// A shadow catcher in place of the floor.
inline scene::Snapshot caught(scene::Snapshot s) {
  s.settings.ground.kind = GroundKind::catcher;
  s.ground = scene::GroundUse::drawn;
  return s;
}

inline scene::Snapshot blurred(scene::Snapshot s, float aperture = 0.2f) {
  s.settings.camera.aperture = aperture;
  return s;
}

/// As the snapshot, with so many times the rays.
inline scene::Snapshot manyRays(scene::Snapshot s, int times) {
  s.settings.denoise = Denoise::off;
  s.settings.ao.samples *= times, s.settings.shadows.samples *= times, s.settings.path.samples *= times;
  return s;
}

}  // namespace gluray::frame::test
