// The lighting equation against closed-form values and a transcription of the specification.
#include "render/testing/reference_light.h"
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace gluray {
namespace {

using test::makeMesh;
using test::makeSnapshot;
using test::trace;
using test::Traced;

constexpr float kTolerance = 0.75f;  // of 255: rounding to bytes, and float against double

// A square at z = -5 in front of a perspective camera, with four equal normals.
scene::Snapshot litScene(const glm::vec3& normal, ShadingRate rate = ShadingRate::pixel) {
  test::MeshData data = test::quadData({-4, -4, -5}, {4, -4, -5}, {4, 4, -5}, {-4, 4, -5});
  data.normals.assign(4, normal);
  auto s = makeSnapshot({makeMesh(data)}, 32);
  s.camera.clipFromEye = glm::perspective(1.2, 1.0, 1.0, 10.0);
  s.settings.shading = rate;
  s.shadings[0].lighting = true;
  s.shadings[0].lights.resize(1);
  s.shadings[0].lights[0].diffuse = glm::vec4(1);
  return s;
}

// Eye-space point on z = -5 in the middle of a pixel of litScene.
glm::dvec3 pointAt(int x, int y) {
  const double k = 5 * std::tan(0.6) / 16;
  return {(x - 15.5) * k, (y - 15.5) * k, -5};
}

void expectReference(const scene::Snapshot& s, const glm::dvec3& unitNormal) {
  const Traced traced = trace(s);
  for (const auto& [x, y] : {std::pair(16, 16), std::pair(3, 7), std::pair(28, 20), std::pair(10, 30)}) {
    const auto lit =
        test::referenceLight(s.shadings[0], s.instances[0].materials[0].front, pointAt(x, y), unitNormal);
    const glm::vec4 expected = test::referenceColor(lit);
    ASSERT_LE(test::difference(traced.color(x, y), expected), kTolerance)
        << x << ' ' << y << ": red " << traced.color(x, y).r << ", expected " << expected.r;
  }
}

TEST(Lighting, DirectionalLight) {
  auto s = litScene({0, 0, 1});
  s.shadings[0].lights[0].position = {0, std::sqrt(3.0f), 1, 0};  // 60 degrees off the normal
  // 0.2 * 0.2 global ambient + 0.8 * cos 60 = 0.44, of 255: 112.2.
  EXPECT_EQ(trace(s).color(16, 16), glm::vec4(112, 112, 112, 255));
}

TEST(Lighting, BehindIsAmbientOnly) {
  auto s = litScene({0, 0, -1});
  EXPECT_EQ(trace(s).color(16, 16), glm::vec4(10, 10, 10, 255));  // 0.04 * 255 = 10.2
}

TEST(Lighting, AlphaIsTheDiffuseMaterials) {
  auto s = litScene({0, 0, 1});
  s.instances[0].materials[0].front.diffuse.a = 0.2f;
  EXPECT_EQ(trace(s).color(16, 16).a, 51);
}

struct Case {
  std::string name;
  std::function<void(scene::Shading&, scene::Material&)> edit;
};

const Case kCases[] = {
    {"directional",
     [](scene::Shading& s, scene::Material&) {
       s.lights[0].position = {1, 2, 3, 0};
     }},
    {"ambient and emission",
     [](scene::Shading& s, scene::Material& m) {
       s.globalAmbient = {0.1f, 0.5f, 0.3f, 1};
       s.lights[0].ambient = {0.3f, 0, 0.2f, 1};
       m.ambient = {0.9f, 0.3f, 0.1f, 1};
       m.emission = {0, 0.1f, 0.2f, 1};
     }},
    {"specular, infinite viewer",
     [](scene::Shading& s, scene::Material& m) {
       s.lights[0].position = {1, 0.3f, 2, 0};
       s.lights[0].specular = {1, 0.5f, 0.2f, 1};
       m.specular = {0.7f, 0.8f, 0.9f, 1};
       m.shininess = 7;
     }},
    {"specular, local viewer",
     [](scene::Shading& s, scene::Material& m) {
       s.localViewer = true;
       s.lights[0].position = {0.2f, 0.3f, 2, 0};
       s.lights[0].specular = glm::vec4(1);
       m.specular = glm::vec4(0.8f);
       m.shininess = 30;
     }},
    {"shininess 0",
     [](scene::Shading& s, scene::Material& m) {
       s.lights[0].position = {0, 1, 0.2f, 0};
       s.lights[0].specular = glm::vec4(0.5f);
       m.specular = glm::vec4(0.6f);
     }},
    {"positional",
     [](scene::Shading& s, scene::Material& m) {
       s.lights[0].position = {4, -2, -4, 2};
       s.lights[0].specular = glm::vec4(0.5f);
       m.specular = glm::vec4(0.6f);
       m.shininess = 12;
     }},
    {"attenuation",
     [](scene::Shading& s, scene::Material&) {
       s.lights[0].position = {1, -1, -3, 1};
       s.lights[0].attenuation = {0.5f, 0.25f, 0.1f};
     }},
    {"spot",
     [](scene::Shading& s, scene::Material&) {
       s.lights[0].position = {0.3f, -0.2f, -2, 1};
       s.lights[0].spotDirection = {0, 0.5f, -2};
       s.lights[0].spotCutoff = 35;
       s.lights[0].spotExponent = 4;
     }},
    {"spot of a directional light",
     [](scene::Shading& s, scene::Material&) {
       s.lights[0].position = {0, 1, 2, 0};
       s.lights[0].spotDirection = {0, -0.2f, -1};
       s.lights[0].spotCutoff = 60;
       s.lights[0].spotExponent = 2;
     }},
    {"three lights",
     [](scene::Shading& s, scene::Material& m) {
       s.lights.resize(3);
       s.lights[1].position = {-1, 0, 1, 0};
       s.lights[1].diffuse = {0, 0.3f, 0.6f, 1};
       s.lights[2].position = {0, 3, 0, 1};
       s.lights[2].diffuse = {0.4f, 0, 0, 1};
       s.lights[2].specular = {0.1f, 0.2f, 0.3f, 1};
       m.specular = glm::vec4(1);
       m.shininess = 128;
     }},
    {"separate specular",
     [](scene::Shading& s, scene::Material& m) {
       s.separateSpecular = true;
       s.lights[0].diffuse = s.lights[0].specular = glm::vec4(2);
       m.specular = {0.5f, 0.1f, 0, 1};
       m.shininess = 3;
     }},
};

TEST(Lighting, EveryLightKindMatchesTheSpecification) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, -0.3, 1));
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    auto s = litScene(glm::vec3(normal));
    c.edit(s.shadings[0], s.instances[0].materials[0].front);
    expectReference(s, normal);
  }
}

