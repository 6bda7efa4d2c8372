#include "gl/batch/snapshot_memory.h"

#include <gtest/gtest.h>

#include <thread>

namespace gluray::gl {
namespace {

TEST(SnapshotMemory, IsReusedOnceReleased) {
  SnapshotMemory memory;
  auto first = memory.make();
  first->frame = 7;
  first->instances.resize(1000);
  first->shadings.resize(10);
  const scene::Instance* where = first->instances.data();
  auto reader = std::move(first);
  const auto second = memory.make();
  EXPECT_EQ(second->instances.capacity(), 0u);  // the first is still in use
  const std::weak_ptr<const scene::Mesh> mesh = (reader->instances[5].mesh = std::make_shared<scene::Mesh>());
  std::thread([last = std::move(reader)] {}).join();
  EXPECT_TRUE(mesh.expired());
  const auto third = memory.make();
  EXPECT_TRUE(third->instances.empty());
  EXPECT_TRUE(third->shadings.empty());
  EXPECT_EQ(third->frame, 0u);
  third->instances.resize(1000);
  EXPECT_EQ(third->instances.data(), where);
}

TEST(SnapshotMemory, IsFreedOnceItIsNoLongerNeeded) {
  SnapshotMemory memory;
  memory.make()->instances.resize(1000);
  for (int i = 0; i < SnapshotMemory::kPatience; ++i) {
    const auto small = memory.make();
    EXPECT_EQ(small->instances.capacity(), 1000u) << i;
    small->instances.resize(2);
  }
  memory.make()->instances.resize(2);
  EXPECT_LT(memory.make()->instances.capacity(), 1000u);
}

TEST(SnapshotMemory, SnapshotsOutliveIt) {
  std::shared_ptr<scene::Snapshot> snapshot;
  {
    SnapshotMemory memory;
    snapshot = memory.make();
  }
  snapshot->instances.resize(3);
  snapshot.reset();
}

}  // namespace
}  // namespace gluray::gl
