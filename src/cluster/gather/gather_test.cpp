// Which parts of a view one worker gathers, where ranks draw nothing, stop, end, or draw otherwise.
#include "cluster/testing/gather_fixture.h"
#include "scene/backdrop.h"

#include <glm/gtc/matrix_transform.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace gluray::cluster {
namespace {

using test::composed;
using test::differing;
using test::expectedImage;
using test::gatheredPlates;
using test::partOf;
using test::partsOf;
using test::setBounds;
using test::WorkerJob;

struct GatherTest : test::GatherFixture {
  /// The second of two ranks has its data `x` to the right.
  static scene::Snapshot apart(scene::Snapshot all, double x) {
    setBounds(all);
    for (size_t i = 1; i < all.instances.size(); i += 2) {
      const glm::dmat4 moved = glm::translate(glm::dmat4(1), {x, 0, 0});
      all.instances[i].worldFromObject = moved;
      all.instances[i].eyeFromObject = all.eyeFromWorld * moved;
    }
    return all;
  }
  static scene::Snapshot seenFrom(scene::Snapshot all, double x, uint64_t number) {
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), {-x, 0, 0});
    all.number = number;
    all.eyeFromWorld = moved * all.eyeFromWorld;
    for (scene::Instance& instance : all.instances) instance.eyeFromObject = moved * instance.eyeFromObject;
    return all;
  }
};

TEST_F(GatherTest, SeveralScenesOfAFrame) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 2);
  scene::Snapshot all = gatheredPlates();
  for (int frame = 1; frame < 4; ++frame)
    for (int scene = 0; scene < 3; ++scene) {
      all.swaps = all.frame = static_cast<uint64_t>(frame), ++all.number;
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
  for (int scene = 0; scene < 20; ++scene) {
    ++all.number;
    all.instances[static_cast<size_t>(scene % 2)].eyeFromObject[3][2] += 0.01;
    const std::vector<scene::Snapshot> parts = {partOf(all, 0, 3), partOf(all, 1, 3)};
    const std::vector<Image> images = programs.images(parts);
    for (const Image& image : images)
      EXPECT_EQ(differing(image, expectedImage(partsOf(all, {0, 1}, 3))), 0) << scene << job.said();
  }
  int waited = 0;
  std::istringstream said(job.said());
  for (std::string line; std::getline(said, line);) waited += line.find("draws nothing") != std::string::npos;
  EXPECT_EQ(waited, 2) << "each rank waits once: " << job.said();
}

/// The camera passes from one rank's data to those of the other.
TEST_F(GatherTest, RanksMissScenesWhereTheirDataLieOutside) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 2);
  const scene::Snapshot all = apart(gatheredPlates(), 4);
  uint64_t number = 0;
  for (const double camera : {2.0, 0.0, 2.0, 5.5, 2.2, 0.0, 0.1, 2.0, 5.5, 5.4, 5.5, 1.8, 2.0}) {
    const scene::Snapshot scene = seenFrom(all, camera, ++number);
    const bool first = camera<5, second = camera> 1;
    std::future<Image> other = std::async(std::launch::async, [&] {
      return second ? programs.program(1).image(partOf(scene, 1, 2)) : Image();
    });
    std::vector<Image> images;
    if (first) images.push_back(programs.program(0).image(partOf(scene, 0, 2)));
    if (Image image = other.get(); second) images.push_back(std::move(image));
    const std::vector<int> drawn = !first ? std::vector{1} : second ? std::vector{0, 1} : std::vector{0};
    const Image expected = expectedImage(partsOf(scene, drawn, 2));
    for (const Image& image : images)
      EXPECT_EQ(differing(image, expected), 0) << "scene " << number << job.said();
  }
}

/// Views of one size, of which each rank misses another one in all frames.
TEST_F(GatherTest, RanksMissViews) {
  WorkerJob job(directory_, 1);
  test::ProgramRanks programs(directory_, 3);
  scene::Snapshot all = gatheredPlates();
  expectGathered(job, programs, all, 3);
  for (uint64_t scene = 0; scene < 15; ++scene) {
    all.number = scene + 2, all.view = 1 + scene % 3;
    std::vector<std::future<Image>> images;
    std::vector<int> drawn;
    for (int rank = 0; rank < 3; ++rank)
      if (rank != static_cast<int>(scene % 3)) drawn.push_back(rank);
    for (const int rank : drawn)
      images.push_back(std::async(std::launch::async,
                                  [&, rank] { return programs.program(rank).image(partOf(all, rank, 3)); }));
    const Image expected = expectedImage(partsOf(all, drawn, 3));
    for (std::future<Image>& image : images)
      EXPECT_EQ(differing(image.get(), expected), 0) << "scene " << scene << job.said();
  }
  std::istringstream said(job.said());
  int waited = 0;
  for (std::string line; std::getline(said, line);) waited += line.find("draws nothing") != std::string::npos;
  EXPECT_EQ(waited, 6) << "two ranks wait once in each view: " << job.said();
}

