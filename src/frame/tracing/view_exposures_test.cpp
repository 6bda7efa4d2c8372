#include "frame/tracing/view_exposures.h"

#include <gtest/gtest.h>

namespace gluray::frame {
namespace {

scene::Snapshot batch(uint64_t view, uint64_t frame) {
  scene::Snapshot s;
  s.view = view, s.viewFrame = frame;
  return s;
}

TEST(ViewExposures, AreOneForAllBatchesOfAFrame) {
  ViewExposures exposures;
  int measured = 0;
  const auto meter = [&](std::optional<float> factor) {
    return [&measured, factor] { return ++measured, factor; };
  };
  EXPECT_EQ(exposures.exposureOf(batch(1, 1), meter(std::nullopt)), 1) << "nothing lit yet";
  EXPECT_EQ(exposures.exposureOf(batch(1, 1), meter(2.0f)), 2);
  EXPECT_EQ(exposures.exposureOf(batch(1, 1), meter(3.0f)), 2) << "later batches and passes";
  EXPECT_EQ(measured, 2);
  EXPECT_EQ(exposures.exposureOf(batch(2, 1), meter(4.0f)), 4) << "another view";
  EXPECT_EQ(exposures.exposureOf(batch(1, 2), meter(5.0f)), 5) << "the next frame";
  EXPECT_EQ(exposures.exposureOf(batch(3, 0), meter(6.0f)), 6);
  EXPECT_EQ(exposures.exposureOf(batch(3, 0), meter(7.0f)), 7) << "frames that nobody counts";
}

}  // namespace
}  // namespace gluray::frame
