#include "cluster/arrays/array_store.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace gluray::cluster {
namespace {

/// Later passes over an image name arrays that the program may have forgotten meanwhile.
TEST(ArrayStoreTest, ForgottenArraysAreFoundWhileSomebodyHasThem) {
  ArrayStore store;
  const Hash128 name{1, 2};
  Array kept = makeArray(std::vector<std::byte>(8));
  store.put(0, name, kept);
  store.forget(0, {name});
  EXPECT_EQ(store.bytes(), 0u);
  EXPECT_EQ(store.find(name).owner, kept.owner);
  EXPECT_TRUE(store.waitFor({name}, [] { return true; }));
  kept = {};
  EXPECT_FALSE(store.find(name).owner);
  EXPECT_FALSE(store.waitFor({name}, [] { return true; }));
}

}  // namespace
}  // namespace gluray::cluster
