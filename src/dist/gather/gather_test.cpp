// Parts of a view that one worker gathers: the composed picture is that of one process, whatever light does.
#include "dist/peers/program_ranks.h"
#include "scene/surroundings.h"

#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace gluray::dist {
namespace {

using test::composed;
using test::differing;
using test::expectedPicture;
using test::partOf;
using test::partsOf;
using test::WorkerJob;

scene::Snapshot gatheredPlates(int size = 64) {
  scene::Snapshot all = test::plates(size);
  all.number = 1;
  all.settings.gather = true;
  return all;
}

bool isEmpty(const Image& image) {
  return std::ranges::all_of(image.depth, [](float depth) { return depth == Image::kMiss; });
}

struct GatherTest : testing::Test {
  /// All ranks draw, and the first shows it all.
  static void expectGathered(WorkerJob& job, test::ProgramRanks& programs, const scene::Snapshot& all,
                             int ranks) {
    std::vector<int> everyone;
    for (int rank = 0; rank < ranks; ++rank) everyone.push_back(rank);
    std::vector<Image> pictures = programs.pictures(all);
    for (int rank = 1; rank < ranks; ++rank)
      EXPECT_TRUE(isEmpty(pictures[static_cast<size_t>(rank)])) << rank << job.said();
    EXPECT_EQ(differing(composed(std::move(pictures)), expectedPicture(partsOf(all, everyone, ranks))), 0)
        << job.said();
    EXPECT_TRUE(programs.allByWorkers());
  }
  test::RuntimeFolder folder_;
  const std::string directory_ = folder_.directory();
};

struct Light {
  const char* name;
  std::function<void(scene::Snapshot&)> change;
};
class GatheredLightTest : public GatherTest, public testing::WithParamInterface<Light> {};

TEST_P(GatheredLightTest, IsThatOfOneProcess) {
  constexpr int kRanks = 3;
  WorkerJob job(directory_, kRanks);
  test::ProgramRanks programs(directory_, kRanks);
  scene::Snapshot all = gatheredPlates();
  GetParam().change(all);
  std::vector<Image> alone;
  for (int rank = 0; rank < kRanks; ++rank) alone.push_back(expectedPicture(partOf(all, rank, kRanks)));
  EXPECT_GT(differing(composed(std::move(alone)), expectedPicture(all)), 50) << "light crosses no ranks";
  for (int frame = 1; frame < 4; ++frame) {
    all.frame = all.number = static_cast<uint64_t>(frame);
    all.eyeFromWorld = glm::rotate(all.eyeFromWorld, 0.1, {0.2, 1, 0.1});
    for (scene::Instance& instance : all.instances) instance.eyeFromObject = all.eyeFromWorld;
    expectGathered(job, programs, all, kRanks);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, GatheredLightTest,
    testing::Values(Light{"OcclusionAndShadows", [](scene::Snapshot&) {}},
                    Light{"Paths", [](scene::Snapshot& s) { s.settings.integrator = LightIntegrator::path; }},
                    Light{"Mirrors",
                          [](scene::Snapshot& s) {
                            s.settings.integrator = LightIntegrator::path;
                            s.settings.material.kind = SurfaceMaterial::mirror;
                          }},
                    Light{"Ground", [](scene::Snapshot& s) { s.settings.ground.kind = GroundKind::plane; }}),
    [](const auto& info) { return std::string(info.param.name); });

TEST_F(GatherTest, PassesReuseTheParts) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 2);
  scene::Snapshot all = gatheredPlates();
  for (uint32_t pass = 0; pass < 3; ++pass) {
    all.lightSampling.pass = pass;
    expectGathered(job, programs, all, 2);
  }
  // The second rank's picture is finished: the first one's goes on without it.
  all.lightSampling.pass = 3;
  const Image last = programs.program(0).picture(partOf(all, 0, 2));
  EXPECT_EQ(differing(last, expectedPicture(partsOf(all, {0, 1}, 2))), 0) << job.said();
}

TEST_F(GatherTest, SeveralScenesOfAFrame) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 2);
  scene::Snapshot all = gatheredPlates();
  for (int frame = 1; frame < 4; ++frame)
    for (int scene = 0; scene < 3; ++scene) {
      all.frame = static_cast<uint64_t>(frame), ++all.number;
      all.instances.resize(static_cast<size_t>(8 - scene));
      expectGathered(job, programs, all, 2);
      if (scene == 2) all.instances = gatheredPlates().instances;
    }
  EXPECT_EQ(job.said().find("draws nothing here"), std::string::npos) << job.said();
}

