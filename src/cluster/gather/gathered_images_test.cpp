// Images of gathered parts, as all ranks and the composed view show them: those of one process.
#include "cluster/testing/gather_fixture.h"
#include "scene/backdrop.h"

#include <functional>
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

struct GatheredImagesTest : test::GatherFixture {};

struct Light {
  const char* name;
  std::function<void(scene::Snapshot&)> change;
};
class GatheredLightTest : public GatheredImagesTest, public testing::WithParamInterface<Light> {};

TEST_P(GatheredLightTest, IsThatOfOneProcess) {
  constexpr int kRanks = 3;
  WorkerJob job(directory_, kRanks);
  test::ProgramRanks programs(directory_, kRanks);
  scene::Snapshot all = gatheredPlates();
  GetParam().change(all);
  std::vector<Image> alone;
  for (int rank = 0; rank < kRanks; ++rank) alone.push_back(expectedImage(partOf(all, rank, kRanks)));
  EXPECT_GT(differing(composed(std::move(alone)), expectedImage(all)), 50) << "light crosses no ranks";
  for (int frame = 1; frame < 4; ++frame) {
    all.swaps = all.frame = all.number = static_cast<uint64_t>(frame);
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
                          }}),
    [](const auto& info) { return std::string(info.param.name); });

/// Programs compose of each rank's image what lies in the box of the rank's own data.
class ComposedInBoxesTest : public GatheredImagesTest, public testing::WithParamInterface<int> {};

TEST_P(ComposedInBoxesTest, IsThatOfOneProcess) {
  const int ranks = GetParam();
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, ranks);
  scene::Snapshot all = gatheredPlates(48);
  all.instances.erase(all.instances.begin());  // the wall, behind all others
  all.settings.integrator = LightIntegrator::path;
  all.settings.material.kind = SurfaceMaterial::mirror;
  const size_t count = all.instances.size();
  int outside = 0, lost = 0;
  for (int frame = 1; frame < 6; ++frame) {
    all.swaps = all.frame = all.number = static_cast<uint64_t>(frame);
    all.eyeFromWorld = glm::rotate(all.eyeFromWorld, 0.3, {0.2, 1, 0.1});
    for (scene::Instance& instance : all.instances) instance.eyeFromObject = all.eyeFromWorld;
    std::vector<scene::Snapshot> parts(static_cast<size_t>(ranks), all);
    for (scene::Snapshot& part : parts) part.instances.clear();
    for (size_t i = 0; i < count; ++i) parts[i * parts.size() / count].instances.push_back(all.instances[i]);
    const Image whole = expectedImage(all);
    std::vector<Image> images = programs.images(parts);
    std::vector<Image> first = {images[0]};
    test::cropToBoxes(first, {parts[0]});
    lost += differing(first[0], whole);
    outside += test::cropToBoxes(images, parts);
    EXPECT_EQ(differing(composed(std::move(images)), whole), 0) << job.said();
  }
  EXPECT_GT(outside, 0) << "data cover the images";
  EXPECT_GT(lost, 0) << "one rank's box holds it all";
}

/// A ground and a background lie outside of all boxes: the image of the rank that gathers has them beside
/// the one that all ranks show, in front of data, too, and with the light between both.
TEST_P(ComposedInBoxesTest, CompleteImageHasGroundAndBackground) {
  const int ranks = GetParam();
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, ranks);
  programs.program(0).completes = true;
  scene::Snapshot all = gatheredPlates(48);
  all.instances.erase(all.instances.begin());
  setBounds(all);
  all.settings.ground.kind = GroundKind::plane, all.settings.ground.offset = -0.2f;
  all.settings.lights.up = static_cast<decltype(all.settings.lights.up)>(2);  // z: it hides some plates
  all.settings.background.kind = BackgroundKind::color;
  const size_t count = all.instances.size();
  int beneath = 0, outside = 0;
  for (int frame = 1; frame < 6; ++frame) {
    all.swaps = all.frame = all.number = static_cast<uint64_t>(frame);
    all.ground = scene::GroundUse::none, all.backdrop = nullptr;
    all.eyeFromWorld = glm::rotate(all.eyeFromWorld, 0.3, {0.2, 1, 0.1});
    for (scene::Instance& instance : all.instances) instance.eyeFromObject = all.eyeFromWorld;
    const Image without = expectedImage(all);
    all.ground = scene::GroundUse::drawn;
    if (frame % 2 == 0) all.backdrop = std::make_shared<scene::Backdrop>();  // then the image is averages
    const Image whole = expectedImage(all);
    std::vector<scene::Snapshot> parts(static_cast<size_t>(ranks), all);
    for (scene::Snapshot& part : parts) part.instances.clear();
    for (size_t i = 0; i < count; ++i) parts[i * parts.size() / count].instances.push_back(all.instances[i]);
    std::vector<Image> images = programs.images(parts);
    for (const Image& image : images) EXPECT_EQ(differing(image, without), 0) << job.said();
    EXPECT_EQ(differing(programs.program(0).complete, whole), 0) << job.said();
    for (size_t i = 0; i < whole.depth.size() && !all.backdrop; ++i)
      beneath += without.depth[i] != Image::kMiss && whole.depth[i] < without.depth[i];
    outside += test::cropToBoxes(images, parts);
  }
  EXPECT_TRUE(programs.allByWorkers());
  EXPECT_EQ(programs.program(0).said + programs.program(1).said, "");
  EXPECT_GT(beneath, 0) << "the ground hides nothing";
  EXPECT_GT(outside, 0) << "data cover the images";
}

