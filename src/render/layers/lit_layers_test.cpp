// Light of translucent layers: they share the light samples of a pixel.
#include "render/effects/first_sample.h"
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace gluray::render {
namespace {

TEST(LitLayers, TakeLightSamplesByTheirShare) {
  EXPECT_EQ(partOf(16, 1), 16);
  EXPECT_EQ(partOf(16, 0.5f), 8);
  EXPECT_EQ(partOf(16, 0.26f), 5) << "rounded up";
  EXPECT_EQ(partOf(16, 0.125f * 1.00001f), 2) << "but not for rounding errors";
  EXPECT_EQ(partOf(16, 0), 1) << "each takes one";
  EXPECT_EQ(partOf(1, 0.5f), 1);
}

/// Translucent walls behind each other beside an endless opaque one out of view, which hides half of the sky.
scene::Snapshot hallOf(scene::Layers::Of of, int layers, int rays) {
  std::vector<scene::MeshPtr> meshes;
  for (int i = 0; i < layers; ++i)
    meshes.push_back(test::parallelogram({0, 0, -0.5f * static_cast<float>(i)}, {500, 0, 0}, {0, 500, 0}));
  meshes.push_back(test::parallelogram({3, 0, 5e4f}, {0, 5e5f, 0}, {0, 0, 5e4f}));
  scene::Snapshot s = test::makeSnapshot(meshes, 16);
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5});
  for (size_t i = 0; i < s.instances.size(); ++i) {
    s.instances[i].eyeFromObject = s.eyeFromWorld;
    s.instances[i].color = i + 1 < s.instances.size() ? glm::vec4(0.9f, 0.6f, 0.3f, 0.4f) : glm::vec4(1);
    s.instances[i].order = static_cast<uint32_t>(i);
  }
  auto all = std::make_shared<scene::Layers>();
  all->of = of;
  all->opaqueDepth.assign(16 * 16, of == scene::Layers::Of::drawn ? 1.0f : -1.0f);
  all->colors.assign(of == scene::Layers::Of::drawn ? 16 * 16 : 0, 0);
  all->blending.rgb = {scene::BlendEquation::add, scene::BlendFactor::sourceAlpha,
                       scene::BlendFactor::oneMinusSourceAlpha};
  all->blending.writesDepth = false;
  s.layers = all;
  s.wideColors = of == scene::Layers::Of::order;
  s.settings.ao.enabled = true, s.settings.ao.radius = 100;
  s.settings.ao.samples = rays;
  return s;
}

/// Mean red over all pixels and so many passes.
double meanOf(scene::Snapshot s, uint32_t passes) {
  double sum = 0;
  for (uint32_t pass = 0; pass < passes; ++pass) {
    s.lightSampling.pass = pass;
    const auto traced = test::trace(s);
    for (int i = 0; i < 256; ++i) {
      const auto at = static_cast<size_t>(i);
      sum += traced.image.has(Plane::wideColor) ? double{traced.image.wideColor[4 * at]}
                                                : double{traced.color(i % 16, i / 16).r} / 255;
    }
  }
  return sum / (256.0 * passes);
}

TEST(LitLayers, FewSamplesHaveTheMeanOfMany) {
  for (const scene::Layers::Of of :
       {scene::Layers::Of::order, scene::Layers::Of::sums, scene::Layers::Of::drawn}) {
    const double many = meanOf(hallOf(of, 5, 2048), 1), few = meanOf(hallOf(of, 5, 4), 64);
    EXPECT_NEAR(few / many, 1, 0.01) << static_cast<int>(of);
  }
}

}  // namespace
}  // namespace gluray::render