/// Contexts that never swap have one frame.
TEST_F(GatherTest, ScenesWithoutFrames) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 3, 2);
  scene::Snapshot all = gatheredPlates();
  for (int scene = 0; scene < 40; ++scene) {
    ++all.number;
    all.instances[static_cast<size_t>(scene % 2)].eyeFromObject[3][2] += 0.01;
    const std::vector<scene::Snapshot> parts = {partOf(all, 0, 3), partOf(all, 1, 3)};
    const std::vector<Image> pictures = programs.pictures(parts);
    EXPECT_TRUE(isEmpty(pictures[1])) << scene;
    EXPECT_EQ(differing(pictures[0], expectedPicture(partsOf(all, {0, 1}, 3))), 0) << scene << job.said();
  }
  int waited = 0;
  std::istringstream said(job.said());
  for (std::string line; std::getline(said, line);) waited += line.find("draws nothing") != std::string::npos;
  EXPECT_EQ(waited, 2) << "each rank waits once: " << job.said();
}

TEST_F(GatherTest, BlendedSurfacesAreNotGathered) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 2);
  const scene::Snapshot all = gatheredPlates();
  std::vector<scene::Snapshot> parts = {partOf(all, 0, 2), partOf(all, 1, 2)};
  auto around = std::make_shared<scene::Surroundings>();
  around->shadings = all.shadings;
  around->instances = {all.instances.back()};
  around->blended = {1};
  parts[1].surroundings = around;
  const std::vector<Image> pictures = programs.pictures(parts);
  EXPECT_FALSE(isEmpty(pictures[0]));
  EXPECT_FALSE(isEmpty(pictures[1])) << "each rank draws its own";
  EXPECT_NE(job.said().find("rank 1 of the program blends surfaces"), std::string::npos) << job.said();
}

TEST_F(GatherTest, RankThatDrawsNothingIsLeftOut) {
  WorkerJob job(directory_, 3);
  test::ProgramRanks programs(directory_, 3, 2);  // the third one never joins
  scene::Snapshot all = gatheredPlates();
  for (int frame = 1; frame < 4; ++frame) {
    all.frame = all.number = static_cast<uint64_t>(frame);
    const std::vector<Image> pictures = programs.pictures({partOf(all, 0, 3), partOf(all, 1, 3)});
    EXPECT_TRUE(isEmpty(pictures[1]));
    EXPECT_EQ(differing(pictures[0], expectedPicture(partsOf(all, {0, 1}, 3))), 0) << job.said();
  }
  EXPECT_NE(job.said().find("rank 2 of the program draws nothing here"), std::string::npos) << job.said();
}

TEST_F(GatherTest, FirstRankMayDrawNothing) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 3);
  scene::Snapshot all = gatheredPlates();
  std::vector<std::future<Image>> coming;
  for (const int rank : {1, 2})
    coming.push_back(std::async(std::launch::async,
                                [&, rank] { return programs.program(rank).picture(partOf(all, rank, 3)); }));
  EXPECT_EQ(differing(coming[0].get(), expectedPicture(partsOf(all, {1, 2}, 3))), 0) << job.said();
  EXPECT_TRUE(isEmpty(coming[1].get()));
}

TEST_F(GatherTest, RankThatEndsIsGone) {
  WorkerJob job(directory_, 3);
  test::ProgramRanks programs(directory_, 3);
  scene::Snapshot all = gatheredPlates();
  expectGathered(job, programs, all, 3);
  programs.end(2);
  all.frame = all.number = 2;
  const std::vector<scene::Snapshot> parts = {partOf(all, 0, 3), partOf(all, 1, 3)};
  const std::vector<Image> pictures = programs.pictures(parts);
  EXPECT_EQ(differing(pictures[0], expectedPicture(partsOf(all, {0, 1}, 3))), 0) << job.said();
}

/// Nothing is lost: whoever is not gathered draws its own surfaces.
TEST_F(GatherTest, StoppedRankDrawsItsOwnPartWhenItGoesOn) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 2);
  scene::Snapshot all = gatheredPlates();
  expectGathered(job, programs, all, 2);
  job.rank(1).isDeaf = true;
  all.frame = all.number = 2;
  const scene::Snapshot part = partOf(all, 0, 2);
  EXPECT_EQ(differing(programs.program(0).picture(part), expectedPicture(part)), 0) << job.said();
  job.rank(1).isDeaf = false;
  const Image late = programs.program(1).picture(partOf(all, 1, 2));
  EXPECT_FALSE(isEmpty(late)) << job.said();
  for (uint64_t frame = 3; frame < 6; ++frame) {
    all.frame = all.number = frame;
    const Image image = composed(programs.pictures(all));
    if (frame > 3) { EXPECT_EQ(differing(image, expectedPicture(partsOf(all, {0, 1}, 2))), 0) << job.said(); }
  }
}

TEST_F(GatherTest, SwitchedOnWhileTheProgramRuns) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 2);
  scene::Snapshot all = gatheredPlates();
  all.settings.gather = false;
  programs.pictures(all);
  all.settings.gather = true;
  all.frame = all.number = 2;
  expectGathered(job, programs, all, 2);
  all.settings.gather = false;
  all.frame = all.number = 3;
  EXPECT_FALSE(isEmpty(programs.pictures(all)[1]));
}

}  // namespace
}  // namespace gluray::dist
