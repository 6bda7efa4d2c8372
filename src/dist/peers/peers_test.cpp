// Light across the ranks of a sort-last program: composed by depth, their pictures are that of one process.
#include "dist/worker/job_fixture.h"
#include "render/integrators/lit_scene.h"

#include <future>
#include <string>

namespace gluray::dist {
namespace {

using test::expectedPicture;
using test::Program;
using test::WorkerJob;

/// A wall, and plates before it that darken it and each other.
scene::Snapshot plates(int size = 100) {
  using gluray::test::parallelogram;
  std::vector<scene::MeshPtr> meshes = {gluray::test::wall(3)};
  for (int i = 0; i < 7; ++i) {
    const float t = static_cast<float>(i);
    meshes.push_back(parallelogram({0.4f * t - 1.3f, 0.3f * t - 0.9f, 0.2f + 0.1f * t},
                                   {0.3f, 0.05f * t, 0.1f}, {-0.15f, 0.4f, 0.03f * t}));
  }
  scene::Snapshot s = gluray::test::litView(meshes, gluray::test::Shader::fixedFunction, {0.4f, 0.5f, 1, 0});
  s.shadings[0].globalAmbient = {0.5f, 0.5f, 0.5f, 1};
  for (scene::Instance& instance : s.instances) instance.materials[0].front.ambient = glm::vec4(1);
  s.camera.viewport = {0, 0, size, size}, s.region = {0, 0, size, size};
  s.settings.ao.enabled = true;
  s.settings.ao.samples = 4;
  return s;
}

/// What rank `rank` of `ranks` has of the scene: every so manieth instance.
scene::Snapshot partOf(const scene::Snapshot& all, int rank, int ranks) {
  scene::Snapshot part = all;
  part.instances.clear();
  for (size_t i = 0; i < all.instances.size(); ++i)
    if (static_cast<int>(i) % ranks == rank) part.instances.push_back(all.instances[i]);
  return part;
}

/// The ranks of one program.
class Ranks {
 public:
  Ranks(const std::string& directory, int ranks, int started) : ranks_(ranks) {
    for (int rank = 0; rank < started; ++rank)
      programs_.push_back(std::make_unique<Program>(directory, MpiPlace{rank, "mpi", rank, ranks}));
  }
  Ranks(const std::string& directory, int ranks) : Ranks(directory, ranks, ranks) {}

  /// Each rank's picture of its part of the scene, traced at the same time.
  std::vector<Image> pictures(const std::vector<scene::Snapshot>& parts) {
    std::vector<std::future<Image>> coming;
    for (size_t i = 0; i < parts.size(); ++i)
      coming.push_back(std::async(std::launch::async, [&, i] { return programs_[i]->picture(parts[i]); }));
    std::vector<Image> images;
    for (auto& one : coming) images.push_back(one.get());
    return images;
  }
  std::vector<Image> pictures(const scene::Snapshot& all) {
    std::vector<scene::Snapshot> parts;
    for (size_t i = 0; i < programs_.size(); ++i) parts.push_back(partOf(all, static_cast<int>(i), ranks_));
    return pictures(parts);
  }
  Program& program(int rank) { return *programs_[static_cast<size_t>(rank)]; }
  void end(int rank) { programs_[static_cast<size_t>(rank)].reset(); }
  bool allByWorkers() const {
    return std::ranges::all_of(programs_, [](const auto& p) { return !p || p->tracedHere == 0; });
  }

 private:
  int ranks_;
  std::vector<std::unique_ptr<Program>> programs_;
};

/// As IceT composes opaque pictures.
Image composed(std::vector<Image> images) {
  Image all = std::move(images[0]);
  for (size_t k = 1; k < images.size(); ++k)
    for (size_t i = 0; i < all.depth.size(); ++i) {
      if (!(images[k].depth[i] < all.depth[i])) continue;
      all.depth[i] = images[k].depth[i];
      all.color[i] = images[k].color[i];
    }
  return all;
}

int differing(const Image& a, const Image& b) {
  int count = 0;
  for (size_t i = 0; i < a.color.size(); ++i) count += a.color[i] != b.color[i] || a.depth[i] != b.depth[i];
  return count;
}

struct Setup {
  int ranks, workers;
};
class PeersTest : public testing::TestWithParam<Setup> {
 protected:
  void expectOnePicture(WorkerJob& job, Ranks& ranks, const scene::Snapshot& all) {
    EXPECT_EQ(differing(composed(ranks.pictures(all)), expectedPicture(all)), 0) << job.said();
    EXPECT_TRUE(ranks.allByWorkers());
  }
  /// Whether the test would notice if light did not cross ranks.
  static int differenceWithoutPeers(const scene::Snapshot& all, int ranks) {
    std::vector<Image> images;
    for (int rank = 0; rank < ranks; ++rank) images.push_back(expectedPicture(partOf(all, rank, ranks)));
    return differing(composed(std::move(images)), expectedPicture(all));
  }

