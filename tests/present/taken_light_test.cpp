// Opacities of black that are blended over visible pixels equal the image with its depths, to the bit.
#include "intercept/present/write_back/seen_catchers.h"
#include "scene/catcher_offset.h"
#include "tests/present/write_back_stage.h"

namespace gluray::present::test {
namespace {

constexpr float kSurface = 0.5f;  // depth of the surfaces in the framebuffer

scene::Snapshot catching() {
  scene::Snapshot s;
  s.catches = true;
  s.polygonOffset.factor = scene::kCatcherSlope, s.polygonOffset.units = scene::kCatcherUnits;
  s.polygonOffset.resolution = 0x1p-24f;
  return s;
}

/// A surface, slightly before its depth in the framebuffer, that loses more light from column to column.
/// Misses lie in its corners.
Image lightOf(int x, int y, int width, int height) {
  Image image;
  image.x = x, image.y = y;
  image.resize(width, height, 1);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const auto i = static_cast<size_t>(row * width + column);
      const bool miss = (column < 3 || column + 3 >= width) && (row < 3 || row + 3 >= height);
      image.color[i] = miss ? 0 : static_cast<uint32_t>(column * 255 / (width - 1)) << 24;
      image.depth[i] = miss ? Image::kMiss : kSurface - 16 * 0x1p-24f;
    }
  return image;
}

class TakenLightWriteBack : public WriteBackStage {
 protected:
  /// Depths of surfaces, and of what lies behind and before them.
  void drawScene() {
    clear(0, 1, 0, kSurface);
    clearRectangle(10, 10, 9, 40, 1, 0, 0, 0.2);
    clearRectangle(30, 5, 9, 40, 0, 0, 1, 0.9);
  }
  std::vector<float> depthsOf(const Image& image) const {
    const std::vector<float> all = context_->depths();
    std::vector<float> depths;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) depths.push_back(at(all, image.x + x, image.y + y));
    return depths;
  }
};
INSTANTIATE_TEST_SUITE_P(Contexts, TakenLightWriteBack, allContexts(), nameOf);

TEST_P(TakenLightWriteBack, EqualsTheImageWithItsDepths) {
  WriteBack blend(gl(), WriteBack::Colors::taken);
  for (const auto& [x, y, width, height] : {std::array{0, 0, kSize, kSize}, {5, 3, 37, 50}, {8, 9, 1, 2}}) {
    const Image image = width > 1 ? lightOf(x, y, width, height) : [&, x = x, y = y] {
      Image column = lightOf(x, y, 8, 8);
      column.resize(1, 2, 1);
      column.color = {0x80000000u, 0x40000000u}, column.depth = {kSurface, kSurface};
      return column;
    }();
    drawScene();
    const std::vector<float> depths = depthsOf(image), before = context_->depths();
    const std::vector<uint32_t> untouched = context_->colors();
    Image seen;
    findSeenCatchers(image, catching(), depths, seen);
    ASSERT_TRUE(writeBack_->write(seen, {.keepsDepth = true}, pending_));
    const std::vector<uint32_t> expected = context_->colors();
    drawScene();
    TakenLight taken;
    findTakenLight(image, catching(), depths, taken);
    ASSERT_TRUE(blend.writeTaken(taken, {.keepsDepth = true}, pending_));
    EXPECT_EQ(context_->colors(), expected);
    EXPECT_NE(expected, untouched);
    EXPECT_EQ(context_->depths(), before);
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
}

TEST_P(TakenLightWriteBack, TakesNothingFromPixelsThatShowSomethingElse) {
  const Image image = lightOf(0, 0, kSize, kSize);
  drawScene();
  TakenLight taken;
  findTakenLight(image, catching(), depthsOf(image), taken);
  EXPECT_EQ(*taken.at(14, 20), 0) << "before the surface";
  EXPECT_EQ(*taken.at(34, 20), 0) << "behind it";
  EXPECT_EQ(*taken.at(1, 1), 0) << "a miss";
  EXPECT_EQ(*taken.at(25, 20), 25 * 255 / (kSize - 1));
}

TEST_P(TakenLightWriteBack, LeavesTheStateAlone) {
  WriteBack blend(gl(), WriteBack::Colors::taken);
  const auto& g = gl();
  g.BlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_ONE, GL_SRC_ALPHA);
  g.DepthMask(GL_FALSE);
  drawScene();
  const Image image = lightOf(0, 0, kSize, kSize);
  TakenLight taken;
  findTakenLight(image, catching(), depthsOf(image), taken);
  ASSERT_TRUE(blend.writeTaken(taken, {.keepsDepth = true}, pending_));
  const auto is = [&](GLenum name) {
    GLint value = 0;
    g.GetIntegerv(name, &value);
    return value;
  };
  EXPECT_FALSE(g.IsEnabled(GL_BLEND));
  EXPECT_TRUE(g.IsEnabled(GL_DEPTH_TEST));
  EXPECT_EQ(is(GL_BLEND_SRC_RGB), GL_DST_COLOR);
  EXPECT_EQ(is(GL_BLEND_DST_ALPHA), GL_SRC_ALPHA);
  EXPECT_EQ(is(GL_DEPTH_WRITEMASK), GL_FALSE);
  EXPECT_EQ(is(GL_UNPACK_ROW_LENGTH), 0);
}

}  // namespace
}  // namespace gluray::present::test
