#include "cluster/program/frame_limit.h"

#include <gtest/gtest.h>

#include <vector>

namespace gluray::cluster {
namespace {

/// Sums over ten images, of seconds an image.
RankFigures spends(int rank, double eye, double light, double scenes = 0, double depths = 0,
                   double answers = 0) {
  RankFigures f;
  f.rank = rank, f.images = 10;
  f.eyeSeconds = 10 * eye, f.lightSeconds = 10 * light;
  f.scenesSeconds = 10 * scenes, f.depthsSeconds = 10 * depths, f.answersSeconds = 10 * answers;
  return f;
}

TEST(FrameLimit, NamesTheRankWithMostLight) {
  const std::vector<RankFigures> ranks = {spends(0, 0.1, 1, 0, 0, 2), spends(1, 0.1, 1, 0, 0, 2),
                                          spends(2, 0.1, 1, 0, 0, 2), spends(3, 0.1, 3)};
  EXPECT_EQ(limitOf(ranks), "rank 3 lit 2.0 times the average: uneven light");
}

TEST(FrameLimit, NamesTheRankWithMostRaysFromTheViewer) {
  const std::vector<RankFigures> ranks = {spends(0, 3, 0.5), spends(1, 1, 0.5, 2)};
  EXPECT_EQ(limitOf(ranks),
            "rank 0 traced rays from the viewer for 1.5 times the average: uneven rays from the viewer");
}

TEST(FrameLimit, CountsImagesOfEachRank) {
  RankFigures often = spends(0, 1, 1);
  often.images = 20, often.eyeSeconds = often.lightSeconds = 20;
  EXPECT_EQ(limitOf(std::vector{often, spends(1, 1, 1)}), "light: 50 % of the ranks' work");
  RankFigures early = spends(2, 1, 1, 50);
  early.images = 1;
  EXPECT_EQ(limitOf(std::vector{often, spends(1, 1, 1), early}), "light: 50 % of the ranks' work")
      << "it ended after its first image, whose waiting says nothing of the others";
}

TEST(FrameLimit, NamesWhatRanksWaitFor) {
  EXPECT_EQ(limitOf(std::vector{spends(0, 1, 1), spends(1, 1, 1, 0.1, 2, 0.9)}),
            "waiting for depths of other ranks: 40 % of the time of rank 1");
  EXPECT_EQ(limitOf(std::vector{spends(0, 1, 1, 0, 0, 2), spends(1, 1, 1)}),
            "waiting for answers of other ranks about light: 50 % of the time of rank 0");
  EXPECT_EQ(limitOf(std::vector{spends(0, 1, 1, 2), spends(1, 1, 1)}),
            "waiting for scenes of other ranks: 50 % of the time of rank 0");
}

TEST(FrameLimit, NamesTheWorkWhereRanksAreEven) {
  EXPECT_EQ(limitOf(std::vector{spends(0, 1, 3, 0.1), spends(1, 1.1, 3)}), "light: 74 % of the ranks' work");
  EXPECT_EQ(limitOf(std::vector{spends(0, 3, 1), spends(1, 3, 1)}),
            "rays from the viewer: 75 % of the ranks' work");
}

TEST(FrameLimit, SaysWhatWasNotMeasured) {
  const char* const nothing = "not measured: no image had light across ranks";
  EXPECT_EQ(limitOf({}), nothing);
  EXPECT_EQ(limitOf(std::vector{spends(0, 0, 0), RankFigures{}}), nothing);
}

}  // namespace
}  // namespace gluray::cluster