TEST_F(GatherTest, BlendedSurfacesAreNotGathered) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 2);
  const scene::Snapshot all = gatheredPlates();
  std::vector<scene::Snapshot> parts = {partOf(all, 0, 2), partOf(all, 1, 2)};
  auto around = std::make_shared<scene::SecondaryScene>();
  around->shadings = all.shadings;
  around->instances = {all.instances.back()};
  around->blended = {1};
  parts[1].secondaryScene = around;
  parts[0].settings.background.kind = BackgroundKind::color;
  parts[0].backdrop = std::make_shared<scene::Backdrop>();
  const std::vector<Image> images = programs.images(parts);
  for (size_t rank = 0; rank < 2; ++rank)
    EXPECT_EQ(images[rank].depth, expectedImage(parts[rank]).depth) << "each rank draws its own";
  EXPECT_NE(job.said().find("rank 1 of the program blends surfaces"), std::string::npos) << job.said();
  for (int rank = 0; rank < 2; ++rank)
    EXPECT_NE(programs.program(rank).said.find("blends surfaces: each rank traces its own part"),
              std::string::npos);
  EXPECT_NE(programs.program(0).said.find("background are left out"), std::string::npos);
  EXPECT_EQ(programs.program(1).said.find("background are left out"), std::string::npos) << "it has none";
}

TEST_F(GatherTest, RankThatDrawsNothingIsLeftOut) {
  WorkerJob job(directory_, 3);
  test::ProgramRanks programs(directory_, 3, 2);  // the third one never joins
  scene::Snapshot all = gatheredPlates();
  for (int frame = 1; frame < 4; ++frame) {
    all.swaps = all.frame = all.number = static_cast<uint64_t>(frame);
    const std::vector<Image> images = programs.images({partOf(all, 0, 3), partOf(all, 1, 3)});
    for (const Image& image : images)
      EXPECT_EQ(differing(image, expectedImage(partsOf(all, {0, 1}, 3))), 0) << job.said();
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
                                [&, rank] { return programs.program(rank).image(partOf(all, rank, 3)); }));
  for (std::future<Image>& one : coming)
    EXPECT_EQ(differing(one.get(), expectedImage(partsOf(all, {1, 2}, 3))), 0) << job.said();
}

TEST_F(GatherTest, RankThatEndsIsGone) {
  WorkerJob job(directory_, 3);
  test::ProgramRanks programs(directory_, 3);
  scene::Snapshot all = gatheredPlates();
  expectGathered(job, programs, all, 3);
  programs.end(2);
  all.swaps = all.frame = all.number = 2;
  const std::vector<scene::Snapshot> parts = {partOf(all, 0, 3), partOf(all, 1, 3)};
  const std::vector<Image> images = programs.images(parts);
  EXPECT_EQ(differing(images[0], expectedImage(partsOf(all, {0, 1}, 3))), 0) << job.said();
}

/// Nothing is lost: whoever is not gathered draws its own surfaces.
TEST_F(GatherTest, StoppedRankDrawsItsOwnPartWhenItGoesOn) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 2);
  scene::Snapshot all = gatheredPlates();
  expectGathered(job, programs, all, 2);
  job.rank(1).isDeaf = true;
  all.swaps = all.frame = all.number = 2;
  const scene::Snapshot part = partOf(all, 0, 2);
  EXPECT_EQ(differing(programs.program(0).image(part), expectedImage(part)), 0) << job.said();
  job.rank(1).isDeaf = false;
  const Image late = programs.program(1).image(partOf(all, 1, 2));
  EXPECT_EQ(differing(late, expectedImage(partOf(all, 1, 2))), 0) << job.said();
  for (uint64_t frame = 3; frame < 6; ++frame) {
    all.swaps = all.frame = all.number = frame;
    const Image image = composed(programs.images(all));
    if (frame > 3) { EXPECT_EQ(differing(image, expectedImage(partsOf(all, {0, 1}, 2))), 0) << job.said(); }
  }
}

TEST_F(GatherTest, SwitchedOnWhileTheProgramRuns) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 2);
  scene::Snapshot all = gatheredPlates();
  all.settings.gather = false;
  programs.images(all);
  all.settings.gather = true;
  all.swaps = all.frame = all.number = 2;
  expectGathered(job, programs, all, 2);
  all.settings.gather = false;
  all.swaps = all.frame = all.number = 3;
  const Image own = programs.images(all)[1];
  EXPECT_EQ(own.depth, expectedImage(partOf(all, 1, 2)).depth) << "its own part";
}

}  // namespace
}  // namespace gluray::cluster
