#include "gl/capture/list_values.h"

#include <GL/gl.h>
#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

constexpr float kFirstColor[4] = {1, 0, 0, 1}, kLaterColor[4] = {0, 0, 1, 1};

/// A list's run of triangles.
class ListValuesTest : public ::testing::Test {
 protected:
  void SetUp() override { stream_.start(bit(kPosition), initialSlotValues()); }
  void put(Slot slot, const float* value) {
    if (!stream_.has(slot)) stream_.addSlot(slot, initialSlotValues()[slot].data());
    stream_.set(slot, value);
  }
  void outside(const float* color) { values_.set(stream_, kColor, color), put(kColor, color); }
  void begin() { values_.begin(stream_, false), stream_.begin(GL_TRIANGLES); }
  void inside(const float* color) {
    if (!stream_.has(kColor)) values_.addSlot(stream_);
    put(kColor, color);
  }
  void vertices() {
    for (int i = 0; i < 3; ++i) stream_.vertexSlow(float(i), 0, 0, 1);
  }
  void draw() { begin(), vertices(), stream_.end(); }
  /// After the run, if nothing was held back before it.
  ListEffect::Left left(bool pending = false, bool due = false) {
    values_.finish(stream_);
    return values_.effect(stream_.takeRun()).after(pending, due);
  }
  VertexStream stream_;
  ListValues values_;
};

TEST_F(ListValuesTest, VerticesStoreWhatIsHeldBack) {
  draw();
  EXPECT_TRUE(left(true, false).due && left(true, false).keepsOlder);
  EXPECT_FALSE(left(true, true).due || left(true, true).keepsOlder);
  EXPECT_TRUE(left().keepsOlder);
}

TEST_F(ListValuesTest, ColoursBeforeVerticesAreHeldBack) {
  outside(kFirstColor), draw();
  const ListEffect::Left after = left();
  EXPECT_EQ(after.set, bit(kColor));
  EXPECT_TRUE(after.due && !after.pending);
  EXPECT_EQ(after.values.at(0)[0], 1);
}

TEST_F(ListValuesTest, EveryOtherDrawLetsGo) {
  outside(kFirstColor), draw(), outside(kLaterColor), draw();
  EXPECT_EQ(left().set, 0u);
  EXPECT_EQ(left().stored, bit(kColor));
  EXPECT_EQ(left().values.at(0)[2], 1);
}

TEST_F(ListValuesTest, ColoursOfTheLastVertexAreStored) {
  begin(), inside(kFirstColor), vertices(), stream_.end();
  EXPECT_EQ(left().stored, bit(kColor));
  EXPECT_EQ(left().set, 0u);
}

TEST_F(ListValuesTest, ColoursAfterAllVerticesArePending) {
  draw(), outside(kLaterColor);
  EXPECT_TRUE(left().pending && !left().due);
  EXPECT_EQ(left().set, bit(kColor));
}

TEST_F(ListValuesTest, ANewColourAfterSomeVerticesStartsAnotherDraw) {
  outside(kFirstColor), draw(), draw(), begin(), inside(kLaterColor), vertices(), stream_.end();
  const ListEffect::Left after = left();
  EXPECT_EQ(after.set, 0u);
  EXPECT_EQ(after.values.at(0)[2], 1);
}

TEST_F(ListValuesTest, ArraysStoreNothing) {
  begin(), inside(kFirstColor), vertices(), stream_.end(), put(kColor, kLaterColor),
      values_.fromArrays(stream_);
  EXPECT_EQ(left().stored | left().set, 0u);
}

TEST_F(ListValuesTest, APrimitiveOfTheSameDrawStoresNothingAgain) {
  values_.begin(stream_, true), stream_.begin(GL_TRIANGLES), vertices(), stream_.end();
  EXPECT_TRUE(left(true, true).pending && left(true, true).due && left(true, true).keepsOlder);
}

}  // namespace
}  // namespace gluray::gl
