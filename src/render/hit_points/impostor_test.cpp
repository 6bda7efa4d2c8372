// Images of impostors against closed forms, and equal results of every instruction set.
#include "render/kernels/kernels.h"
#include "render/testing/test_targets.h"
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gluray {
namespace {

using scene::Shape;

constexpr int kImpostorSize = 65;

scene::MeshPtr impostors(Shape shape) {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->shape = shape;
  mesh->triangleCount = mesh->vertexCount = 3;
  mesh->positions =
      test::makeAttribute<glm::vec3>({{0, 0, -5}, {1, 0.5f, -7}, {-1.2f, -0.8f, -4}}, scene::Format::float3);
  mesh->radii = test::makeAttribute<float>({1, 1.5f, 0.4f}, scene::Format::float1);
  mesh->axes =
      test::makeAttribute<glm::vec3>({{1, 0.3f, 1}, {0, 2, 0.4f}, {1, -1, 0}}, scene::Format::float3);
  mesh->colors = test::makeAttribute<glm::vec4>({{1, 0.5f, 0.2f, 1}, {0, 1, 0, 1}, {0.3f, 0.3f, 1, 1}},
                                                scene::Format::float4);
  const auto form = static_cast<int>(shape);
  mesh->geometryId = hashBytes(&form, sizeof form);
  return mesh;
}

scene::Snapshot snapshotOf(Shape shape) {
  scene::Snapshot s = test::makeSnapshot({impostors(shape)}, kImpostorSize);
  s.camera.clipFromEye = glm::perspective(glm::radians(50.0), 1.0, 1.0, 20.0);
  scene::FragmentShading& f = s.shadings[0].fragment;
  f.model = scene::FragmentShading::Model::phong;
  f.color = scene::FragmentShading::Color::vertices;
  f.lights.resize(1);
  f.lights[0].kind = scene::FragmentLight::directional;
  f.lights[0].direction = glm::normalize(glm::vec3(-1, -2, -3));
  scene::Material& m = s.instances[0].materials[0].front;
  m = {};
  m.ambient = glm::vec4(0.1f), m.diffuse = glm::vec4(0.9f, 0.9f, 0.9f, 1);
  return s;
}

TEST(Impostor, SphereDepthAndLightMatchTheEquation) {
  const scene::Snapshot s = snapshotOf(Shape::spheres);
  const test::Traced traced = test::trace(s);
  const scene::Mesh& mesh = *s.instances[0].mesh;
  int hits = 0;
  for (int y = 0; y < kImpostorSize; ++y) {
    for (int x = 0; x < kImpostorSize; ++x) {
      const double scale = std::tan(glm::radians(25.0));
      const glm::dvec3 d = glm::normalize(glm::dvec3(scale * ((x + 0.5) / kImpostorSize * 2 - 1),
                                                     scale * ((y + 0.5) / kImpostorSize * 2 - 1), -1));
      double nearest = INFINITY;
      uint32_t which = 0;
      bool edge = false;
      for (uint32_t k = 0; k < 3; ++k) {
        const glm::dvec3 c(mesh.position(k));
        const double r = scene::fetch(mesh.radii, k).x, b = glm::dot(c, d),
                     q = b * b - glm::dot(c, c) + r * r;
        edge = edge || std::abs(q) < 1e-4;
        if (q >= 0 && b - std::sqrt(q) < nearest) nearest = b - std::sqrt(q), which = k;
      }
      if (edge) continue;
      ASSERT_EQ(traced.hit(x, y), nearest < 100) << x << " " << y;
      if (nearest > 100) continue;
      ++hits;
      const glm::dvec3 p = nearest * d;
      const glm::dvec4 clip = s.camera.clipFromEye * glm::dvec4(p, 1);
      EXPECT_NEAR(traced.depth(x, y), 0.5 + 0.5 * clip.z / clip.w, 1e-6);
      const glm::dvec3 n = glm::normalize(p - glm::dvec3(mesh.position(which)));
      const double cosine =
          std::max(0.0, -glm::dot(n, glm::dvec3(s.shadings[0].fragment.lights[0].direction)));
      const glm::vec4 color =
          scene::fetch(mesh.colors, which) * static_cast<float>(255 * (0.1 + 0.9 * cosine));
      EXPECT_LT(glm::length(glm::vec3(traced.color(x, y)) - glm::min(glm::vec3(color), glm::vec3(255))),
                1.5f);
    }
  }
  EXPECT_GT(hits, 500);
}

/// Half spheres that are seen along -z, and lit with highlights in the complement of their colour.
scene::Snapshot halfSpheres() {
  scene::Snapshot s = snapshotOf(Shape::spheres);
  s.instances[0].impostors.billboards = scene::Impostors::Billboards::square;
  s.instances[0].impostors.hemispheres = true;
  scene::FragmentShading& f = s.shadings[0].fragment;
  f.specular = scene::FragmentShading::Specular::half;
  f.infiniteViewer = f.highlightsInDark = true;
  f.highlightColor = scene::FragmentShading::HighlightColor::complement;
  s.instances[0].materials[0].front.specular = glm::vec4(0.5f);
  s.instances[0].materials[0].front.shininess = 7;
  return s;
}

TEST(Impostor, HemisphereDepthAndLightMatchTheEquation) {
  const scene::Snapshot s = halfSpheres();
  const test::Traced traced = test::trace(s);
  const scene::Mesh& mesh = *s.instances[0].mesh;
  const glm::dvec3 light = -glm::dvec3(s.shadings[0].fragment.lights[0].direction);
  const glm::dvec3 half = glm::normalize(light + glm::dvec3(0, 0, 1));
  int hits = 0;
  for (int y = 0; y < kImpostorSize; ++y) {
    for (int x = 0; x < kImpostorSize; ++x) {
      const double scale = std::tan(glm::radians(25.0));
      const glm::dvec2 slope(scale * ((x + 0.5) / kImpostorSize * 2 - 1),
                             scale * ((y + 0.5) / kImpostorSize * 2 - 1));
      double nearest = -INFINITY;
      uint32_t which = 0;
      glm::dvec3 n(0);
      bool edge = false;
      for (uint32_t k = 0; k < 3; ++k) {
        const glm::dvec3 c(mesh.position(k));
        const double r = scene::fetch(mesh.radii, k).x;
        const glm::dvec2 on = (slope * -c.z - glm::dvec2(c)) / r;
        const double open = 1 - glm::dot(on, on);
        edge = edge || std::abs(open) < 1e-4;
        if (open <= 0 || c.z + r * std::sqrt(open) <= nearest) continue;
        nearest = c.z + r * std::sqrt(open), which = k, n = {on, std::sqrt(open)};
      }
      if (edge) continue;
      ASSERT_EQ(traced.hit(x, y), std::isfinite(nearest)) << x << " " << y;
      if (!std::isfinite(nearest)) continue;
      ++hits;
      const glm::dvec4 clip = s.camera.clipFromEye * glm::dvec4(0, 0, nearest, 1);
      EXPECT_NEAR(traced.depth(x, y), 0.5 + 0.5 * clip.z / clip.w, 1e-6);
      const glm::dvec3 base(scene::fetch(mesh.colors, which));
      const glm::dvec3 color = base * (0.1 + 0.9 * std::max(0.0, glm::dot(n, light))) +
                               (1.0 - base) * 0.5 * std::pow(std::max(0.0, glm::dot(n, half)), 7);
      const glm::vec3 bytes(glm::min(255.0 * color, glm::dvec3(255)));
      EXPECT_LT(glm::length(glm::vec3(traced.color(x, y)) - bytes), 1.5f);
    }
  }
  EXPECT_GT(hits, 500);
}

TEST(Impostor, OneColourAndDepthInAllSamplesOfAPixel) {
  scene::Snapshot s = snapshotOf(Shape::spheres);
  const test::Traced one = test::trace(s);
  s.samples = 4;
  s.samplePositions = {{0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}};
  const test::Traced many = test::trace(s);
  int differing = 0, hits = 0;
  for (int sample = 0; sample < 4; ++sample) {
    for (int y = 0; y < kImpostorSize; ++y) {
      for (int x = 0; x < kImpostorSize; ++x) {
        hits += one.hit(x, y);
        differing += one.hit(x, y) != many.hit(x, y, sample) || one.color(x, y) != many.color(x, y, sample) ||
                     one.depth(x, y) != many.depth(x, y, sample);
      }
    }
  }
  EXPECT_GT(hits, 2000);
  // At silhouettes a sample's ray may miss the bounding box of an impostor that the pixel's centre shows.
  EXPECT_LT(differing, hits / 100);
}

void expectEachTargetAgrees(const scene::Snapshot& s) {
  const test::Traced best = test::trace(s);
  test::withEachTarget([&](int64_t) {
    SCOPED_TRACE(render::kernelTarget());
    const test::Traced traced = test::trace(s);
    int differing = 0, hits = 0;
    for (int y = 0; y < kImpostorSize; ++y) {
      for (int x = 0; x < kImpostorSize; ++x) {
        hits += best.hit(x, y);
        if (traced.hit(x, y) != best.hit(x, y)) {
          ++differing;
        } else if (best.hit(x, y)) {
          EXPECT_NEAR(traced.depth(x, y), best.depth(x, y), 1.2e-7);
          EXPECT_LE(test::difference(traced.color(x, y), best.color(x, y)), 1);
        }
      }
    }
    EXPECT_GT(hits, 100);
    EXPECT_LE(differing, 1) << "fused multiply-adds decide otherwise on a silhouette";
  });
}

TEST(Impostor, EveryInstructionSetAgrees) {
  for (const Shape shape : {Shape::spheres, Shape::discs, Shape::cylinders}) {
    for (const auto billboards :
         {scene::Impostors::Billboards::silhouette, scene::Impostors::Billboards::triangle}) {
      scene::Snapshot s = snapshotOf(shape);
      s.instances[0].impostors.billboards =
          shape == Shape::cylinders && billboards == scene::Impostors::Billboards::triangle
              ? scene::Impostors::Billboards::faces
              : billboards;
      s.instances[0].impostors.fades = true;
      expectEachTargetAgrees(s);
    }
  }
  expectEachTargetAgrees(halfSpheres());
}

}  // namespace
}  // namespace gluray
