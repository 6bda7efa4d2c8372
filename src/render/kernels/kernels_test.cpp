// Every instruction set of this processor gives the same image.
#include "render/kernels/kernels.h"

#include "render/testing/test_targets.h"
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <bit>
#include <set>
#include <string>

namespace gluray {
namespace {

// A lit, textured, coloured, two-sided, clipped pair of instances: uses every kernel.
scene::Snapshot richScene(ShadingRate rate) {
  test::MeshData data = test::quadData({-4, -4, -5}, {4, -4, -6}, {4, 4, -5}, {-4, 4, -9});
  data.normals = {{0, 0, 1}, {0.3f, 0, 1}, {0, 0.5f, 1}, {-0.4f, 0.1f, 1}};
  data.colors = {{1, 0.2f, 0, 1}, {0, 1, 0.4f, 1}, {0.3f, 0, 1, 1}, {1, 1, 1, 1}};
  data.texcoords = {{0, 0, 0, 1}, {2, 0, 0, 1}, {2, 2, 0, 1}, {0, 2, 0, 1}};
  const auto mesh = test::makeMesh(data);
  auto s = test::makeSnapshot({mesh, mesh}, 61);
  s.camera.clipFromEye = glm::perspective(1.2, 1.0, 1.0, 100.0);
  s.settings.shading = rate;
  s.shadings.resize(2);
  for (scene::Shading& shading : s.shadings) {
    shading.lighting = shading.twoSided = shading.normalize = true;
    shading.lights.resize(2);
    shading.lights[0].diffuse = shading.lights[0].specular = glm::vec4(0.6f);
    shading.lights[1].position = {1, 2, -1, 1};
    shading.lights[1].diffuse = glm::vec4(0.8f);
    shading.lights[1].attenuation = {1, 0.05f, 0.01f};
    shading.lights[1].spotCutoff = 60;
    shading.lights[1].spotExponent = 3;
    shading.colorMaterial = {scene::ColorMaterial::diffuse, scene::ColorMaterial::ambient};
  }
  s.shadings[1].localViewer = true;
  auto image = std::make_shared<scene::TextureImage>();
  image->width = image->height = 2;
  image->texels = {0xFFFFFFFFu, 0xFF8080FFu, 0xFF80FF80u, 0xFFFF4040u};
  s.shadings[1].textures.resize(1);
  s.shadings[1].textures[0].image = image;
  for (auto& instance : s.instances) {
    instance.materials[0].front.specular = glm::vec4(0.7f);
    instance.materials[0].front.shininess = 9;
  }
  s.instances[1].shading = 1;
  s.instances[1].cull = scene::CullFace::back;
  s.instances[1].worldFromObject = glm::rotate(glm::mat4(1), 0.2f, glm::vec3(1, 3, 0));
  s.instances[1].eyeFromObject = glm::dmat4(s.instances[1].worldFromObject);
  s.instances[0].clipPlanes = {{1, 0.5, 0, 1}};
  return s;
}

TEST(Kernels, EveryInstructionSetAgrees) {
  for (const ShadingRate rate : {ShadingRate::pixel, ShadingRate::vertex}) {
    const auto snapshot = richScene(rate);
    const test::Traced best = test::trace(snapshot);
    std::set<std::string> seen{render::kernelTarget()};
    test::withEachTarget([&](int64_t) {
      if (!seen.insert(render::kernelTarget()).second) return;
      SCOPED_TRACE(render::kernelTarget());
      const test::Traced traced = test::trace(snapshot);
      int differing = 0;
      for (int y = 0; y < 61; ++y) {
        for (int x = 0; x < 61; ++x) {
          ASSERT_EQ(traced.hit(x, y), best.hit(x, y));
          EXPECT_NEAR(traced.depth(x, y), best.depth(x, y), 1.2e-7);
          // Fused multiply-adds round differently: a byte may differ by one.
          differing += test::difference(traced.color(x, y), best.color(x, y)) > 1;
        }
      }
      EXPECT_EQ(differing, 0);
    });
  }
}

}  // namespace
}  // namespace gluray
