// Frames of animations on the ranks of a sort-last program: each smooths the light of its own surfaces, which
// those of the others block.
#include "cluster/peers/part_changes.h"
#include "cluster/testing/program_ranks.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace gluray::cluster {
namespace {

using test::differing;
using test::partOf;
using test::WorkerJob;

constexpr int kFrames = 4;  // after so many fast frames the next one takes more rays

/// The camera turns; the light stays.
scene::Snapshot movingPlates(int frame) {
  scene::Snapshot s = test::plates(96);
  s.lightSampling.mode = scene::LightSampling::Mode::moving;
  s.swaps = s.frame = static_cast<uint64_t>(frame + 1);
  s.settings.fps = 0.1f;  // time enough: the number of rays stays
  s.eyeFromWorld = glm::rotate(glm::translate(glm::dmat4(1), {0, 0, -5}), 0.02 * frame, {0.2, 1, 0.1});
  glm::vec4& light = s.shadings[0].lights[0].position;
  light = glm::vec4(s.eyeFromWorld * glm::dvec4(light));
  for (scene::Instance& instance : s.instances)
    instance.eyeFromObject = s.eyeFromWorld * glm::dmat4(instance.worldFromObject);
  return s;
}

/// One process that shows the rank's part, and has the others around it.
scene::Snapshot surroundedPart(const scene::Snapshot& all, int rank, int ranks) {
  scene::Snapshot part = partOf(all, rank, ranks);
  auto around = std::make_shared<scene::SecondaryScene>();
  around->shadings = all.shadings;
  for (int other = 0; other < ranks; ++other) {
    if (other == rank) continue;
    for (const scene::Instance& instance : partOf(all, other, ranks).instances)
      around->instances.push_back(instance);
  }
  around->blended.resize(around->instances.size());
  part.secondaryScene = around;
  return part;
}

struct JobOfParts {
  int ranks, workers;
};

class MovingParts : public testing::TestWithParam<JobOfParts> {
 protected:
  test::RuntimeFolder folder_;

  /// `change`: of each frame.
  template <class Change>
  void expectFramesOfOneProcess(const Change& change) {
    const auto [count, workers] = GetParam();
    WorkerJob job(folder_.directory(), workers);
    test::ProgramRanks ranks(folder_.directory(), count);
    std::vector<frame::Renderer> one(static_cast<size_t>(count));
    for (int frame = 0; frame < kFrames; ++frame) {
      scene::Snapshot all = movingPlates(frame);
      change(all, frame);
      all.settings.depthFirst = false;  // otherwise they are not lit where others hide them
      const std::vector<Image> parts = ranks.images(all);
      for (int rank = 0; rank < count; ++rank) {
        const auto at = static_cast<size_t>(rank);
        scene::Snapshot part = surroundedPart(all, rank, count);
        EXPECT_EQ(differing(parts[at], imageOf(one[at], part)), 0)
            << "frame " << frame << " rank " << rank << job.said();
        part.lightSampling.mode = scene::LightSampling::Mode::full;
        EXPECT_GT(differing(parts[at], test::expectedImage(part)), 100) << "it is not smoothed";
      }
    }
    EXPECT_TRUE(ranks.allByWorkers());
  }

  static Image imageOf(frame::Renderer& renderer, const scene::Snapshot& s) {
    Image image;
    scene::TraceCost cost;
    std::string error;
    EXPECT_TRUE(renderer.render(s, image, cost, error)) << error;
    return image;
  }
};

TEST_P(MovingParts, AreLitAsThoseOfOneProcess) {
  expectFramesOfOneProcess([](scene::Snapshot&, int) {});
}

TEST_P(MovingParts, WithSoftShadows) {
  expectFramesOfOneProcess([](scene::Snapshot& s, int) {
    s.settings.shadows.enabled = true;
    s.settings.shadows.size = 5;
  });
}

/// What earlier frames know of light counts less where surfaces of any rank have moved.
TEST_P(MovingParts, WithSurfacesThatMoveAndComeAndGo) {
  expectFramesOfOneProcess([](scene::Snapshot& s, int frame) {
    s.instances[4].worldFromObject[3].x += 0.1f * static_cast<float>(frame);
    s.instances[4].eyeFromObject = s.eyeFromWorld * glm::dmat4(s.instances[4].worldFromObject);
    if (frame == 3) s.instances.pop_back();
  });
}

/// The index of the image in front at a pixel.
size_t frontOf(const std::vector<Image>& parts, size_t pixel) {
  size_t front = 0;
  for (size_t rank = 1; rank < parts.size(); ++rank)
    if (parts[rank].depth[pixel] < parts[front].depth[pixel]) front = rank;
  return front;
}

/// Pixels behind those of other parts keep the look and the depth that they have without light. Returns how
/// many there are.
int expectNoLightBehind(const std::vector<Image>& parts, const std::vector<Image>& unlit) {
  int hidden = 0;
  for (size_t i = 0; i < parts[0].depth.size(); ++i) {
    const float front = parts[frontOf(parts, i)].depth[i];
    for (size_t rank = 0; rank < parts.size(); ++rank) {
      EXPECT_EQ(parts[rank].depth[i], unlit[rank].depth[i]);
      if (parts[rank].depth[i] == Image::kMiss || parts[rank].depth[i] < front + 1e-3f) continue;
      EXPECT_EQ(parts[rank].color[i], unlit[rank].color[i]);
      ++hidden;
    }
  }
  return hidden;
}

/// Root mean square of the difference of red, 0 .. 255.
double errorOf(const Image& image, const Image& truth) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < truth.depth.size(); ++i) {
    if (truth.depth[i] == Image::kMiss) continue;
    const int off = static_cast<int>(image.color[i] & 255) - static_cast<int>(truth.color[i] & 255);
    sum += off * off, ++count;
  }
  return std::sqrt(sum / count);
}