TEST(Lighting, PerVertexInterpolatesTheCorners) {
  auto s = litScene({0, 0, 1}, ShadingRate::vertex);
  s.shadings[0].lights[0].position = {3, 2, -4.5f, 1};
  const Traced traced = trace(s);
  const auto& m = s.instances[0].materials[0].front;
  const auto corner = [&](double x, double y) {
    return test::referenceColor(test::referenceLight(s.shadings[0], m, {x, y, -5}, {0, 0, 1}));
  };
  for (const auto& [x, y] : {std::pair(20, 9), std::pair(9, 20)}) {
    const glm::dvec3 p = pointAt(x, y);
    const float a = static_cast<float>((p.x + 4) / 8), b = static_cast<float>((p.y + 4) / 8);
    // Below the diagonal the triangle (-,-) (+,-) (+,+), above it (-,-) (+,+) (-,+).
    const glm::vec4 expected = a > b ? corner(-4, -4) * (1 - a) + corner(4, -4) * (a - b) + corner(4, 4) * b
                                     : corner(-4, -4) * (1 - b) + corner(4, 4) * a + corner(-4, 4) * (b - a);
    EXPECT_LE(test::difference(traced.color(x, y), expected), kTolerance);
  }
}

TEST(Lighting, FlatTakesTheLastVertex) {
  for (const ShadingRate rate : {ShadingRate::pixel, ShadingRate::vertex}) {
    auto s = litScene({0, 0, 1}, rate);
    s.shadings[0].smooth = false;
    s.shadings[0].lights[0].position = {3, 2, -4.5f, 1};
    const Traced traced = trace(s);
    const auto& m = s.instances[0].materials[0].front;
    const auto corner = [&](double x, double y) {
      return test::referenceColor(test::referenceLight(s.shadings[0], m, {x, y, -5}, {0, 0, 1}));
    };
    EXPECT_LE(test::difference(traced.color(20, 9), corner(4, 4)), kTolerance);
    EXPECT_LE(test::difference(traced.color(9, 20), corner(-4, 4)), kTolerance);
  }
}

