#include "frame/tracing/trace_ahead.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <mutex>

namespace gluray::frame {
namespace {

/// An image of one pixel whose depth is the frame's number; frame 13 fails.
bool trace(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error) {
  image.resize(1, 1, 1);
  image.depth[0] = static_cast<float>(snapshot.frame);
  cost.traceSeconds = static_cast<double>(snapshot.frame);
  if (snapshot.frame == 13) error = "frame 13";
  return snapshot.frame != 13;
}

scene::SnapshotPtr frame(uint64_t number) {
  auto snapshot = std::make_shared<scene::Snapshot>();
  snapshot->frame = number;
  return snapshot;
}

TEST(TraceAhead, ImagesOneAfterTheOther) {
  TraceAhead ahead(trace);
  for (uint64_t number = 1; number < 50; ++number) {
    const scene::SnapshotPtr snapshot = frame(number);
    ASSERT_TRUE(ahead.start(snapshot, 7, {}));
    EXPECT_TRUE(ahead.has(*snapshot));
    Image image;
    scene::TraceCost cost;
    std::string error;
    EXPECT_EQ(ahead.takeImage(image, cost, error), number != 13);
    EXPECT_FALSE(ahead.has(*snapshot));
    if (number == 13) {
      EXPECT_EQ(error, "frame 13");
      continue;
    }
    EXPECT_EQ(image.depth[0], static_cast<float>(number));
    EXPECT_EQ(image.missColor, 7u);
    EXPECT_EQ(cost.traceSeconds, static_cast<double>(number));
  }
}

TEST(TraceAhead, DroppedImages) {
  TraceAhead ahead(trace);
  ahead.drop();
  for (uint64_t number = 1; number < 5; ++number) {
    ASSERT_TRUE(ahead.start(frame(number), 0, {}));
    ahead.drop();
  }
  ASSERT_TRUE(ahead.start(frame(5), 0, {}));  // destroyed with an image pending
}

TEST(TraceAhead, OverdueImagesAreShownOnce) {
  TraceAhead ahead(trace);
  std::atomic<int> shown{0};
  const scene::SnapshotPtr snapshot = frame(3);
  ASSERT_TRUE(ahead.start(snapshot, 0, {TraceAhead::Clock::now(), [&](const Image& image) {
                                          EXPECT_EQ(image.depth[0], 3);
                                          ++shown;
                                          shown.notify_all();
                                        }}));
  shown.wait(0);
  Image image;
  scene::TraceCost cost;
  std::string error;
  EXPECT_TRUE(ahead.takeImage(image, cost, error));
  EXPECT_EQ(image.depth[0], 3);
  EXPECT_EQ(shown, 1);
}

TEST(TraceAhead, ImagesThatAreTakenInTimeAreNotShown) {
  TraceAhead ahead(trace);
  std::atomic<int> shown{0};
  Image image;
  scene::TraceCost cost;
  std::string error;
  for (uint64_t number = 14; number < 24; ++number) {
    ASSERT_TRUE(
        ahead.start(frame(number), 0,
                    {TraceAhead::Clock::now() + std::chrono::hours(1), [&](const Image&) { ++shown; }}));
    EXPECT_TRUE(ahead.takeImage(image, cost, error));
  }
  EXPECT_EQ(shown, 0);
}

}  // namespace
}  // namespace gluray::frame
