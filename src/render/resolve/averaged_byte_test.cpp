// Averages of bytes have one byte, whether they are kept as bytes or as parts of white.
#include "render/resolve/averaged_byte.h"

#include <gtest/gtest.h>

namespace gluray::render {
namespace {

TEST(AveragedByte, IsTheNearestAndHalvesAreRoundedUp) {
  for (const int samples : {1, 2, 3, 4, 6, 16, 60, 256, 1024}) {
    const float share = 1 / static_cast<float>(samples);
    for (int sum = 0; sum <= 255 * samples; ++sum) {
      const float average = static_cast<float>(sum) * share;
      const auto nearest = static_cast<uint32_t>((2 * sum + samples) / (2 * samples));
      ASSERT_EQ(averagedByte(average), nearest) << sum << '/' << samples;
      ASSERT_EQ(displayedByte(average / 255, true), nearest) << sum << '/' << samples;
    }
  }
}

}  // namespace
}  // namespace gluray::render
