// Light across the ranks of a sort-last program: composed by depth, their images are that of one process.
#include "cluster/testing/program_ranks.h"

#include <chrono>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace gluray::cluster {
namespace {

using test::composed;
using test::differing;
using test::expectedImage;
using test::partOf;
using test::partsOf;
using test::plates;
using test::WorkerJob;

struct Setup {
  int ranks, workers;
};
class PeersTest : public testing::TestWithParam<Setup> {
 protected:
  void expectOneImage(WorkerJob& job, test::ProgramRanks& ranks, const scene::Snapshot& all) {
    EXPECT_EQ(differing(composed(ranks.images(all)), expectedImage(all)), 0) << job.said();
    EXPECT_TRUE(ranks.allByWorkers());
  }
  /// Whether the test would notice if light did not cross ranks.
  static int differenceWithoutPeers(const scene::Snapshot& all, int ranks) {
    std::vector<Image> images;
    for (int rank = 0; rank < ranks; ++rank) images.push_back(expectedImage(partOf(all, rank, ranks)));
    return differing(composed(std::move(images)), expectedImage(all));
  }

  test::RuntimeFolder folder_;
  const std::string directory_ = folder_.directory();
};

TEST_P(PeersTest, OcclusionAndHardShadows) {
  WorkerJob job(directory_, GetParam().workers);
  test::ProgramRanks ranks(directory_, GetParam().ranks);
  const scene::Snapshot all = plates();
  EXPECT_GT(differenceWithoutPeers(all, GetParam().ranks), 500);
  expectOneImage(job, ranks, all);
}

TEST_P(PeersTest, SoftShadowsOfSeveralLights) {
  WorkerJob job(directory_, GetParam().workers);
  test::ProgramRanks ranks(directory_, GetParam().ranks);
  scene::Snapshot all = plates();
  all.settings.ao.enabled = false;
  all.settings.shadows.size = 5, all.settings.shadows.samples = 4;
  scene::Light second = all.shadings[0].lights[0];
  second.position = {-1, 0.2f, 0.5f, 1};
  second.diffuse = {0.4f, 0.3f, 0.2f, 1};
  all.shadings[0].lights.push_back(second);
  expectOneImage(job, ranks, all);
}

TEST_P(PeersTest, FramesAfterEachOther) {
  WorkerJob job(directory_, GetParam().workers);
  test::ProgramRanks ranks(directory_, GetParam().ranks);
  scene::Snapshot all = plates(64);
  for (int frame = 1; frame <= 6; ++frame) {
    all.swaps = all.frame = static_cast<uint64_t>(frame);
    const double angle = 0.1 * frame;
    all.eyeFromWorld = glm::rotate(glm::translate(glm::dmat4(1), {0, 0, -5}), angle, {0.2, 1, 0.1});
    for (scene::Instance& instance : all.instances) instance.eyeFromObject = all.eyeFromWorld;
    expectOneImage(job, ranks, all);
  }
}

INSTANTIATE_TEST_SUITE_P(Jobs, PeersTest,
                         testing::Values(Setup{2, 2}, Setup{3, 3}, Setup{5, 5}, Setup{3, 1}, Setup{4, 2}),
                         [](const auto& info) {
                           return "Ranks" + std::to_string(info.param.ranks) + "Workers" +
                                  std::to_string(info.param.workers);
                         });

class PeersFaultsTest : public PeersTest {};

TEST_F(PeersFaultsTest, RankThatDrawsNothingIsLeftOut) {
  WorkerJob job(directory_, 3);
  test::ProgramRanks ranks(directory_, 3, 2);  // the third one never joins
  const scene::Snapshot all = plates(64);
  const scene::Snapshot two = partsOf(all, {0, 1}, 3);
  for (int frame = 1; frame < 6; ++frame) {
    std::vector<scene::Snapshot> parts = {partOf(all, 0, 3), partOf(all, 1, 3)};
    parts[0].swaps = parts[1].swaps = static_cast<uint64_t>(frame);
    EXPECT_EQ(differing(composed(ranks.images(parts)), expectedImage(two)), 0) << frame << job.said();
  }
  EXPECT_NE(job.said().find("rank 2 of the program draws nothing here"), std::string::npos) << job.said();
}

TEST_F(PeersFaultsTest, CountsOfFramesMayDiffer) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks ranks(directory_, 2);
  const scene::Snapshot all = plates(64);
  for (int frame = 1; frame < 4; ++frame) {
    std::vector<scene::Snapshot> parts = {partOf(all, 0, 2), partOf(all, 1, 2)};
    parts[0].swaps = static_cast<uint64_t>(frame), parts[1].swaps = static_cast<uint64_t>(frame + 7);
    EXPECT_EQ(differing(composed(ranks.images(parts)), expectedImage(all)), 0);
  }
}

/// The scene that a rank still holds is that of the frame before, also where the program never swaps.
TEST_F(PeersFaultsTest, RankThatIsLateLightsWithItsNewScene) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks ranks(directory_, 2);
  scene::Snapshot all = plates(64);
  for (int step = 0; step < 3; ++step) {
    ++all.viewFrame;
    const std::vector<scene::Snapshot> parts = {partOf(all, 0, 2), partOf(all, 1, 2)};
    auto first = std::async(std::launch::async, [&] { return ranks.program(0).image(parts[0]); });
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    Image late = ranks.program(1).image(parts[1]);
    EXPECT_EQ(differing(composed({first.get(), std::move(late)}), expectedImage(all)), 0) << step;
    for (size_t i = 1; i < all.instances.size(); i += 2) {
      all.instances[i].eyeFromObject[3][0] += 0.2;
      all.instances[i].worldFromObject[3][0] += 0.2f;
    }
  }
}

TEST_F(PeersFaultsTest, RankThatEndsLeavesTheOthers) {
  WorkerJob job(directory_, 3);
  test::ProgramRanks ranks(directory_, 3);
  const scene::Snapshot all = plates(64);
  EXPECT_EQ(differing(composed(ranks.images(all)), expectedImage(all)), 0);
  ranks.end(2);
  const scene::Snapshot two = partsOf(all, {0, 1}, 3);
  for (int frame = 2; frame < 4; ++frame) {
    std::vector<scene::Snapshot> parts = {partOf(all, 0, 3), partOf(all, 1, 3)};
    parts[0].swaps = parts[1].swaps = static_cast<uint64_t>(frame);
    EXPECT_EQ(differing(composed(ranks.images(parts)), expectedImage(two)), 0) << frame << job.said();
  }
}

TEST_F(PeersFaultsTest, StoppedRankIsLeftOut) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks ranks(directory_, 2);
  const scene::Snapshot all = plates(64);
  EXPECT_EQ(differing(composed(ranks.images(all)), expectedImage(all)), 0);
  job.rank(1).isDeaf = true;
  scene::Snapshot part = partOf(all, 0, 2);
  part.swaps = 2;
  EXPECT_EQ(differing(ranks.program(0).image(part), expectedImage(part)), 0);
  job.rank(1).isDeaf = false;
  std::vector<scene::Snapshot> parts = {partOf(all, 0, 2), partOf(all, 1, 2)};
  for (int frame = 3; frame < 6; ++frame) {
    parts[0].swaps = parts[1].swaps = static_cast<uint64_t>(frame);
    const Image image = composed(ranks.images(parts));
    if (frame > 3) { EXPECT_EQ(differing(image, expectedImage(all)), 0) << frame; }
  }
}

}  // namespace
}  // namespace gluray::cluster
