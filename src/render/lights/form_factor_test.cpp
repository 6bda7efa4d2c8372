// Form factors against integrals computed plainly.
#include "render/lights/form_factor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::render {
namespace {

using scene::LightSource;
using Kind = LightSource::Kind;

/// The share of a fine grid of directions over the hemisphere, weighted by the cosine, that meet the light.
double counted(const LightSource& l, const glm::dvec3& p, const glm::dvec3& n) {
  constexpr int kSteps = 1000;
  const glm::dvec3 x = glm::normalize(
                       glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0))),
                   y = glm::cross(n, x), toMiddle = glm::dvec3(l.position) - p, facing(l.direction);
  int met = 0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double r = std::sqrt((i + 0.5) / kSteps), a = 2 * M_PI * (j + 0.5) / kSteps;
      const glm::dvec3 w = r * std::cos(a) * x + r * std::sin(a) * y + std::sqrt(1 - r * r) * n;
      if (l.kind == Kind::sphere) {
        const double along = glm::dot(w, toMiddle);
        met += along > 0 && glm::length(toMiddle - along * w) < l.radius;
        continue;
      }
      if (glm::dot(w, facing) >= 0 || glm::dot(toMiddle, facing) >= 0) continue;
      const glm::dvec3 at = w * (glm::dot(toMiddle, facing) / glm::dot(w, facing)) - toMiddle;
      const glm::dvec3 a0(l.halfEdge[0]), b0(l.halfEdge[1]);
      if (l.kind == Kind::disc)
        met += glm::length(at) < l.radius;
      else
        met += std::abs(glm::dot(at, a0)) < glm::dot(a0, a0) && std::abs(glm::dot(at, b0)) < glm::dot(b0, b0);
    }
  return double(met) / (kSteps * kSteps);
}

void expectCounted(const LightSource& l) {
  for (const glm::dvec3& p : {glm::dvec3(0), {1, 0.2, -0.5}, {-3, 2, 0.7}, {0.3, -0.2, 1.9}})
    for (const glm::dvec3& n : {glm::dvec3(0, 0, 1), {1, 0, 0}, {0.6, 0, -0.8}, {0, -0.8, 0.6}})
      EXPECT_NEAR(formFactor(l, glm::vec3(p), glm::vec3(n)), counted(l, p, n), 0.002)
          << p.x << ' ' << n.x << ' ' << n.y << ' ' << n.z;
}

TEST(FormFactor, OfRectangles) {
  LightSource l;
  l.kind = Kind::rectangle, l.position = {0.5f, 0.3f, 2};
  l.direction = {0, 0.6f, -0.8f};
  l.halfEdge[0] = {1.5f, 0, 0}, l.halfEdge[1] = {0, 0.8f, 0.6f};
  expectCounted(l);
}

TEST(FormFactor, OfDiscs) {
  LightSource l;
  l.kind = Kind::disc, l.position = {0.5f, 0.3f, 2}, l.radius = 1.5f;
  l.direction = {0, 0.6f, -0.8f};
  expectCounted(l);
}

TEST(FormFactor, OfSpheres) {
  LightSource l;
  l.kind = Kind::sphere, l.position = {0.5f, 0.3f, 3}, l.radius = 0.9f;
  expectCounted(l);
  EXPECT_EQ(formFactor(l, l.position, {0, 0, 1}), 1);
}

TEST(FormFactor, AtAnyScaleAndPlaceIsAShare) {
  for (const Kind kind : {Kind::rectangle, Kind::disc, Kind::sphere})
    for (const float scale : {1e-20f, 1.0f, 1e20f}) {
      LightSource l;
      l.kind = kind, l.radius = scale, l.position = {0, 0, scale};
      l.direction = {0, 0, -1};
      l.halfEdge[0] = {scale, 0, 0}, l.halfEdge[1] = {0, scale, 0};
      const float facing = formFactor(l, glm::vec3(0), {0, 0, 1});
      EXPECT_NEAR(facing, kind == Kind::rectangle ? 0.554f : kind == Kind::disc ? 0.5f : 1, 0.001f) << scale;
      for (const glm::vec3& p : {glm::vec3(0, 0, scale), {scale, scale, scale}, {0, 0, 0.999f * scale}}) {
        const float f = formFactor(l, p, {0, 0, 1});
        EXPECT_TRUE(f >= 0 && f <= 1) << f;
      }
    }
}

}  // namespace
}  // namespace gluray::render
