// Multisampled images: coverage and depth per sample, shading once per pixel.
#include "render/testing/test_targets.h"
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gluray {
namespace {

using test::makeMesh;
using test::makeSnapshot;
using test::trace;
using test::Traced;

constexpr int kSampledSize = 16;
constexpr int kSamples = 4;

void multisample(scene::Snapshot& s, ShadingRate rate = ShadingRate::pixel) {
  s.samples = kSamples;
  s.samplePositions = {{0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}};
  s.settings.shading = rate;
}

/// Red grows with x, green with y, by 10 per pixel; corners as given.
test::MeshData ramp(std::vector<glm::vec3> corners) {
  test::MeshData data;
  data.positions = std::move(corners);
  for (const glm::vec3& p : data.positions)
    data.colors.emplace_back((p.x + 1) * 80 / 255, (p.y + 1) * 80 / 255, 0.2f, 1);
  return data;
}

TEST(Multisample, SurfacesAreShadedAtPixelCentres) {
  // A quad that covers the window, and a triangle whose slanted side crosses pixels.
  const std::vector<std::vector<glm::vec3>> all = {
      {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
      {{-0.9f, -0.8f, 0.3f}, {0.7f, -0.45f, -0.2f}, {0.1f, 0.85f, 0.1f}}};
  for (const auto& corners : all) {
    auto s = makeSnapshot({makeMesh(ramp(corners))}, kSampledSize);
    multisample(s);
    const Traced traced = trace(s);
    int hits = 0;
    for (int y = 0; y < kSampledSize; ++y) {
      for (int x = 0; x < kSampledSize; ++x) {
        for (int sample = 0; sample < kSamples; ++sample) {
          if (!traced.hit(x, y, sample)) continue;
          ++hits;
          const glm::vec4 color = traced.color(x, y, sample);
          // Also where the centre is not covered: the plane is evaluated there.
          EXPECT_NEAR(color.r, 10 * (static_cast<float>(x) + 0.5f), 0.6f) << x << ' ' << y;
          EXPECT_NEAR(color.g, 10 * (static_cast<float>(y) + 0.5f), 0.6f) << x << ' ' << y;
        }
      }
    }
    EXPECT_GT(hits, 200);
  }
}

TEST(Multisample, EverySampleIsShadedOnRequest) {
  auto s = makeSnapshot({makeMesh(ramp({{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}}))}, kSampledSize);
  multisample(s, ShadingRate::sample);
  const Traced traced = trace(s);
  for (int sample = 0; sample < kSamples; ++sample)
    EXPECT_NEAR(traced.color(5, 7, sample).r, 10 * (5 + s.samplePositions[static_cast<size_t>(sample)].x),
                0.6f);
}

TEST(Multisample, CoverageAndDepthArePerSample) {
  auto s = makeSnapshot({makeMesh(ramp({{-0.9f, -0.8f, 0.9f}, {0.7f, -0.45f, -0.7f}, {0.1f, 0.85f, 0.1f}})),
                         makeMesh(test::squareData(-0.1f))},
                        kSampledSize);
  s.polygonOffset = {1, 3};
  multisample(s, ShadingRate::sample);
  const Traced each = trace(s);
  s.settings.shading = ShadingRate::pixel;
  const Traced once = trace(s);
  for (size_t i = 0; i < each.image.depth.size(); ++i)
    ASSERT_NEAR(once.image.depth[i], each.image.depth[i], 1.2e-7) << i;
}

TEST(Multisample, TexturesAndPerspective) {
  test::MeshData data = test::quadData({-6, -4, -3}, {5, -4, -4}, {5, 4, -30}, {-6, 4, -25});
  data.texcoords = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}};
  auto s = makeSnapshot({makeMesh(data)}, 32);
  s.camera.clipFromEye = glm::perspective(1.2, 1.0, 1.0, 50.0);
  auto image = std::make_shared<scene::TextureImage>();
  image->width = image->height = 64;
  for (uint32_t i = 0; i < 64 * 64; ++i) image->texels.push_back(0xFF000000u | i % 64 * 4 | i / 64 * 4 << 8);
  scene::Texture texture;
  texture.image = image;
  s.shadings[0].textures = {texture};
  const Traced single = trace(s);
  multisample(s);
  const Traced many = trace(s);
  int inside = 0;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      for (int sample = 0; sample < kSamples; ++sample) {
        if (!many.hit(x, y, sample) || !single.hit(x, y)) continue;
        ++inside;
        EXPECT_LE(test::difference(many.color(x, y, sample), single.color(x, y)), 1)
            << x << ' ' << y << ' ' << sample;
      }
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(Multisample, CulledSurfacesShowTheOnesBehind) {
  auto s = makeSnapshot({makeMesh(test::squareData(0.5f)), makeMesh(test::squareData(-0.5f))}, kSampledSize);
  s.instances[0].cull = scene::CullFace::front;
  multisample(s);
  for (const float depth : trace(s).image.depth) ASSERT_FLOAT_EQ(depth, 0.75f);
  // The same with the alpha test, which the first surface fails.
  s.instances[0].cull = scene::CullFace::none;
  s.instances[0].color.a = 0.2f;
  s.shadings[0].alphaTest = {.function = scene::AlphaTest::greater, .reference = 0.5f};
  for (const float depth : trace(s).image.depth) ASSERT_FLOAT_EQ(depth, 0.75f);
}

TEST(Multisample, FixedFunctionIsClippedAtSamplesAndProgramsDiscardPixels) {
  auto s = makeSnapshot({makeMesh(test::squareData(0.5f)), makeMesh(test::squareData(-0.5f))}, kSampledSize);
  s.instances[0].clipPlanes = {{1, 0.3, 0, 0.01}};
  multisample(s);
  const auto mixed = [](const Traced& t) {
    int pixels = 0;
    for (int y = 0; y < kSampledSize; ++y) {
      for (int x = 0; x < kSampledSize; ++x) {
        int front = 0;
        for (int sample = 0; sample < kSamples; ++sample) {
          front += t.depth(x, y, sample) == 0.25f;
          EXPECT_TRUE(t.depth(x, y, sample) == 0.25f || t.depth(x, y, sample) == 0.75f);
        }
        pixels += front != 0 && front != kSamples;
      }
    }
    return pixels;
  };
  EXPECT_GT(mixed(trace(s)), 8);
  s.shadings[0].fragment.model = scene::FragmentShading::Model::unlit;
  EXPECT_EQ(mixed(trace(s)), 0);
  // The same with planes shared by all instances.
  s.instances[1].clipPlanes = s.instances[0].clipPlanes;
  const Traced traced = trace(s);
  for (int y = 0; y < kSampledSize; ++y)
    for (int x = 0; x < kSampledSize; ++x)
      for (int sample = 1; sample < kSamples; ++sample) ASSERT_EQ(traced.hit(x, y, sample), traced.hit(x, y));
}

TEST(Multisample, ProgramsThatWriteDepthGiveAllSamplesOneDepth) {
  auto s = makeSnapshot({makeMesh(ramp({{-1, -1, 0.9f}, {3, -1, -0.9f}, {-1, 3, 0.3f}}))}, kSampledSize);
  s.shadings[0].fragment.model = scene::FragmentShading::Model::unlit;
  s.shadings[0].fragment.writesDepth = true;
  const Traced single = trace(s);
  multisample(s);
  const Traced many = trace(s);
  for (int y = 0; y < kSampledSize; ++y)
    for (int x = 0; x < kSampledSize; ++x)
      for (int sample = 0; sample < kSamples; ++sample)
        ASSERT_NEAR(many.depth(x, y, sample), single.depth(x, y), 1.2e-7);
}

TEST(Multisample, EveryInstructionSetAgrees) {
  auto s = makeSnapshot({makeMesh(ramp({{-0.9f, -0.8f, 0.9f}, {0.7f, -0.45f, -0.7f}, {0.1f, 0.85f, 0.1f}})),
                         makeMesh(test::squareData(-0.1f))},
                        kSampledSize);
  multisample(s);
  const Traced best = trace(s);
  test::withEachTarget([&](int64_t) {
    const Traced other = trace(s);
    for (int sample = 0; sample < kSamples; ++sample)
      for (int y = 0; y < kSampledSize; ++y)
        for (int x = 0; x < kSampledSize; ++x) {
          ASSERT_NEAR(other.depth(x, y, sample), best.depth(x, y, sample), 1.2e-7);
          ASSERT_LE(test::difference(other.color(x, y, sample), best.color(x, y, sample)), 1);
        }
  });
}

}  // namespace
}  // namespace gluray
