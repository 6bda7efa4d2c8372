#include "accel/testing/test_scene.h"
#include "cluster/testing/job_fixture.h"

#include <string>

namespace gluray::cluster {
namespace {

using frame::test::litScene;
using test::expectedImage;
using test::expectSame;
using test::plainScene;
using test::Program;
using test::WorkerJob;

class WorkerTest : public testing::TestWithParam<int> {
 protected:
  test::RuntimeFolder folder_;
  const std::string directory_ = folder_.directory();
};

TEST_P(WorkerTest, ImagesAreThoseOfOneProcess) {
  WorkerJob job(directory_, GetParam());
  Program program(directory_);
  for (const scene::Snapshot& s : {plainScene(), plainScene(33), litScene(frame::test::Hides::some, 100)})
    expectSame(program.image(s, 0xFF203040u), expectedImage(s, 0xFF203040u));
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

TEST_P(WorkerTest, ChangedScenesAreTraced) {
  WorkerJob job(directory_, GetParam());
  Program program(directory_);
  scene::Snapshot s = plainScene();
  for (int i = 0; i < 5; ++i) {
    s.instances[0].color = {0.1f * static_cast<float>(i), 1, 0, 1};
    s.instances.push_back(s.instances[1]);
    s.instances.back().mesh = gluray::test::makeMesh(gluray::test::squareData(-0.1f * static_cast<float>(i)));
    expectSame(program.image(s), expectedImage(s));
  }
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

TEST_P(WorkerTest, GeometryIsSentOnce) {
  WorkerJob job(directory_, GetParam());
  Program program(directory_);
  scene::Snapshot s = plainScene(32);
  s.instances[0].mesh = gluray::test::makeMesh([] {
    gluray::test::MeshData data;
    for (int i = 0; i < 30000; ++i)
      data.positions.push_back(
          {static_cast<float>(i % 7), static_cast<float>(i % 11), -1e-4f * static_cast<float>(i)});
    return data;
  }());
  program.image(s);
  const uint64_t before = job.sentBytes();
  for (int i = 0; i < 4; ++i) program.image(s);
  EXPECT_LT(job.sentBytes() - before, 30000 * sizeof(glm::vec3)) << "of four frames";
}

TEST_P(WorkerTest, AveragesAndSamplesOfPixels) {
  WorkerJob job(directory_, GetParam());
  Program program(directory_);
  scene::Snapshot averages = plainScene();
  averages.settings.spp = 4;
  expectSame(program.image(averages), expectedImage(averages));
  scene::Snapshot samples = plainScene();
  samples.samples = 4;
  samples.samplePositions = {{0.4f, 0.1f}, {0.9f, 0.4f}, {0.1f, 0.6f}, {0.6f, 0.9f}};
  expectSame(program.image(samples), expectedImage(samples));
  scene::Snapshot wide = plainScene();
  wide.wideColors = true;
  expectSame(program.image(wide), expectedImage(wide));
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

TEST_P(WorkerTest, AveragesThatCannotBeComposited) {
  WorkerJob job(directory_, GetParam());
  Program program(directory_);
  scene::Snapshot s = plainScene();
  s.settings.spp = 4;
  s.instances[0].color = {1, 1, 1, 0.5f};
  const Image expected = expectedImage(s);
  EXPECT_FALSE(expected.isAverages());
  expectSame(program.image(s), expected);
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

TEST_P(WorkerTest, Layers) {
  WorkerJob job(directory_, GetParam());
  Program program(directory_);
  scene::Snapshot s = plainScene(100);
  auto layers = std::make_shared<scene::Layers>();
  layers->opaqueDepth.assign(100 * 100, -1);
  s.layers = layers;
  for (scene::Instance& instance : s.instances) instance.color.a = 0.5f;
  expectSame(program.image(s), expectedImage(s));
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

TEST_P(WorkerTest, PassesOverSomeTiles) {
  WorkerJob job(directory_, GetParam());
  Program program(directory_);
  scene::Snapshot s = litScene(frame::test::Hides::some, 100);
  Image image = program.image(s), expected = expectedImage(s);
  s.lightSampling.pass = 3;
  s.lightSampling.tiles = std::make_shared<std::vector<uint8_t>>(
      std::vector<uint8_t>{0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1});
  std::string error;
  scene::TraceCost cost;
  ASSERT_TRUE(program.tracer.trace(s, image, cost, error, nullptr));
  frame::Renderer renderer;
  ASSERT_TRUE(renderer.render(s, expected, cost, error));
  expectSame(image, expected);
}

TEST_P(WorkerTest, NothingIsHit) {
  WorkerJob job(directory_, GetParam());
  Program program(directory_);
  scene::Snapshot s = plainScene(50);
  s.instances.clear();
  expectSame(program.image(s, 7), expectedImage(s, 7));
  EXPECT_EQ(program.tracedHere, 0) << program.said;
}

TEST_P(WorkerTest, CallsThatAreStoppedReturn) {
  WorkerJob job(directory_, GetParam());
  Program program(directory_);
  scene::Snapshot s = litScene(frame::test::Hides::some, 200, 400);
  Image image;
  scene::TraceCost cost;
  std::string error;
  int asked = 0;
  EXPECT_FALSE(program.tracer.trace(s, image, cost, error, [&] { return ++asked > 2; }));
  EXPECT_EQ(error, "");
  s = plainScene();
  expectSame(program.image(s), expectedImage(s));
}

TEST_P(WorkerTest, ProgramsOfSeveralRanks) {
  const int ranks = GetParam();
  WorkerJob job(directory_, ranks);
  std::vector<std::thread> threads;
  for (int place = 0; place < ranks + 1; ++place)
    threads.emplace_back([&, place] {
      Program program(directory_, {place, "", 0, 1});
      for (int i = 0; i < 3; ++i) {
        const scene::Snapshot s = plainScene(40 + 10 * place);
        expectSame(program.image(s), expectedImage(s));
      }
      EXPECT_EQ(program.tracedHere, 0) << program.said;
    });
  for (std::thread& thread : threads) thread.join();
}

INSTANTIATE_TEST_SUITE_P(Ranks, WorkerTest, testing::Values(1, 2, 5));

}  // namespace
}  // namespace gluray::cluster