INSTANTIATE_TEST_SUITE_P(All, ComposedInBoxesTest, testing::Values(2, 3, 4, 7));

TEST_F(GatheredImagesTest, RanksShowWhatIsMadeOfAllPasses) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 2);
  scene::Snapshot all = gatheredPlates();
  const scene::Snapshot part = partOf(all, 1, 2);
  programs.program(0).shows = false;
  std::future<Image> other = std::async(std::launch::async, [&] { return programs.program(1).image(part); });
  Image last;
  for (uint32_t pass = 0; pass < 3; ++pass) {
    all.lightSampling.pass = pass;
    last = programs.program(0).image(partOf(all, 0, 2));
    EXPECT_EQ(differing(last, expectedImage(partsOf(all, {0, 1}, 2))), 0) << job.said();
  }
  EXPECT_NE(other.wait_for(std::chrono::milliseconds(50)), std::future_status::ready);
  std::ranges::fill(last.color, 0x12345678u);  // as filters may change them
  programs.program(0).tracer.shown(partOf(all, 0, 2), last, false);
  EXPECT_EQ(differing(other.get(), last), 0) << job.said();
  EXPECT_TRUE(programs.program(1).cost.elsewhere);
  EXPECT_FALSE(programs.program(1).cost.refined);
  // More passes are shown later.
  std::ranges::fill(last.color, 0x87654321u);
  programs.program(0).tracer.shown(partOf(all, 0, 2), last, true);
  EXPECT_EQ(differing(programs.program(1).image(part), last), 0) << job.said();
  EXPECT_TRUE(programs.program(1).cost.refined);
  EXPECT_TRUE(programs.allByWorkers());
}

TEST_F(GatheredImagesTest, ImagesThatAreNotShownAreNotWaitedFor) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 2);
  scene::Snapshot all = gatheredPlates();
  programs.program(0).shows = false;
  const scene::Snapshot part = partOf(all, 1, 2);
  for (const bool ends : {false, true}) {
    std::future<Image> other =
        std::async(std::launch::async, [&] { return programs.program(1).image(part); });
    programs.program(0).image(partOf(all, 0, 2));
    if (ends)
      programs.end(0);
    else
      ++all.number,
          programs.program(0).tracer.trace(partOf(all, 0, 2), scratch_, cost_, error_, [] { return true; });
    EXPECT_EQ(differing(other.get(), expectedImage(part)), 0) << job.said();
    ++all.number;
  }
}

/// Pixels outside of all ranks' data reach no composed image.
TEST_F(GatheredImagesTest, SceneryIsLeftOut) {
  WorkerJob job(directory_, 2);
  test::ProgramRanks programs(directory_, 2);
  scene::Snapshot plain = gatheredPlates();
  setBounds(plain);
  for (int which = 0; which < 3; ++which) {
    scene::Snapshot all = plain;
    all.swaps = all.frame = all.number = static_cast<uint64_t>(which + 1);
    if (which != 1) {
      all.settings.ground.kind = GroundKind::plane;
      all.ground = which == 0 ? scene::GroundUse::drawn : scene::GroundUse::around;
    }
    if (which != 0) all.backdrop = std::make_shared<scene::Backdrop>();
    scene::Snapshot expected = partsOf(all, {0, 1}, 2);
    expected.ground = scene::GroundUse::none, expected.backdrop = nullptr;
    for (const Image& image : programs.images(all))
      EXPECT_EQ(differing(image, expectedImage(expected)), 0) << job.said();
  }
  EXPECT_EQ(programs.program(0).said + programs.program(1).said, "");
  for (int times = 0; times < 2; ++times) programs.program(0).tracer.leaveSceneryOut();
  const std::string& said = programs.program(0).said;
  EXPECT_EQ(said.find("ground and background are left out"), said.rfind("gather: ") + 8) << said;
  scene::Snapshot all = plain;
  all.settings.gather = false, all.settings.ao.enabled = false;
  all.settings.ground.kind = GroundKind::plane, all.ground = scene::GroundUse::drawn;
  all.swaps = all.frame = all.number = 4;
  EXPECT_EQ(programs.images(all)[1].depth, expectedImage(partOf(all, 1, 2)).depth) << "without the setting";
}

TEST_F(GatheredImagesTest, MissesHaveTheColorThatEachRankAsksFor) {
  WorkerJob job(directory_, 1);
  test::ProgramRanks programs(directory_, 2);
  scene::Snapshot all = gatheredPlates();
  all.instances.erase(all.instances.begin());
  std::future<Image> other = std::async(
      std::launch::async, [&] { return programs.program(1).image(partOf(all, 1, 2), 0xff00ff00u); });
  programs.program(0).image(partOf(all, 0, 2), 0xffff0000u);
  EXPECT_EQ(differing(other.get(), expectedImage(partsOf(all, {0, 1}, 2), 0xff00ff00u)), 0) << job.said();
}

}  // namespace
}  // namespace gluray::cluster
