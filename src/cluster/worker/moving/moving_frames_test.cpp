// Frames of animations with light: the ranks of a job smooth it together, as one process does.
#include "cluster/stream/visibility_bytes.h"
#include "cluster/testing/job_fixture.h"
#include "cluster/worker/moving/gathered_visibility.h"

#include <glm/gtc/matrix_transform.hpp>

#include <chrono>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace gluray::cluster::test {
namespace {

constexpr int kSize = 150;  // pixels: five tiles a side

/// The view of a frame, the camera turning; its light is that of a moving frame.
scene::Snapshot movingScene(int frame, int size = kSize) {
  scene::Snapshot s = frame::test::litScene(frame::test::Hides::some, size);
  s.lightSampling.mode = scene::LightSampling::Mode::moving;
  s.frame = static_cast<uint64_t>(frame + 1);
  s.settings.fps = 0.1f;  // time enough: the number of rays stays
  s.eyeFromWorld = s.eyeFromWorld * glm::rotate(glm::dmat4(1), 0.02 * frame, {0.2, 1.0, 0.1});
  for (scene::Instance& instance : s.instances)
    instance.eyeFromObject = s.eyeFromWorld * glm::dmat4(instance.worldFromObject);
  return s;
}

/// Traces with a renderer that keeps its history.
class OneProcess {
 public:
  Image image(const scene::Snapshot& s) {
    Image image;
    scene::TraceCost cost;
    std::string error;
    EXPECT_TRUE(renderer_.render(s, image, cost, error)) << error;
    return image;
  }

