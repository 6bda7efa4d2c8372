// Lit scenes for the tests of shadows: a wall that the viewer faces, and what casts shadows on it.
#pragma once
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>

#include <vector>

namespace gluray::test {

constexpr int kLitSize = 64;                       // pixels
constexpr float kHalfWidth = 1.8198511713310124f;  // of the wall z = 0 in the view

/// x of the wall at a column of pixels.
inline float wallAt(int column) {
  return ((static_cast<float>(column) + 0.5f) / (kLitSize / 2) - 1) * kHalfWidth;
}

/// The wall z = 0 that fills the view.
inline scene::MeshPtr wall(float size = 500) { return parallelogram({0, 0, 0}, {size, 0, 0}, {0, size, 0}); }

/// A screen at z = 1, outside the view, from x = 1.6 on.
inline scene::MeshPtr screen() { return parallelogram({101.6f, 0, 1}, {100, 0, 0}, {0, 500, 0}); }

/// What shades the meshes.
enum class Shader { fixedFunction, phong, pbr };

/// One white light on white matter, no ambient light.
inline void setLight(scene::Snapshot& s, Shader shader, const glm::vec4& position) {
  scene::Shading& shading = s.shadings[0];
  if (shader == Shader::fixedFunction) {
    shading.lighting = true;
    shading.globalAmbient = {0, 0, 0, 1};
    scene::Light light;
    light.diffuse = glm::vec4(1);
    light.position = position;
    shading.lights = {light};
  } else {
    shading.fragment.model =
        shader == Shader::phong ? scene::FragmentShading::Model::phong : scene::FragmentShading::Model::pbr;
    shading.fragment.normals = scene::FragmentShading::Normals::triangles;
    scene::FragmentLight light;
    light.kind = position.w == 0 ? scene::FragmentLight::directional : scene::FragmentLight::positional;
    light.direction = glm::normalize(-glm::vec3(position));
    light.position = glm::vec3(position);
    shading.fragment.lights = {light};
  }
  for (scene::Instance& instance : s.instances) {
    instance.lightingFromObject = glm::mat4(instance.eyeFromObject);
    scene::Material& material = instance.materials[0].front;
    material.diffuse = glm::vec4(1), material.ambient = {0, 0, 0, 1};
    instance.materials[0].back = material;
  }
}

/// The meshes before a camera at (0, 0, 5) that looks at the origin; y is up. Eye space lies 5 behind.
inline scene::Snapshot litView(const std::vector<scene::MeshPtr>& meshes, Shader shader,
                               const glm::vec4& light) {
  scene::Snapshot s = makeSnapshot(meshes, kLitSize);
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5});
  for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
  setLight(s, shader, light);
  s.settings.shadows.enabled = true;
  s.settings.shadows.size = 0;
  return s;
}

}  // namespace gluray::test
