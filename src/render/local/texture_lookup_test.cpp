// Texture sampling and environments against analytic values.
#include "render/local/texture_lookup.h"

#include "render/local/combine.h"
#include "render/local/mipmap.h"
#include "render/testing/test_trace.h"

#include <gtest/gtest.h>

namespace gluray {
namespace {

using scene::BaseFormat;
using scene::Filter;
using scene::TexEnv;
using scene::Wrap;

uint32_t texel(uint32_t red, uint32_t alpha = 255) { return red | red << 8 | red << 16 | alpha << 24; }

// Four texels 0, 85, 170, 255 in a row, one or two rows of them.
scene::Texture ramp(Wrap wrap, int height = 1) {
  auto image = std::make_shared<scene::TextureImage>();
  image->width = 4, image->height = height;
  for (int y = 0; y < height; ++y) {
    for (const uint32_t red : {0u, 85u, 170u, 255u}) image->texels.push_back(texel(y ? 255 - red : red));
  }
  scene::Texture t;
  t.image = image;
  t.target = height > 1 ? scene::TextureTarget::texture2D : scene::TextureTarget::texture1D;
  t.wrapS = t.wrapT = wrap;
  t.borderColor = {0.9f, 0.9f, 0.9f, 1};
  return t;
}

float red(const scene::Texture& t, Filter filter, float s, float y = 0) {
  return render::sampleLevel(t, *t.image, filter, {s, y, 0}).r * 3;  // in steps of the ramp
}

TEST(Texture, NearestWraps) {
  const auto nearest = [](Wrap wrap, float s) { return red(ramp(wrap), Filter::nearest, s); };
  EXPECT_FLOAT_EQ(nearest(Wrap::repeat, 0.3f), 1);
  EXPECT_FLOAT_EQ(nearest(Wrap::repeat, 1.3f), 1);
  EXPECT_FLOAT_EQ(nearest(Wrap::repeat, -0.1f), 3);
  for (const Wrap wrap : {Wrap::clamp, Wrap::clampToEdge}) {
    EXPECT_FLOAT_EQ(nearest(wrap, -2), 0);
    EXPECT_FLOAT_EQ(nearest(wrap, 5), 3);
    EXPECT_FLOAT_EQ(nearest(wrap, 1), 3);
  }
  EXPECT_FLOAT_EQ(nearest(Wrap::clampToBorder, -0.1f), 2.7f);
  EXPECT_FLOAT_EQ(nearest(Wrap::clampToBorder, 1.1f), 2.7f);
  EXPECT_FLOAT_EQ(nearest(Wrap::mirroredRepeat, 1.1f), 3);
  EXPECT_FLOAT_EQ(nearest(Wrap::mirroredRepeat, 1.9f), 0);
  EXPECT_FLOAT_EQ(nearest(Wrap::mirroredRepeat, -0.3f), 1);
}

TEST(Texture, LinearWraps) {
  const auto linear = [](Wrap wrap, float s) { return red(ramp(wrap), Filter::linear, s); };
  constexpr float kTolerance = 1e-5f;
  EXPECT_NEAR(linear(Wrap::repeat, 0.5f), 1.5f, kTolerance);
  EXPECT_NEAR(linear(Wrap::repeat, 0), 1.5f, kTolerance);  // between the last texel and the first
  EXPECT_NEAR(linear(Wrap::repeat, 7.375f), 1, kTolerance);
  EXPECT_NEAR(linear(Wrap::clamp, -3), 0.5f * 2.7f, kTolerance);  // half border, half edge
  EXPECT_NEAR(linear(Wrap::clamp, 3), 0.5f * (3 + 2.7f), kTolerance);
  EXPECT_NEAR(linear(Wrap::clampToEdge, -3), 0, kTolerance);
  EXPECT_NEAR(linear(Wrap::clampToEdge, 3), 3, kTolerance);
  EXPECT_NEAR(linear(Wrap::clampToBorder, -3), 2.7f, kTolerance);
  EXPECT_NEAR(linear(Wrap::mirroredRepeat, 1), 3, kTolerance);
  EXPECT_NEAR(linear(Wrap::mirroredRepeat, 1.5f), 1.5f, kTolerance);
}

TEST(Texture, LinearInTwoDimensions) {
  const auto t = ramp(Wrap::clampToEdge, 2);
  EXPECT_NEAR(red(t, Filter::linear, 0.125f, 0.5f), 1.5f, 1e-5f);
  EXPECT_NEAR(red(t, Filter::linear, 0.5f, 0.25f), 1.5f, 1e-5f);
  EXPECT_NEAR(red(t, Filter::linear, 0.875f, 0.9f), 0, 1e-5f);
}

TEST(Texture, BorderTakesTheBaseFormat) {
  auto t = ramp(Wrap::clampToBorder);
  t.borderColor = {0.1f, 0.2f, 0.3f, 0.4f};
  const auto border = [&](BaseFormat format) {
    auto image = std::make_shared<scene::TextureImage>(*t.image);
    image->baseFormat = format;
    t.image = image;
    return render::sampleLevel(t, *t.image, Filter::nearest, {-1, 0, 0});
  };
  EXPECT_LE(test::difference(border(BaseFormat::alpha), glm::vec4(0, 0, 0, 0.4f)), 1e-6f);
  EXPECT_LE(test::difference(border(BaseFormat::luminance), glm::vec4(0.1f, 0.1f, 0.1f, 1)), 1e-6f);
  EXPECT_LE(test::difference(border(BaseFormat::luminanceAlpha), glm::vec4(0.1f, 0.1f, 0.1f, 0.4f)), 1e-6f);
  EXPECT_LE(test::difference(border(BaseFormat::intensity), glm::vec4(0.1f)), 1e-6f);
  EXPECT_LE(test::difference(border(BaseFormat::rgb), glm::vec4(0.1f, 0.2f, 0.3f, 1)), 1e-6f);
  EXPECT_LE(test::difference(border(BaseFormat::rgba), t.borderColor), 1e-6f);
}

// GL 2.1, tables 3.22 and 3.23, row by row.
TEST(Texture, Environments) {
  const glm::vec4 cf(0.5f, 0.25f, 0.75f, 0.5f), cs(0.2f, 0.4f, 0.8f, 0.25f), cc(0.1f, 0.3f, 0.5f, 0.7f);
  const glm::vec3 f(cf), s(cs), c(cc);
  const float af = cf.a, as = cs.a;
  const struct {
    TexEnv env;
    BaseFormat format;
    glm::vec4 expected;
  } rows[] = {
      {TexEnv::replace, BaseFormat::alpha, {f, as}},
      {TexEnv::replace, BaseFormat::luminance, {s, af}},
      {TexEnv::replace, BaseFormat::luminanceAlpha, {s, as}},
      {TexEnv::replace, BaseFormat::intensity, {s, as}},
      {TexEnv::replace, BaseFormat::rgb, {s, af}},
      {TexEnv::replace, BaseFormat::rgba, {s, as}},
      {TexEnv::modulate, BaseFormat::alpha, {f, af * as}},
      {TexEnv::modulate, BaseFormat::luminance, {f * s, af}},
      {TexEnv::modulate, BaseFormat::luminanceAlpha, {f * s, af * as}},
      {TexEnv::modulate, BaseFormat::intensity, {f * s, af * as}},
      {TexEnv::modulate, BaseFormat::rgb, {f * s, af}},
      {TexEnv::modulate, BaseFormat::rgba, {f * s, af * as}},
      {TexEnv::decal, BaseFormat::alpha, {f, af}},
      {TexEnv::decal, BaseFormat::luminance, {f, af}},
      {TexEnv::decal, BaseFormat::luminanceAlpha, {f, af}},
      {TexEnv::decal, BaseFormat::intensity, {f, af}},
      {TexEnv::decal, BaseFormat::rgb, {s, af}},
      {TexEnv::decal, BaseFormat::rgba, {f * (1 - as) + s * as, af}},
      {TexEnv::blend, BaseFormat::alpha, {f, af * as}},
      {TexEnv::blend, BaseFormat::luminance, {f * (1.0f - s) + c * s, af}},
      {TexEnv::blend, BaseFormat::luminanceAlpha, {f * (1.0f - s) + c * s, af * as}},
      {TexEnv::blend, BaseFormat::intensity, {f * (1.0f - s) + c * s, af * (1 - as) + cc.a * as}},
      {TexEnv::blend, BaseFormat::rgb, {f * (1.0f - s) + c * s, af}},
      {TexEnv::blend, BaseFormat::rgba, {f * (1.0f - s) + c * s, af * as}},
      {TexEnv::add, BaseFormat::alpha, {f, af * as}},
      {TexEnv::add, BaseFormat::luminance, {f + s, af}},
      {TexEnv::add, BaseFormat::luminanceAlpha, {f + s, af * as}},
      {TexEnv::add, BaseFormat::intensity, {f + s, af + as}},
      {TexEnv::add, BaseFormat::rgb, {f + s, af}},
      {TexEnv::add, BaseFormat::rgba, {f + s, af * as}},
  };
  for (const auto& row : rows) {
    auto image = std::make_shared<scene::TextureImage>();
    image->baseFormat = row.format;
    scene::Texture t;
    t.image = image;
    t.env = row.env;
    t.envColor = cc;
    render::CombineInputs in;
    in.texels[0] = cs;
    EXPECT_LE(test::difference(render::applyEnvironment(t, in, cf), row.expected), 1e-6f)
        << static_cast<int>(row.env) << ' ' << static_cast<int>(row.format);
  }
}

// The square with (s, t) = (0, 0) .. (extent, extent), 16 pixels.
scene::Snapshot texturedScene(const scene::Texture& t, float extent) {
  test::MeshData data = test::squareData();
  data.texcoords = {{0, 0, 0, 1}, {extent, 0, 0, 1}, {extent, extent, 0, 1}, {0, extent, 0, 1}};
  auto s = test::makeSnapshot({test::makeMesh(data)});
  s.shadings[0].textures = {t};
  return s;
}

TEST(Texture, OnPixels) {
  auto t = ramp(Wrap::repeat);
  t.minFilter = t.magFilter = Filter::nearest;
  const auto traced = test::trace(texturedScene(t, 1));
  for (int x = 0; x < 16; ++x) EXPECT_EQ(traced.color(x, 7).r, 85 * (x / 4));
}

TEST(Texture, MatrixAndQ) {
  auto t = ramp(Wrap::repeat);
  t.minFilter = t.magFilter = Filter::nearest;
  t.textureMatrix[3] = {0.5f, 0, 0, 1};  // half the width to the left
  EXPECT_EQ(test::trace(texturedScene(t, 1)).color(1, 7).r, 170);
  t.textureMatrix = glm::mat4(1);
  t.textureMatrix[3][3] = 2;
  EXPECT_EQ(test::trace(texturedScene(t, 1)).color(9, 7).r, 85);  // s/q runs half as fast
}

TEST(Texture, FilterByFootprint) {
  auto t = ramp(Wrap::repeat);
  t.magFilter = Filter::nearest;
  t.minFilter = Filter::linear;
  // At extent 1 a pixel is a quarter of a texel, at extent 8 two texels: x = 0.25 is then texel 0.5, x = 1.25
  // texel 2.5.
  EXPECT_EQ(test::trace(texturedScene(t, 1)).color(6, 7).r, 85);
  const auto minified = test::trace(texturedScene(t, 8));
  EXPECT_NEAR(minified.color(0, 7).r, 42.5f, 0.6f);
  EXPECT_NEAR(minified.color(1, 7).r, 212.5f, 0.6f);
}

// Unit 1 multiplies by its own texture, whose coordinates the mesh carries or the instance gives.
TEST(Texture, TwoUnits) {
  auto t = ramp(Wrap::repeat);
  t.minFilter = t.magFilter = Filter::nearest;
  auto second = t;
  second.unit = 1;
  auto s = texturedScene(t, 1);
  s.shadings[0].textures.push_back(second);
  s.instances[0].texcoordsAbove = {{0.6f, 0, 0, 1}};  // texel 170
  EXPECT_NEAR(test::trace(s).color(6, 7).r, 85.0f * 170 / 255, 0.6f);
  auto mesh = std::make_shared<scene::Mesh>(*s.instances[0].mesh);
  mesh->texcoordsAbove = {
      test::makeAttribute<glm::vec2>({{1, 0}, {0, 0}, {0, 0}, {1, 0}}, scene::Format::float2)};
  s.instances[0].mesh = mesh;
  const auto traced = test::trace(s);  // the second runs from right to left
  for (int x = 0; x < 16; ++x) {
    const int i = x / 4;
    EXPECT_NEAR(traced.color(x, 7).r, 85.0f * static_cast<float>(i * (3 - i)) * 85 / 255, 0.6f);
  }
}

TEST(Texture, ThreeDimensions) {
  auto image = std::make_shared<scene::TextureImage>();
  image->width = image->height = 1, image->depth = 4;
  image->texels = {texel(0), texel(85), texel(170), texel(255)};
  scene::Texture t;
  t.image = image;
  t.target = scene::TextureTarget::texture3D;
  t.wrapR = Wrap::clampToEdge;
  const auto at = [&](Filter filter, float r) {
    return render::sampleLevel(t, *t.image, filter, {0.5f, 0.5f, r}).r * 3;
  };
  EXPECT_FLOAT_EQ(at(Filter::nearest, 0.6f), 2);
  EXPECT_NEAR(at(Filter::linear, 0.5f), 1.5f, 1e-5f);
  EXPECT_NEAR(at(Filter::linear, 7), 3, 1e-5f);
}

TEST(Texture, MirroredOnce) {
  const auto nearest = [](Wrap wrap, float s) { return red(ramp(wrap), Filter::nearest, s); };
  for (const Wrap wrap : {Wrap::mirrorClamp, Wrap::mirrorClampToEdge, Wrap::mirrorClampToBorder}) {
    EXPECT_FLOAT_EQ(nearest(wrap, -0.3f), 1);
    EXPECT_NEAR(red(ramp(wrap), Filter::linear, -0.25f), 0.5f, 1e-5f);
  }
  EXPECT_FLOAT_EQ(nearest(Wrap::mirrorClamp, -1.2f), 3);
  EXPECT_NEAR(red(ramp(Wrap::mirrorClampToEdge), Filter::linear, 0), 0, 1e-5f);
  EXPECT_NEAR(red(ramp(Wrap::mirrorClamp), Filter::linear, 0), 1.35f, 1e-5f);  // half of it is border
  EXPECT_FLOAT_EQ(nearest(Wrap::mirrorClampToBorder, -1.2f), 2.7f);
}

TEST(Texture, TexelsBeyondEightBits) {
  auto image = std::make_shared<scene::TextureImage>();
  image->width = 2, image->height = 1;
  image->floats = {glm::vec4(0.1234f), glm::vec4(3)};
  scene::Texture t;
  t.image = image;
  EXPECT_FLOAT_EQ(render::sampleLevel(t, *image, Filter::nearest, {0.2f, 0, 0}).g, 0.1234f);
  EXPECT_NEAR(render::sampleLevel(t, *image, Filter::linear, {0.5f, 0, 0}).g, 1.5617f, 1e-5f);
}

TEST(Texture, SeparateSpecularIsAddedAfterwards) {
  auto t = ramp(Wrap::clampToEdge);
  t.minFilter = t.magFilter = Filter::nearest;
  auto s = texturedScene(t, 1);
  s.shadings[0].lighting = true;
  s.shadings[0].lights.resize(1);
  s.shadings[0].lights[0].diffuse = s.shadings[0].lights[0].specular = glm::vec4(1);
  auto& front = s.instances[0].materials[0].front;
  front.ambient = glm::vec4(0, 0, 0, 1);
  front.diffuse = front.specular = glm::vec4(0.4f, 0.4f, 0.4f, 1);
  EXPECT_NEAR(test::trace(s).color(6, 7).r, 85 * 0.8f, 0.6f);
  s.shadings[0].separateSpecular = true;
  EXPECT_NEAR(test::trace(s).color(6, 7).r, 85 * 0.4f + 102, 0.6f);
}

}  // namespace
}  // namespace gluray
