// Which views get a ground and a background, and which pixels a background may change.
#include "gl/views/shown_views.h"

#include "gl/pending/cleared_pixels.h"
#include "scene/backdrop.h"

#include <GL/glext.h>
#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

BatchKey keyAt(const glm::ivec4& viewport, GLuint framebuffer = 0) {
  BatchKey key;
  key.framebuffer = framebuffer, key.drawBuffer = GL_BACK, key.viewport = viewport;
  return key;
}

scene::Snapshot drawn(uint64_t frame, scene::GroundUse ground = scene::GroundUse::drawn) {
  scene::Snapshot s;
  s.frame = frame, s.ground = ground;
  return s;
}

const glm::ivec4 kWindow{0, 0, 800, 600}, kMarker{0, 0, 160, 120}, kBeside{800, 0, 800, 600};

TEST(ShownViews, FurtherLayersAndInsetsHaveNoGround) {
  ShownViews views;
  EXPECT_TRUE(views.mayStand(keyAt(kWindow), 1));
  views.traced(keyAt(kWindow), drawn(1));
  EXPECT_FALSE(views.mayStand(keyAt(kWindow), 1)) << "a layer over it, after a clear of depth alone";
  EXPECT_FALSE(views.mayStand(keyAt(kMarker), 1));
  EXPECT_TRUE(views.mayStand(keyAt(kBeside), 1));
  EXPECT_TRUE(views.mayStand(keyAt(kWindow, 7), 1)) << "another framebuffer";
  EXPECT_TRUE(views.mayStand(keyAt(kWindow), 2)) << "the next frame";
}

TEST(ShownViews, InsetsAreThoseOfViewsWithoutGround) {
  ShownViews views;
  views.traced(keyAt(kWindow), drawn(1, scene::GroundUse::none));
  EXPECT_FALSE(views.mayStand(keyAt(kMarker), 1));
  EXPECT_TRUE(views.mayStand(keyAt(kWindow), 1)) << "its first batch held nothing lit";
}

TEST(ShownViews, SmallViewsInsideOthersAreInsets) {
  ShownViews views;
  EXPECT_FALSE(views.isInset(keyAt(kMarker), 1)) << "nothing is around it";
  views.traced(keyAt(kWindow), drawn(1, scene::GroundUse::none));
  EXPECT_TRUE(views.isInset(keyAt(kMarker), 1));
  EXPECT_FALSE(views.isInset(keyAt(kWindow), 1)) << "a further layer";
  EXPECT_FALSE(views.isInset(keyAt({0, 0, 400, 400}), 1)) << "a third of the window";
  EXPECT_TRUE(views.isInset(keyAt({400, 300, 400, 300}), 1)) << "a quarter";
  EXPECT_FALSE(views.isInset(keyAt(kBeside), 1));
  EXPECT_FALSE(views.isInset(keyAt(kMarker), 2)) << "the next frame";
}

TEST(ShownViews, AClearOfColoursBeginsAnew) {
  ShownViews views;
  views.traced(keyAt(kWindow), drawn(1));
  views.colorCleared({0, {0, 0, 160, 120}, {}, 0});
  EXPECT_FALSE(views.mayStand(keyAt(kWindow), 1)) << "of a part";
  views.colorCleared({0, {0, 0, 800, 600}, {}, 0});
  EXPECT_TRUE(views.mayStand(keyAt(kWindow), 1));
}

TEST(ShownViews, BackgroundsNeedAClearUnderAllOfTheRegion) {
  ShownViews views;
  const scene::Region region{0, 0, 800, 600};
  EXPECT_FALSE(views.mayPaint(keyAt(kWindow), region, 1));
  views.colorCleared({0, region, {1, 0, 0, 1}, 5});
  ASSERT_TRUE(views.mayPaint(keyAt(kWindow), region, 1));
  EXPECT_EQ(views.mayPaint(keyAt(kWindow), region, 1)->color, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(views.mayPaint(keyAt(kWindow), region, 1)->drawsBefore, 5u);
  EXPECT_FALSE(views.mayPaint(keyAt(kWindow, 3), region, 1));
  EXPECT_FALSE(views.mayPaint(keyAt(kWindow), {0, 0, 801, 600}, 1));
  scene::Snapshot s = drawn(1);
  s.backdrop = std::make_shared<scene::Backdrop>();
  views.traced(keyAt(kWindow), s);
  EXPECT_FALSE(views.mayPaint(keyAt(kWindow), region, 1));
  EXPECT_FALSE(views.mayPaint(keyAt(kMarker), {0, 0, 160, 120}, 1));
  views.colorCleared({0, region, {0, 1, 0, 1}, 9});
  EXPECT_EQ(views.mayPaint(keyAt(kWindow), region, 1)->color, glm::vec4(0, 1, 0, 1));
}

TEST(ShownViews, ManyClearsTakeLittleMemory) {
  ShownViews views;
  for (GLuint f = 1; f < 1000; ++f) views.colorCleared({f, {0, 0, 8, 8}, {}, 0});
  EXPECT_FALSE(views.mayPaint(keyAt({0, 0, 8, 8}, 1), {0, 0, 8, 8}, 1));
  EXPECT_TRUE(views.mayPaint(keyAt({0, 0, 8, 8}, 999), {0, 0, 8, 8}, 1));
}

TEST(LitSurfaces, ImagesToPickFromHaveNone) {
  scene::Snapshot s;
  s.shadings.resize(2);
  s.instances.resize(1);
  EXPECT_FALSE(holdsLitSurface(s));
  s.shadings[1].lighting = true;
  EXPECT_FALSE(holdsLitSurface(s));
  s.instances[0].shading = 1;
  EXPECT_TRUE(holdsLitSurface(s));
  s.shadings[1].fragment.model = scene::FragmentShading::Model::unlit;
  EXPECT_FALSE(holdsLitSurface(s));
  s.shadings[1].fragment.model = scene::FragmentShading::Model::phong;
  EXPECT_TRUE(holdsLitSurface(s));
}

TEST(Backdrops, CoverPixelsThatHoldTheClearColour) {
  const glm::vec4 clear(0.2f, 0.4f, 0.6f, 1);  // 51, 102, 153
  const uint32_t held = 0xff996633, rounded = 0xff996634, other = 0xff996635;
  const auto where = backdropWhere({held, rounded, other, held}, clear);
  ASSERT_TRUE(where);
  EXPECT_EQ(where->isClear, (std::vector<uint8_t>{1, 1, 0, 1}));
  EXPECT_FALSE(backdropWhere({held, other, other}, clear)) << "the program has a background of its own";
}

TEST(Backdrops, AlphaCountsWhereTheFramebufferStoresIt) {
  const auto opaque = backdropWhere({0xff000000, 0xff000000}, glm::vec4(0));
  ASSERT_TRUE(opaque);
  EXPECT_EQ(opaque->isClear, (std::vector<uint8_t>{1, 1}));
  const auto stored = backdropWhere({0x00000000, 0xff000000, 0}, glm::vec4(0));
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->isClear, (std::vector<uint8_t>{1, 0, 1})) << "black that the program drew";
}

}  // namespace
}  // namespace gluray::gl
