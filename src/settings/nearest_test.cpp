#include "settings/nearest.h"

#include "settings/rows.h"

#include <gtest/gtest.h>

namespace gluray {
namespace {

TEST(Nearest, DistancesCountLetters) {
  EXPECT_EQ(editDistance("bvh", "bvh"), 0u);
  EXPECT_EQ(editDistance("", "bvh"), 3u);
  EXPECT_EQ(editDistance("shadng", "shading"), 1u);    // missing
  EXPECT_EQ(editDistance("shaading", "shading"), 1u);  // doubled
  EXPECT_EQ(editDistance("shadimg", "shading"), 1u);   // replaced
  EXPECT_EQ(editDistance("bhv", "bvh"), 1u);           // swapped
  EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
}

TEST(Nearest, SuggestsOnlySimilarNames) {
  EXPECT_EQ(unknownSetting("bhv"), "no setting is called 'bhv'; did you mean 'bvh'?");
  EXPECT_EQ(unknownSetting("log_level"), "no setting is called 'log_level'; did you mean 'log-level'?");
  EXPECT_EQ(unknownSetting("ambient"), "no setting is called 'ambient'");
  EXPECT_EQ(unknownSetting(""), "no setting is called ''");
}

}  // namespace
}  // namespace gluray