 private:
  frame::Renderer renderer_;
};

constexpr int kFrames = 4;  // after so many fast frames the next one takes more rays

class MovingFrames : public testing::TestWithParam<int> {
 protected:
  /// `change`: of each snapshot. Where a rank is slow the image is traced without it, and what it knew of
  /// earlier frames is lost: then the frames are traced once more.
  template <class Change>
  void expectSameFrames(const Change& change) {
    std::string said;
    for (int run = 0; run < 5; ++run) {
      WorkerJob job(folder_.directory(), GetParam());
      Program program(folder_.directory());
      OneProcess one;
      std::vector<std::pair<Image, Image>> frames;
      for (int frame = 0; frame < kFrames; ++frame) {
        scene::Snapshot s = movingScene(frame);
        change(s, frame);
        frames.emplace_back(program.image(s, 0xFF203040u), imageOn(one, s));
      }
      EXPECT_EQ(program.tracedHere, 0) << program.said;
      sent_ = job.sentBytes(), said = job.said();
      if (said.find("does not answer") != std::string::npos) continue;
      for (const auto& [shared, alone] : frames) expectSame(shared, alone);
      return;
    }
    FAIL() << said;
  }
  static Image imageOn(OneProcess& one, const scene::Snapshot& s) {
    Image image = one.image(s);
    for (size_t i = 0; i < image.color.size(); ++i)
      if (image.depth[i] == Image::kMiss && image.color[i] == 0) image.color[i] = 0xFF203040u;
    return image;
  }
  RuntimeFolder folder_;
  uint64_t sent_ = 0;  // bytes between ranks
};

TEST_P(MovingFrames, AreThoseOfOneProcess) {
  expectSameFrames([](scene::Snapshot&, int) {});
  constexpr uint64_t kBytesOfPixel = 8 + 8;  // visibility and image
  const uint64_t all = kFrames * kSize * kSize * kBytesOfPixel;
  if (GetParam() > 1) { EXPECT_GT(sent_, all / 4) << "other ranks trace a part"; }
}

TEST_P(MovingFrames, WithShadowsOfSeveralLights) {
  expectSameFrames([](scene::Snapshot& s, int) {
    s.settings.shadows.enabled = true;
    s.settings.lights.rig = LightRig::threePoint;
  });
}

TEST_P(MovingFrames, WithSurfacesThatMoveAndComeAndGo) {
  expectSameFrames([](scene::Snapshot& s, int frame) {
    s.instances[2].worldFromObject[3].x += 0.05f * static_cast<float>(frame);
    s.instances[2].eyeFromObject = s.eyeFromWorld * glm::dmat4(s.instances[2].worldFromObject);
    if (frame == 2) s.instances.pop_back();
  });
}

TEST_P(MovingFrames, WithoutSurfaces) {
  expectSameFrames([](scene::Snapshot& s, int) { s.instances.clear(); });
}

TEST_P(MovingFrames, ThatCannotBeSmoothed) {
  expectSameFrames([](scene::Snapshot& s, int) { s.settings.integrator = LightIntegrator::path; });
}

TEST_P(MovingFrames, ThatAverageSamples) {
  expectSameFrames([](scene::Snapshot& s, int frame) { s.settings.spp = frame == 1 ? 4 : 1; });
}

INSTANTIATE_TEST_SUITE_P(Ranks, MovingFrames, testing::Values(1, 2, 5));

class MovingFrameFaults : public testing::Test {
 protected:
  RuntimeFolder folder_;
};

TEST_F(MovingFrameFaults, ARankThatStopsIsLeftOut) {
  WorkerJob job(folder_.directory(), 3);
  Program program(folder_.directory());
  for (int frame = 0; frame < 8; ++frame) {
    job.rank(2).isDeaf = frame >= 2 && frame < 5;
    const scene::Snapshot s = movingScene(frame);
    OneProcess one;
    // What is known of earlier frames may be lost: the noise differs.
    EXPECT_LT(frame::test::difference(program.image(s), one.image(s)), 0.1) << frame;
  }
  EXPECT_NE(job.said().find("rank 2 does not answer"), std::string::npos) << job.said();
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

TEST_F(MovingFrameFaults, BroadcastsThatDoNotEndStopNoImage) {
  WorkerJob job(folder_.directory(), 3);
  Program program(folder_.directory());
  program.image(movingScene(0));
  job.rank(1).isSlow = true;
  OneProcess one;
  const scene::Snapshot s = movingScene(1);
  EXPECT_LT(frame::test::difference(program.image(s), one.image(s)), 0.1);
  job.rank(1).isSlow = false;
  for (int frame = 2; frame < 5; ++frame) program.image(movingScene(frame));
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

TEST_F(MovingFrameFaults, FramesThatAreCancelled) {
  WorkerJob job(folder_.directory(), 2);
  Program program(folder_.directory());
  for (int frame = 0; frame < 6; ++frame) {
    const scene::Snapshot s = movingScene(frame, 300);
    Image image;
    scene::TraceCost cost;
    std::string error;
    int asked = 0;
    program.tracer.trace(s, image, cost, error, [&] { return ++asked > frame; });
    EXPECT_EQ(error, "");
  }
  const scene::Snapshot s = movingScene(0);
  OneProcess one;
  EXPECT_LT(frame::test::difference(program.image(s), one.image(s)), 0.1);
}

render::VisibilityBuffer bufferOf(int width, int height, int channels) {
  render::VisibilityBuffer buffer;
  buffer.resize(width, height, channels);
  for (size_t i = 0; i < buffer.words.size(); ++i) buffer.words[i] = static_cast<uint32_t>(7 * i + 1);
  for (auto& plane : buffer.more)
    for (size_t i = 0; i < plane.size(); ++i) plane[i] = static_cast<uint16_t>(3 * i + 2);
  return buffer;
}

CollectedTile tileOf(const render::VisibilityBuffer& buffer, int tile) {
  return {1, shapeOf(buffer), tile, 0,
          packVisibility(buffer, render::Tiles(buffer.width, buffer.height, 32).at(tile))};
}

TEST(GatheredVisibility, ComeTogether) {
  const render::VisibilityBuffer buffer = bufferOf(70, 40, 4);  // 3 x 2 tiles
  GatheredVisibility parts(70, 40);
  for (int tile = 0; tile < 6; ++tile) {
    EXPECT_TRUE(parts.addTile(tile % 2, tileOf(buffer, tile)));
    EXPECT_FALSE(parts.addTile(1, tileOf(buffer, tile)));
  }
  EXPECT_EQ(parts.tilesOf(1), (std::vector<int32_t>{1, 3, 5}));
  EXPECT_FALSE(parts.isAwaited(1, 2));
  const Array bytes = parts.give();
  render::VisibilityBuffer copy;
  copy.resize(70, 40, 4);
  unpackVisibility(bytes.bytes, wholeOf(shapeOf(copy)), copy);
  EXPECT_TRUE(copy.words == buffer.words && copy.more == buffer.more);
  for (int tile = 0; tile < 6; ++tile) {
    EXPECT_FALSE(parts.isColored());
    EXPECT_TRUE(parts.isAwaited(tile % 2, tile));
    parts.setColored(tile);
  }
  EXPECT_TRUE(parts.isColored());
  EXPECT_FALSE(parts.isAwaited(0));
}

TEST(GatheredVisibility, OfOtherShapesAreRefused) {
  const render::VisibilityBuffer buffer = bufferOf(70, 40, 2);
  GatheredVisibility parts(70, 40);
  EXPECT_TRUE(parts.addTile(0, tileOf(buffer, 0)));
  const auto refused = [&](const auto& change) {
    CollectedTile tile = tileOf(buffer, 1);
    change(tile);
    EXPECT_THROW(parts.addTile(0, tile), Malformed);
  };
  refused([](CollectedTile& t) { t.tile = 6; });
  refused([](CollectedTile& t) { t.tile = -1; });
  refused([](CollectedTile& t) { t.shape.channels = 3; });
  refused([](CollectedTile& t) { t.shape.channels = 1 << 20; });
  refused([](CollectedTile& t) { t.shape.width = 71; });
  refused([](CollectedTile& t) { t.visibility.pop_back(); });
  refused([](CollectedTile& t) { t.visibility.clear(); });
  EXPECT_TRUE(parts.addTile(0, tileOf(buffer, 1)));
}

}  // namespace
}  // namespace gluray::cluster::test