TEST(Lighting, TwoSidedUsesTheBackMaterial) {
  auto s = litScene({0, 0, 1});
  auto& instance = s.instances[0];
  instance.materials[0].back.diffuse = {0, 1, 0, 1};
  instance.frontFaceCcw = false;                                     // the viewer sees the back
  EXPECT_EQ(trace(s).color(16, 16), glm::vec4(214, 214, 214, 255));  // one-sided: front material, 0.84
  s.shadings[0].twoSided = true;
  EXPECT_EQ(trace(s).color(16, 16), glm::vec4(10, 10, 10, 255));  // normal reversed: away from the light
  s.shadings[0].lights[0].position = {0, 0, -1, 0};
  EXPECT_EQ(trace(s).color(16, 16), glm::vec4(10, 255, 10, 255));
}

TEST(Lighting, NormalsThroughScaledModelviews) {
  const glm::vec3 normal = glm::normalize(glm::vec3(1, 2, 2));
  auto s = litScene(normal);
  const glm::dmat4 modelview = glm::scale(glm::dmat4(1), {2, 2, 2});
  s.eyeFromWorld = s.instances[0].eyeFromObject = modelview;
  s.camera.clipFromEye = s.camera.clipFromEye * glm::inverse(modelview);  // keeps the image
  const auto red = [&] { return trace(s).color(16, 16).r; };
  const float ambient = 0.04f * 255, diffuse = 0.8f * 255 * 2 / 3;
  EXPECT_NEAR(red(), ambient + diffuse / 2, kTolerance);  // raw: the inverse transpose halves the normal
  s.shadings[0].rescaleNormal = true;
  EXPECT_NEAR(red(), ambient + diffuse, kTolerance);
  s.shadings[0].rescaleNormal = false;
  s.shadings[0].normalize = true;
  EXPECT_NEAR(red(), ambient + diffuse, kTolerance);
}

TEST(Lighting, NormalsFollowTheInverseTranspose) {
  auto s = litScene({0, 1, 1});
  s.shadings[0].normalize = true;
  const glm::dmat4 modelview = glm::scale(glm::dmat4(1), {1, 2, 1});
  s.eyeFromWorld = s.instances[0].eyeFromObject = modelview;
  s.camera.clipFromEye = s.camera.clipFromEye * glm::inverse(modelview);
  const float cosine = 1 / std::sqrt(1.25f);  // (0, 1/2, 1)
  EXPECT_NEAR(trace(s).color(16, 16).r, (0.04f + 0.8f * cosine) * 255, kTolerance);
}

TEST(Lighting, RawNormalsKeepTheirLength) {
  auto s = litScene({0, 0, 0.5f});
  EXPECT_NEAR(trace(s).color(16, 16).r, (0.04f + 0.4f) * 255, kTolerance);
}

TEST(Lighting, ConstantNormalWhereTheMeshHasNone) {
  auto s = litScene({0, 0, 1});
  s.instances[0].mesh = makeMesh(test::quadData({-4, -4, -5}, {4, -4, -5}, {4, 4, -5}, {-4, 4, -5}));
  s.instances[0].normal = {0, 0.6f, 0.8f};
  EXPECT_NEAR(trace(s).color(16, 16).r, (0.04f + 0.64f) * 255, kTolerance);
}

}  // namespace
}  // namespace gluray
