#include "gl/batch/batch.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

scene::Instance instanceOf(uint64_t geometry, double x = 0) {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->geometryId = {geometry, 0};
  scene::Instance instance;
  instance.mesh = mesh;
  instance.eyeFromObject[3][0] = x;
  instance.materials.resize(1);
  return instance;
}

struct StateOfDraw {
  TargetState target;
  RasterState raster;
  ViewportState viewport;
  glm::dmat4 projection{1};
  BatchKey key() const { return Batch::keyOf({target, raster, viewport}, projection); }
};

StateOfDraw stateWith(GLenum depthFunc) {
  StateOfDraw state;
  state.viewport.box = {0, 0, 100, 50};
  state.raster.depthFunc = depthFunc;
  return state;
}

struct Started : Batch {
  explicit Started(const StateOfDraw& state) { start(state.key(), state.target, glm::dmat4(1), {}, 1); }
};

TEST(Batch, LaterOfTwoEqualSurfacesWinsUnderLequalAndEarlierUnderLess) {
  for (const GLenum func : {GL_LEQUAL, GL_LESS}) {
    Started batch(stateWith(func));
    scene::Instance first = instanceOf(1), second = instanceOf(1);
    first.color = {1, 0, 0, 1}, second.color = {0, 1, 0, 1};
    batch.add(first, {});
    batch.add(instanceOf(2), {});
    batch.add(second, {});
    const auto snapshot = batch.takeSnapshot();
    ASSERT_EQ(snapshot->instances.size(), 2u);
    EXPECT_EQ(snapshot->instances[0].color, func == GL_LESS ? first.color : second.color);
  }
}

TEST(Batch, EqualMeshesInOtherPlacesAreInstances) {
  Started batch(stateWith(GL_LESS));
  batch.add(instanceOf(1, 0), {});
  batch.add(instanceOf(1, 5), {});
  const auto snapshot = batch.takeSnapshot();
  ASSERT_EQ(snapshot->instances.size(), 2u);
  EXPECT_EQ(snapshot->instances[0].worldFromObject, glm::mat4(1))
      << "the first instance's object space is the world";
  EXPECT_FLOAT_EQ(snapshot->instances[1].worldFromObject[3][0], 5);
  EXPECT_TRUE(batch.empty());
}

TEST(Batch, ViewsAreOfTheirContextAndWindow) {
  const auto viewOf = [](uint64_t context, uintptr_t window, GLuint framebuffer) {
    StateOfDraw state = stateWith(GL_LESS);
    state.target.context = context, state.target.drawable = window, state.target.framebuffer = framebuffer;
    Started batch(state);
    batch.add(instanceOf(1), {});
    return batch.takeSnapshot()->view;
  };
  EXPECT_EQ(viewOf(1, 7, 0), viewOf(1, 7, 0));
  EXPECT_NE(viewOf(1, 7, 0), viewOf(1, 8, 0));
  EXPECT_NE(viewOf(1, 7, 0), viewOf(2, 7, 0));
  EXPECT_NE(viewOf(1, 7, 3), viewOf(2, 7, 3));
  EXPECT_EQ(viewOf(1, 7, 3), viewOf(1, 8, 3));
}

TEST(Batch, SharesEqualShadings) {
  Started batch(stateWith(GL_LESS));
  scene::Shading lit;
  lit.lighting = true;
  batch.add(instanceOf(1), {});
  batch.add(instanceOf(2), lit);
  batch.add(instanceOf(3), {});
  const auto snapshot = batch.takeSnapshot();
  EXPECT_EQ(snapshot->shadings.size(), 2u);
  EXPECT_EQ(snapshot->instances[2].shading, snapshot->instances[0].shading);
}

TEST(Batch, RegionIsViewportAndScissorWithinLimits) {
  StateOfDraw state = stateWith(GL_LESS);
  EXPECT_EQ(state.key().region, (scene::Region{0, 0, 100, 50}));
  state.viewport.scissorTest = true;
  state.viewport.scissor = {90, -5, 100, 10};
  EXPECT_EQ(state.key().region, (scene::Region{90, 0, 10, 5}));
  state.viewport.scissor = {200, 0, 10, 10};
  EXPECT_EQ(state.key().region.width, 0);
  state.viewport.scissorTest = false;
  state.viewport.box = {-2000000000, 0, 2147483647, 2147483647};
  EXPECT_LE(state.key().region.width, 16384);
}

TEST(Batch, StateChangesGiveAnotherKey) {
  const StateOfDraw base = stateWith(GL_LESS);
  StateOfDraw offset = base, range = base, projection = base;
  offset.raster.offsetFill = true, offset.raster.offsetFactor = 1;
  range.viewport.depthFar = 0.5f;
  projection.projection[0][0] = 2;
  for (const StateOfDraw* s : {&offset, &range, &projection}) EXPECT_FALSE(s->key() == base.key());
  EXPECT_TRUE(stateWith(GL_LESS).key() == base.key());
}

}  // namespace
}  // namespace gluray::gl