/// Smoothing no longer reads what other ranks hide: that changes noise at edges.
TEST_P(MovingParts, AreNotLitWhereOthersHideThem) {
  const auto [count, workers] = GetParam();
  WorkerJob job(folder_.directory(), workers);
  test::ProgramRanks ranks(folder_.directory(), count);
  frame::Renderer one;
  for (int frame = 0; frame < kFrames; ++frame) {
    scene::Snapshot all = movingPlates(frame);
    const std::vector<Image> parts = ranks.images(all);
    const Image single = imageOf(one, all);
    all.lightSampling.mode = scene::LightSampling::Mode::full;
    all.settings.ao.samples = 64;
    const Image truth = test::expectedImage(all);
    all.settings.ao.enabled = all.settings.shadows.enabled = false;
    std::vector<Image> unlit;
    for (int rank = 0; rank < count; ++rank) unlit.push_back(test::expectedImage(partOf(all, rank, count)));
    EXPECT_GT(expectNoLightBehind(parts, unlit), 100);
    EXPECT_LT(errorOf(test::composed(parts), truth), 1.1 * errorOf(single, truth)) << frame;
  }
}

INSTANTIATE_TEST_SUITE_P(Jobs, MovingParts, testing::Values(JobOfParts{2, 2}, JobOfParts{3, 1}),
                         [](const auto& info) {
                           return "Ranks" + std::to_string(info.param.ranks) + "Workers" +
                                  std::to_string(info.param.workers);
                         });

/// A view of the parts of two ranks, as the first one sees them.
class PartChangesTest : public testing::Test {
 protected:
  /// The state of the other rank, which has moved by `shift` in the world.
  static PartState other(uint64_t changes, const glm::dmat4& eyeFromWorld, double shift = 0) {
    return {1, changes, eyeFromWorld * glm::translate(glm::dmat4(1), {shift, 0, 3})};
  }
  bool changed(const PartState& other, const glm::dmat4& eyeFromWorld) {
    PartState own = changes_.show(empty_, nullptr);
    own.eyeFromLargest = eyeFromWorld;
    return changes_.changed({own, other});
  }
  PartChanges changes_;
  scene::Snapshot empty_;
  const glm::dmat4 turned_ = glm::rotate(glm::translate(glm::dmat4(1), {1, 2, 3}), 0.3, {0, 1, 0});
};

TEST_F(PartChangesTest, OfAViewThatIsNew) {
  const glm::dmat4 first(1);
  EXPECT_TRUE(changed(other(1, first), first));
  EXPECT_TRUE(changed(other(1, first), first)) << "nothing was kept";
  changes_.keep();
  EXPECT_FALSE(changed(other(1, first), first));
  empty_.view = 1;
  EXPECT_TRUE(changed(other(1, first), first)) << "of another view";
}

TEST_F(PartChangesTest, CamerasChangeNothing) {
  changed(other(1, glm::dmat4(1)), glm::dmat4(1)), changes_.keep();
  EXPECT_FALSE(changed(other(1, turned_), turned_));
}

TEST_F(PartChangesTest, PartsThatMoveAgainstEachOther) {
  changed(other(1, glm::dmat4(1)), glm::dmat4(1)), changes_.keep();
  EXPECT_TRUE(changed(other(1, turned_, 0.1), turned_));
  EXPECT_TRUE(changed(other(1, turned_, 0.1), turned_)) << "no moving frame has been whole since";
  changes_.keep();
  EXPECT_FALSE(changed(other(1, turned_, 0.1), turned_));
}

TEST_F(PartChangesTest, PartsThatChange) {
  const glm::dmat4 eye(1);
  changed(other(1, eye), eye), changes_.keep();
  EXPECT_TRUE(changed(other(2, eye), eye));
  EXPECT_TRUE(changes_.changed({changes_.show(empty_, nullptr)})) << "the other is gone";
}

TEST_F(PartChangesTest, WhatIsNoNumberHasChanged) {
  const glm::dmat4 eye(1);
  const auto broken = other(1, glm::dmat4(std::nan("")));
  changed(broken, eye), changes_.keep();
  EXPECT_TRUE(changed(broken, eye));
}

}  // namespace
}  // namespace gluray::cluster
