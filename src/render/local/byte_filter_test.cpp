// Known answers of filters that round to eight bits.
#include "render/local/byte_filter.h"

#include "render/local/mipmap.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray {
namespace {

/// A row of texels with these red values.
scene::Texture rowOf(const std::vector<uint32_t>& reds, scene::Wrap wrap) {
  auto image = std::make_shared<scene::TextureImage>();
  image->width = static_cast<int>(reds.size()), image->height = 1;
  image->texels = reds;
  scene::Texture t;
  t.image = image;
  t.target = scene::TextureTarget::texture1D;
  t.wrapS = wrap;
  t.byteFilter = true;
  return t;
}

/// Red of 255 between two texels, `weight` / 256 from the first to the second.
float between(uint32_t a, uint32_t b, float weight) {
  const scene::Texture t = rowOf({a, b}, scene::Wrap::clampToEdge);
  return 255 * render::sampleTexture(t, {}, {(0.5f + weight / 256) / 2, 0, 0}).r;
}

TEST(ByteFilter, RoundsWeightsToEightBits) {
  EXPECT_FLOAT_EQ(between(0, 255, 128), 128) << "127.5 rounds up";
  EXPECT_FLOAT_EQ(between(0, 255, 1), 1);
  EXPECT_FLOAT_EQ(between(0, 255, 0.4f), 0);
  EXPECT_FLOAT_EQ(between(0, 255, 255), 254);
  EXPECT_FLOAT_EQ(between(255, 0, 128), 128) << "255 - 127.5 rounds up";
  EXPECT_FLOAT_EQ(between(10, 20, 13), 11) << "10.508";
  EXPECT_FLOAT_EQ(between(10, 20, 12), 10) << "10.469";
  EXPECT_FLOAT_EQ(between(10, 20, 12.6f), 11) << "the weight is 13";
}

TEST(ByteFilter, Repeats) {
  for (const std::vector<uint32_t>& reds : {std::vector<uint32_t>{200, 0, 0, 100}, {200, 0, 0, 0, 100}}) {
    const scene::Texture t = rowOf(reds, scene::Wrap::repeat);
    for (const float s : {-2.0f, 0.0f, 1.0f, 5.0f})
      EXPECT_FLOAT_EQ(255 * render::sampleTexture(t, {}, {s, 0, 0}).r, 150) << reds.size() << ' ' << s;
  }
}

TEST(ByteFilter, RoundsBetweenLevels) {
  const glm::vec4 a(10 / 255.0f), b(20 / 255.0f);
  EXPECT_FLOAT_EQ(255 * render::mixBytes(a, b, 13.9f / 256).g, 11) << "the weight is 13: 10.508";
  EXPECT_FLOAT_EQ(255 * render::mixBytes(a, b, 12.9f / 256).g, 10) << "the weight is 12: 10.469";
}

TEST(ByteFilter, FloatsKeepTheirPrecision) {
  scene::Texture t = rowOf({0, 255}, scene::Wrap::clampToEdge);
  auto floats = std::make_shared<scene::TextureImage>(*t.image);
  floats->floats = {glm::vec4(0), glm::vec4(1)};
  t.image = floats;
  EXPECT_FALSE(render::isFilteredInBytes(t));
  EXPECT_FLOAT_EQ(render::sampleTexture(t, {}, {0.5f, 0, 0}).r, 0.5f);
}

TEST(ByteFilter, HostileCoordinatesStayInTheImage) {
  for (const scene::Wrap wrap : {scene::Wrap::repeat, scene::Wrap::clampToEdge})
    for (const std::vector<uint32_t>& reds : {std::vector<uint32_t>{9, 9}, {9, 9, 9}})
      for (const float s : {std::nanf(""), INFINITY, -INFINITY, 1e30f, -1e30f, 1e7f, -3e9f})
        EXPECT_FLOAT_EQ(255 * render::sampleTexture(rowOf(reds, wrap), {}, {s, 0, 0}).r, 9) << s;
}

}  // namespace
}  // namespace gluray
