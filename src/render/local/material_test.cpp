// Colours and materials that vary over a mesh.
#include "render/testing/test_trace.h"

#include <gtest/gtest.h>

namespace gluray {
namespace {

using test::makeMesh;
using test::makeSnapshot;
using test::trace;

constexpr float kColorTolerance = 0.75f;  // of 255
const glm::vec4 kCornerRed(1, 0, 0, 1), kCornerGreen(0, 1, 0, 1), kCornerBlue(0, 0, 1, 1),
    kCornerGrey(0.5f, 0.5f, 0.5f, 0.5f);

test::MeshData coloredSquare() {
  test::MeshData data = test::squareData();
  data.normals.assign(4, {0, 0, 1});
  data.colors = {kCornerRed, kCornerGreen, kCornerBlue, kCornerGrey};
  return data;
}

// Value at pixel (x, y) of 16 x 16 of corner values interpolated over the square's two triangles.
glm::vec4 interpolated(const std::vector<glm::vec4>& c, int x, int y) {
  const float a = (static_cast<float>(x) + 0.5f) / 16, b = (static_cast<float>(y) + 0.5f) / 16;
  return a > b ? c[0] * (1 - a) + c[1] * (a - b) + c[2] * b : c[0] * (1 - b) + c[2] * a + c[3] * (b - a);
}

TEST(Color, UnlitColorsAreInterpolated) {
  const auto data = coloredSquare();
  const auto traced = trace(makeSnapshot({makeMesh(data)}));
  for (const auto& [x, y] : {std::pair(10, 4), std::pair(4, 10), std::pair(15, 0), std::pair(1, 14)}) {
    EXPECT_LE(test::difference(traced.color(x, y), interpolated(data.colors, x, y) * 255.0f),
              kColorTolerance);
  }
}

TEST(Color, FlatTakesTheLastVertex) {
  auto s = makeSnapshot({makeMesh(coloredSquare())});
  s.shadings[0].smooth = false;
  const auto traced = trace(s);
  EXPECT_EQ(traced.color(10, 4), kCornerBlue * 255.0f);
  EXPECT_EQ(traced.color(4, 10), glm::vec4(128, 128, 128, 128));
}

TEST(Color, BytesAndThreeFloats) {
  auto mesh = std::make_shared<scene::Mesh>(*makeMesh(test::squareData()));
  mesh->colors =
      test::makeAttribute<uint32_t>(std::vector<uint32_t>(4, 0x80C0FF40u), scene::Format::unorm8x4);
  EXPECT_EQ(trace(makeSnapshot({mesh})).color(5, 9), glm::vec4(0x40, 0xFF, 0xC0, 0x80));
  mesh = std::make_shared<scene::Mesh>(*mesh);
  mesh->colors =
      test::makeAttribute<glm::vec3>(std::vector<glm::vec3>(4, {0.2f, 2, -1}), scene::Format::float3);
  EXPECT_EQ(trace(makeSnapshot({mesh})).color(5, 9), glm::vec4(51, 255, 0, 255));
}

TEST(ColorMaterial, EachModeFollowsTheVertexColors) {
  using Mode = scene::ColorMaterial;
  auto s = makeSnapshot({makeMesh(coloredSquare())});
  s.shadings[0].lighting = true;
  s.shadings[0].globalAmbient = glm::vec4(0.5f, 0.5f, 0.5f, 1);
  s.shadings[0].lights.resize(1);
  s.shadings[0].lights[0].diffuse = glm::vec4(0.25f);
  s.shadings[0].lights[0].specular = glm::vec4(0.125f);
  scene::Material black;
  black.ambient = black.diffuse = glm::vec4(0, 0, 0, 1);
  s.instances[0].materials[0] = {black, black};
  const struct {
    Mode::Mode mode;
    float factor;  // of the colour that reaches the image
    bool alpha;
  } cases[] = {{Mode::emission, 1, false},
               {Mode::ambient, 0.5f, false},
               {Mode::diffuse, 0.25f, true},
               {Mode::specular, 0.125f, false},
               {Mode::ambientAndDiffuse, 0.75f, true}};
  for (const auto& c : cases) {
    for (const ShadingRate rate : {ShadingRate::pixel, ShadingRate::vertex}) {
      s.settings.shading = rate;
      s.shadings[0].colorMaterial = {c.mode, c.mode};
      const glm::vec4 color = interpolated(coloredSquare().colors, 10, 4);
      const glm::vec4 expected(glm::vec3(color) * c.factor, c.alpha ? color.a : 1.0f);
      EXPECT_LE(test::difference(trace(s).color(10, 4), expected * 255.0f), kColorTolerance) << c.mode;
    }
  }
}

TEST(ColorMaterial, ConstantColorWhereTheMeshHasNone) {
  test::MeshData data = test::squareData();
  data.normals.assign(4, {0, 0, 1});
  auto s = makeSnapshot({makeMesh(data)});
  s.shadings[0].lighting = true;
  s.shadings[0].globalAmbient = glm::vec4(0.5f);
  s.shadings[0].colorMaterial.front = scene::ColorMaterial::ambient;
  s.instances[0].color = {0.4f, 0.8f, 1, 1};
  EXPECT_EQ(trace(s).color(10, 4), glm::vec4(51, 102, 128, 255));
}

TEST(Materials, PerVertexIndices) {
  test::MeshData data = test::squareData();
  data.normals.assign(4, {0, 0, 1});
  data.materials = {0, 1, 2, 1};
  auto s = makeSnapshot({makeMesh(data)});
  s.shadings[0].lighting = true;
  s.instances[0].materials.resize(3);
  const glm::vec4 colors[] = {kCornerRed, kCornerGreen, kCornerBlue};
  for (size_t i = 0; i < 3; ++i) {
    auto& front = s.instances[0].materials[i].front;
    front.ambient = glm::vec4(0, 0, 0, 1);
    front.emission = colors[i];
  }
  const auto pixel = trace(s);
  EXPECT_EQ(pixel.color(10, 4), kCornerBlue * 255.0f);   // the last vertex of the first triangle
  EXPECT_EQ(pixel.color(4, 10), kCornerGreen * 255.0f);  // of the second
  s.settings.shading = ShadingRate::vertex;
  const auto vertex = trace(s);
  for (const auto& [x, y] : {std::pair(10, 4), std::pair(4, 10)}) {
    const glm::vec4 expected = interpolated({kCornerRed, kCornerGreen, kCornerBlue, kCornerGreen}, x, y);
    EXPECT_LE(test::difference(vertex.color(x, y), expected * 255.0f), kColorTolerance);
  }
}

TEST(Materials, IndicesBeyondTheTableTakeTheFirst) {
  test::MeshData data = test::squareData();
  data.materials.assign(4, 7);
  auto s = makeSnapshot({makeMesh(data)});
  s.shadings[0].lighting = true;
  s.instances[0].materials[0].front.emission = kCornerRed;
  EXPECT_EQ(trace(s).color(10, 4).r, 255);
}

TEST(Instances, EachHasItsOwnState) {
  const auto mesh = makeMesh(test::quadData({0, 0, 0}, {0.25f, 0, 0}, {0.25f, 0.25f, 0}, {0, 0.25f, 0}));
  auto s = makeSnapshot(std::vector<scene::MeshPtr>(16, mesh));
  // Sixteen instances within one packet of 4 x 4 pixels and its neighbours.
  for (int i = 0; i < 16; ++i) {
    auto& instance = s.instances[static_cast<size_t>(i)];
    instance.worldFromObject[3] = {i % 4 * 0.25f - 0.5f, i / 4 * 0.25f - 0.5f, 0, 1};
    instance.eyeFromObject = glm::dmat4(instance.worldFromObject);
    instance.color = glm::vec4(static_cast<float>(i) / 255, 0, 0, 1);
  }
  const auto traced = trace(s);
  for (int y = 4; y < 12; ++y) {
    for (int x = 4; x < 12; ++x) EXPECT_EQ(traced.color(x, y).r, (x - 4) / 2 + (y - 4) / 2 * 4);
  }
  EXPECT_FALSE(traced.hit(3, 3));
}

}  // namespace
}  // namespace gluray
