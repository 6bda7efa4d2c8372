#include "gl/volumes/label_rows.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

TEST(LabelRows, OfLabelsFromZeroOn) {
  for (const int last : {1, 2, 3, 7, 45, 254}) {
    const auto count = static_cast<float>(last);
    const auto rows = labelRows({.scale = 256 / count, .count = count, .tableRows = last + 1});
    ASSERT_TRUE(rows) << last;
    EXPECT_EQ((*rows)[0], 0);
    for (size_t label = 1; label <= static_cast<size_t>(last); ++label)
      EXPECT_EQ((*rows)[label], static_cast<float>(label) / count) << last;
    EXPECT_EQ((*rows)[255], 1);
  }
}

TEST(LabelRows, WithoutLabels) {
  const auto rows = labelRows({.scale = 3, .bias = 1});
  ASSERT_TRUE(rows);
  for (const float row : *rows) EXPECT_EQ(row, 0);
}

TEST(LabelRows, BelowZeroAreTheFirstRow) {
  const auto rows = labelRows({.scale = 1, .bias = -0.501f, .count = 2});
  ASSERT_TRUE(rows);
  EXPECT_EQ((*rows)[0], -1);
  EXPECT_EQ((*rows)[100], -0.5f);
  EXPECT_EQ((*rows)[200], 0);
}

TEST(LabelRows, RoundingDecidesNone) {
  EXPECT_FALSE(labelRows({.scale = 255.0f / 7, .count = 7})) << "whole numbers";
  EXPECT_FALSE(labelRows({.scale = 1, .bias = 1e-8f, .count = 2})) << "almost 0";
  EXPECT_FALSE(labelRows({.scale = 64, .count = 4, .tableRows = 4})) << "between two rows";
  EXPECT_TRUE(labelRows({.scale = 64, .count = 4})) << "rows are filtered";
}

}  // namespace
}  // namespace gluray::gl
