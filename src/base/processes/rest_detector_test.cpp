// When a program is at rest.
#include "base/processes/rest_detector.h"

#include <gtest/gtest.h>

namespace gluray {
namespace {

TEST(RestDetector, WaitsUntilNothingIsDrawnOrComputed) {
  RestDetector rest(1.5);
  EXPECT_FALSE(rest.isAtRest(0, 0, [] { return 0.0; }));
  EXPECT_FALSE(rest.isAtRest(0, 10, [] { return 0.0; })) << "it has shown nothing";
  EXPECT_FALSE(rest.isAtRest(1, 11, [] { return 5.0; }));
  EXPECT_FALSE(rest.isAtRest(1, 12, [] { return 5.0; })) << "too early";
  EXPECT_FALSE(rest.isAtRest(1, 13, [] { return 7.0; })) << "it computes";
  EXPECT_FALSE(rest.isAtRest(2, 14, [] { return 7.0; })) << "it draws";
  EXPECT_TRUE(rest.isAtRest(2, 16, [] { return 7.1; }));
}

}  // namespace
}  // namespace gluray
