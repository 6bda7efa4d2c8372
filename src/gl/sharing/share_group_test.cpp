#include "gl/sharing/share_group.h"

#include "gl/context/list.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

TEST(NameTable, ReservesAboveAllNamesEverUsed) {
  ShareGroup group;
  EXPECT_EQ(group.lists.reserve(3), 1u);
  group.lists.put(5, std::make_shared<DisplayList>());
  EXPECT_EQ(group.lists.reserve(2), 6u);
  group.lists.erase(7);
  EXPECT_EQ(group.lists.reserve(1), 8u);
  group.lists.put(0xFFFFFFFFu, std::make_shared<DisplayList>());
  EXPECT_EQ(group.lists.reserve(2), 9u) << "no room above: the first gap";
  EXPECT_TRUE(group.lists.contains(10));
  EXPECT_FALSE(group.lists.contains(11));
  EXPECT_EQ(group.lists.find(1), nullptr) << "reserved, but empty";
}

TEST(NameTable, ErasesRangesOfAnySize) {
  ShareGroup group;
  group.lists.reserve(10);
  group.lists.eraseRange(3, 2);
  EXPECT_FALSE(group.lists.contains(3));
  EXPECT_TRUE(group.lists.contains(5));
  group.lists.eraseRange(5, 2000000000u);
  EXPECT_FALSE(group.lists.contains(10));
  EXPECT_TRUE(group.lists.contains(2));
}

TEST(MeshCache, ForgetsMeshesThatNoFrameUsed) {
  MeshCache cache;
  KnownMesh found;
  cache.put({1, 1}, {std::make_shared<scene::Mesh>(), false});
  cache.put({2, 2}, {std::make_shared<scene::Mesh>(), false});
  for (int frame = 0; frame < 20; ++frame) {
    EXPECT_TRUE(cache.find({1, 1}, found));
    cache.advance();
  }
  EXPECT_TRUE(cache.find({1, 1}, found));
  EXPECT_FALSE(cache.find({2, 2}, found));
}

}  // namespace
}  // namespace gluray::gl