  test::RuntimeFolder folder_;
  const std::string directory_ = folder_.directory();
};

TEST_P(PeersTest, OcclusionAndHardShadows) {
  WorkerJob job(directory_, GetParam().workers);
  Ranks ranks(directory_, GetParam().ranks);
  const scene::Snapshot all = plates();
  EXPECT_GT(differenceWithoutPeers(all, GetParam().ranks), 500);
  expectOnePicture(job, ranks, all);
}

TEST_P(PeersTest, SoftShadowsOfSeveralLights) {
  WorkerJob job(directory_, GetParam().workers);
  Ranks ranks(directory_, GetParam().ranks);
  scene::Snapshot all = plates();
  all.settings.ao.enabled = false;
  all.settings.shadows.size = 5, all.settings.shadows.samples = 4;
  scene::Light second = all.shadings[0].lights[0];
  second.position = {-1, 0.2f, 0.5f, 1};
  second.diffuse = {0.4f, 0.3f, 0.2f, 1};
  all.shadings[0].lights.push_back(second);
  expectOnePicture(job, ranks, all);
}

TEST_P(PeersTest, FramesAfterEachOther) {
  WorkerJob job(directory_, GetParam().workers);
  Ranks ranks(directory_, GetParam().ranks);
  scene::Snapshot all = plates(64);
  for (int frame = 1; frame <= 6; ++frame) {
    all.frame = static_cast<uint64_t>(frame);
    const double angle = 0.1 * frame;
    all.eyeFromWorld = glm::rotate(glm::translate(glm::dmat4(1), {0, 0, -5}), angle, {0.2, 1, 0.1});
    for (scene::Instance& instance : all.instances) instance.eyeFromObject = all.eyeFromWorld;
    expectOnePicture(job, ranks, all);
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
  Ranks ranks(directory_, 3, 2);  // the third one never joins
  const scene::Snapshot all = plates(64);
  scene::Snapshot two = all;
  two.instances = partOf(all, 0, 3).instances;
  for (const scene::Instance& instance : partOf(all, 1, 3).instances) two.instances.push_back(instance);
  for (int frame = 1; frame < 6; ++frame) {
    std::vector<scene::Snapshot> parts = {partOf(all, 0, 3), partOf(all, 1, 3)};
    parts[0].frame = parts[1].frame = static_cast<uint64_t>(frame);
    EXPECT_EQ(differing(composed(ranks.pictures(parts)), expectedPicture(two)), 0) << frame << job.said();
  }
  EXPECT_NE(job.said().find("rank 2 of the program draws nothing here"), std::string::npos) << job.said();
}

TEST_F(PeersFaultsTest, CountsOfFramesMayDiffer) {
  WorkerJob job(directory_, 2);
  Ranks ranks(directory_, 2);
  const scene::Snapshot all = plates(64);
  for (int frame = 1; frame < 4; ++frame) {
    std::vector<scene::Snapshot> parts = {partOf(all, 0, 2), partOf(all, 1, 2)};
    parts[0].frame = static_cast<uint64_t>(frame), parts[1].frame = static_cast<uint64_t>(frame + 7);
    EXPECT_EQ(differing(composed(ranks.pictures(parts)), expectedPicture(all)), 0);
  }
}

TEST_F(PeersFaultsTest, RankThatEndsLeavesTheOthers) {
  WorkerJob job(directory_, 3);
  Ranks ranks(directory_, 3);
  const scene::Snapshot all = plates(64);
  EXPECT_EQ(differing(composed(ranks.pictures(all)), expectedPicture(all)), 0);
  ranks.end(2);
  scene::Snapshot two = all;
  two.instances = partOf(all, 0, 3).instances;
  for (const scene::Instance& instance : partOf(all, 1, 3).instances) two.instances.push_back(instance);
  for (int frame = 2; frame < 4; ++frame) {
    std::vector<scene::Snapshot> parts = {partOf(all, 0, 3), partOf(all, 1, 3)};
    parts[0].frame = parts[1].frame = static_cast<uint64_t>(frame);
    EXPECT_EQ(differing(composed(ranks.pictures(parts)), expectedPicture(two)), 0) << frame << job.said();
  }
}

TEST_F(PeersFaultsTest, StoppedRankIsLeftOut) {
  WorkerJob job(directory_, 2);
  Ranks ranks(directory_, 2);
  const scene::Snapshot all = plates(64);
  EXPECT_EQ(differing(composed(ranks.pictures(all)), expectedPicture(all)), 0);
  job.rank(1).isDeaf = true;
  scene::Snapshot part = partOf(all, 0, 2);
  part.frame = 2;
  EXPECT_EQ(differing(ranks.program(0).picture(part), expectedPicture(part)), 0);
  job.rank(1).isDeaf = false;
  std::vector<scene::Snapshot> parts = {partOf(all, 0, 2), partOf(all, 1, 2)};
  for (int frame = 3; frame < 6; ++frame) {
    parts[0].frame = parts[1].frame = static_cast<uint64_t>(frame);
    const Image image = composed(ranks.pictures(parts));
    if (frame > 3) { EXPECT_EQ(differing(image, expectedPicture(all)), 0) << frame; }
  }
}

}  // namespace
}  // namespace gluray::dist
