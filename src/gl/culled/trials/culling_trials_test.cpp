// Whether culling large draws pays, by simulated draws.
#include "gl/culled/trials/culling_trials.h"

#include <gtest/gtest.h>

#include <vector>

namespace gluray::gl {
namespace {

using DrawWay = CullingTrials::Way;

/// Simulated draws of one mesh, with their times.
struct TriedMesh {
  double plain = 0.01, culled = 0.02;
  bool possible = true;  // to be culled
  CullingTrials trials{};
  int measured = 0;

  double draw(TrialBudget& budget) {
    const CullingTrials::Next next = trials.nextDraw(false, budget);
    const bool isCulled = next.way == DrawWay::culled && possible;
    const double took = isCulled ? culled : plain;
    measured += next.measured;
    if (next.measured) trials.took(next.way, isCulled, took, budget);
    return took;
  }
};

/// Time of `frames` frames that draw all meshes, divided by the time of plain draws.
double shareOf(std::vector<TriedMesh>& meshes, TrialBudget& budget, int frames) {
  double took = 0, plain = 0;
  for (int i = 0; i < frames; ++i)
    for (TriedMesh& mesh : meshes) took += mesh.draw(budget), plain += mesh.plain;
  return took / plain;
}

TEST(CullingTrials, KeepWhatIsFaster) {
  TrialBudget budget;
  std::vector<TriedMesh> pays{{0.01, 0.003}}, close{{0.01, 0.0098}};
  EXPECT_LT(shareOf(pays, budget, 1000), 0.31);
  EXPECT_TRUE(pays[0].trials.pays());
  EXPECT_GT(shareOf(close, budget, 1000), 0.999);
  EXPECT_FALSE(close[0].trials.pays());
}

TEST(CullingTrials, AreBoundedShareOfTheTime) {
  for (const double slower : {1.05, 1.4, 2.0, 5.0, 20.0}) {
    TrialBudget budget;
    std::vector<TriedMesh> meshes{{0.01, 0.01 * slower}};
    shareOf(meshes, budget, 3);
    EXPECT_LT(shareOf(meshes, budget, 1000), 1 + TrialBudget::kShare + slower / 1000) << slower;
    EXPECT_LT(shareOf(meshes, budget, 4000), 1 + TrialBudget::kShare) << slower;
    EXPECT_FALSE(meshes[0].trials.pays());
  }
}

TEST(CullingTrials, ShareWhatTheyMayCost) {
  TrialBudget budget;
  std::vector<TriedMesh> meshes(50, TriedMesh{0.001, 0.003});
  meshes.push_back({0.01, 0.002});
  shareOf(meshes, budget, 200);
  EXPECT_TRUE(meshes.back().trials.pays());
  // Meshes that come and go cost no more in trials.
  double took = 0;
  for (int i = 0; i < 100; ++i) {
    std::vector<TriedMesh> next(3, TriedMesh{0.001, 0.01});
    took += shareOf(next, budget, 20) / 100;
  }
  EXPECT_LT(took, 1.05);
}

TEST(CullingTrials, EndWhereNothingCanBeCulled) {
  TrialBudget budget;
  std::vector<TriedMesh> meshes{{.possible = false}};
  shareOf(meshes, budget, 1000);
  EXPECT_LT(meshes[0].measured, 40);
  EXPECT_FALSE(meshes[0].trials.pays());
}

TEST(CullingTrials, FollowWholeDrawsThatBecomeSlower) {
  TrialBudget budget;
  std::vector<TriedMesh> meshes{{0.01, 0.02}};
  shareOf(meshes, budget, 500);
  EXPECT_FALSE(meshes[0].trials.pays());
  meshes[0].plain = 0.05;
  shareOf(meshes, budget, 1100);
  EXPECT_TRUE(meshes[0].trials.pays());
}

}  // namespace
}  // namespace gluray::gl
