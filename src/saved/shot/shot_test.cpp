// Pictures of saved scenes: equal to what the program gets, whatever their bands, and larger ones like them.
#include "saved/shot/shot.h"

#include "render/testing/lit_wall.h"
#include "render/testing/test_ball.h"
#include "saved/testing/saved_pictures.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace gluray::saved {
namespace {

using frame::test::averaged, frame::test::balls, frame::test::Floor, frame::test::layered;
using scene::blended;
using namespace test;

TEST(Shot, OfTheWindowIsWhatTheProgramGets) {
  scene::Snapshot lit = balls(kSide), plain = balls(kSide, Floor::none);
  lit.settings.noise = 0.02f;
  plain.settings.ao.enabled = false;
  scene::Snapshot sixteen = averaged(plain);
  for (const scene::Snapshot& s : {lit, plain, sixteen}) {
    SavedScene scene = sceneOf(s);
    EXPECT_EQ(pictureOf(scene), shownBy(s, 0)) << "over nothing";
    scene.shown = {kSide, kSide, shownBy(s)};
    EXPECT_EQ(pictureOf(scene), scene.shown.pixels);
    scene.shown = {};
    EXPECT_EQ(pictureOf(scene, {.transparent = true}), shownBy(s, 0));
  }
}

TEST(Shot, OfALargerSizeIsTheSameViewWithMorePixels) {
  scene::Snapshot s = balls(kSide, Floor::none);
  s.settings.ao.enabled = false;
  SavedScene scene = sceneOf(s);
  scene.shown = {kSide, kSide, shownBy(s)};
  const std::vector<uint32_t> large = pictureOf(scene, {.size = {4 * kSide, 4 * kSide}});
  scene::Snapshot wanted = s;
  wanted.camera.viewport = {0, 0, 4 * kSide, 4 * kSide};
  wanted.region = {0, 0, 4 * kSide, 4 * kSide};
  EXPECT_EQ(large, shownBy(wanted));
}

/// Bands of 32 rows.
constexpr int kThin = 1;

scene::Snapshot withSize(scene::Snapshot s, int width, int height) {
  s.camera.viewport = {0, 0, width, height}, s.region = {0, 0, width, height};
  return s;
}

TEST(Shot, IsTheSameInBands) {
  scene::Snapshot s = balls(kSide);
  s.settings.ao.enabled = false;
  frame::Renderer renderer;
  Shot shot(sceneOf(s), {.size = {200, 300}, .fit = Fit::stretch, .bandPixels = kThin}, renderer);
  ASSERT_EQ(shot.bands(), 10);
  EXPECT_TRUE(pictureOf(shot) == shownBy(withSize(s, 200, 300), 0));
}

TEST(Shot, BandsOfSmoothedLightHaveNoSeams) {
  scene::Snapshot s = balls(kSide);
  s.settings.denoise = Denoise::filter, s.settings.ao.samples = 2;
  s.settings.refine.passes = 4, s.settings.noise = 1e-6f;
  frame::Renderer renderer;
  Shot shot(sceneOf(s), {.size = {300, 300}, .fit = Fit::stretch, .bandPixels = kThin}, renderer);
  ASSERT_EQ(shot.bands(), 10);
  const std::vector<uint32_t> picture = pictureOf(shot), wanted = shownBy(withSize(s, 300, 300), 0);
  size_t others = 0;
  for (size_t i = 0; i < picture.size(); ++i) others += apart(picture[i], wanted[i]) > 0;
  EXPECT_EQ(others, 0u);
}

TEST(Shot, HasOneExposure) {
  scene::Snapshot s =
      gluray::test::litView({gluray::test::ballMesh(40)}, gluray::test::Shader::phong, {0, 0, 1, 0});
  s.shadings[0].fragment.normals = scene::FragmentShading::Normals::vertices;
  s.settings.lights.rig = LightRig::headlightAndKey, s.settings.lights.strength = 0.3f;
  s.settings.noise = 0;
  const std::vector<uint32_t> dark = pictureOf(sceneOf(s));
  s.settings.autoExposure = true;
  const std::vector<uint32_t> whole = pictureOf(sceneOf(s)),
                              bands = pictureOf(sceneOf(s), {.bandPixels = kThin});
  EXPECT_NE(whole, dark);
  EXPECT_EQ(whole, bands);
}

TEST(Shot, KeepsWhatWasDrawnOverSurfaces) {
  scene::Snapshot s = balls(kSide);
  s.settings.ao.enabled = false;
  SavedScene scene = sceneOf(s);
  scene.shown = {kSide, kSide, shownBy(s)};
  for (int y = 4; y < 12; ++y)
    for (int x = 8; x < 40; ++x) scene.shown.pixels[static_cast<size_t>(y * kSide + x)] = 0xff00ffff;
  EXPECT_EQ(pictureOf(scene), scene.shown.pixels);
  const ShotOptions twice{.size = {2 * kSide, 2 * kSide}};
  const auto large = pictureOf(scene, twice);
  EXPECT_EQ(large[16 * 2 * kSide + 40], 0xff00ffff);
  frame::Renderer renderer;
  const Shot shot(scene, twice, renderer);
  EXPECT_EQ(shot.notes().size(), 1u) << "that it is enlarged";
  ShotOptions without = twice;
  without.overlays = false;
  EXPECT_NE(pictureOf(scene, without)[16 * 2 * kSide + 40], 0xff00ffff);
}

TEST(Shot, KeepsThemWhateverItsOwnSettings) {
  scene::Snapshot s = balls(kSide), dark = s;
  s.settings.ao.enabled = false;
  dark.settings = s.settings, dark.settings.exposure = -2;
  SavedScene scene = sceneOf(s);
  scene.shown = {kSide, kSide, shownBy(s)};
  std::vector<uint32_t> wanted = shownBy(dark);
  ASSERT_NE(wanted, scene.shown.pixels);
  for (int y = 4; y < 12; ++y)
    for (size_t x = 8; x < 40; ++x) {
      const size_t i = static_cast<size_t>(y) * kSide + x;
      wanted[i] = scene.shown.pixels[i] = 0xff00ffff;
    }
  const auto darker = [](Settings settings) {
    settings.exposure = -2;
    return settings;
  };
  EXPECT_EQ(pictureOf(scene, {.settings = darker}), wanted);
}

TEST(Shot, DrawsLayersOverWhatIsOpaque) {
  scene::Snapshot opaque = balls(kSide), glass = layered(balls(kSide, Floor::none));
  opaque.settings.ao.enabled = glass.settings.ao.enabled = false;
  for (scene::Instance& instance : glass.instances)
    instance.eyeFromObject = glm::translate(glass.eyeFromWorld, glm::dvec3(0.2, 0.6, 0.4));
  SavedScene scene = sceneOf(opaque);
  scene.batches.push_back({std::make_shared<scene::Snapshot>(glass)});
  // Where no surface of theirs reaches, the layers' own depth counts.
  const std::vector<uint32_t> large = pictureOf(scene, {.size = {2 * kSide, 2 * kSide}});
  const auto enlarged = [](scene::Snapshot s) {
    s.camera.viewport = {0, 0, 2 * kSide, 2 * kSide}, s.region = {0, 0, 2 * kSide, 2 * kSide};
    return s;
  };
  frame::test::CountingTrace tracer;
  const Image below = tracer.image(enlarged(opaque));
  scene::Snapshot above = enlarged(glass);
  auto layers = std::make_shared<scene::Layers>(*glass.layers);
  layers->opaqueDepth.clear();
  for (const float depth : below.depth) layers->opaqueDepth.push_back(depth == Image::kMiss ? -1 : depth);
  above.layers = layers;
  const Image over = tracer.image(above);
  size_t mixed = 0;
  for (size_t i = 0; i < large.size(); ++i) {
    const uint32_t wanted =
        over.depth[i] == Image::kMiss ? below.color[i] : blended(over.color[i], below.color[i]);
    ASSERT_EQ(large[i], wanted) << i;
    mixed += over.depth[i] != Image::kMiss && below.depth[i] != Image::kMiss;
  }
  EXPECT_GT(mixed, 500u);
}

TEST(Shot, ForgetsDepthsThatWereCleared) {
  scene::Snapshot near = balls(kSide), far = balls(kSide);
  near.settings.ao.enabled = far.settings.ao.enabled = false;
  for (scene::Instance& instance : far.instances) {
    instance.color = {0, 0, 1, 1};
    instance.eyeFromObject = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -3)) * far.eyeFromWorld;
  }
  SavedScene scene = sceneOf(near);
  scene.batches.push_back({std::make_shared<scene::Snapshot>(far)});
  const std::vector<uint32_t> hidden = pictureOf(scene);
  EXPECT_EQ(hidden, shownBy(near, 0));
  scene.batches[1].cleared = {{0, 0, kSide, kSide / 2}};
  const std::vector<uint32_t> cleared = pictureOf(scene), blue = shownBy(far, 0);
  EXPECT_TRUE(std::equal(cleared.begin(), cleared.begin() + kSide * kSide / 2, blue.begin()));
  EXPECT_TRUE(
      std::equal(cleared.begin() + kSide * kSide / 2, cleared.end(), hidden.begin() + kSide * kSide / 2));
}

TEST(Shot, OfAWindowWithoutTracedSurfacesIsTheWindows) {
  SavedScene scene;
  scene.window = {4, 3};
  scene.shown = {4, 3, std::vector<uint32_t>(12, 0xff102030)};
  scene.shown.pixels[5] = 0xffffffff;
  EXPECT_EQ(pictureOf(scene), scene.shown.pixels);
  EXPECT_EQ(pictureOf(scene, {.size = {8, 6}}).size(), 48u);
  EXPECT_THROW(pictureOf(scene, {.transparent = true}), std::runtime_error);
}

TEST(Shot, OfALargerSizeHasSmoothEdges) {
  scene::Snapshot s = balls(kSide, Floor::none);
  s.settings.ao.enabled = false;
  const ShotOptions twice{.size = {2 * kSide, 2 * kSide}, .edgeSamples = 4};
  scene::Snapshot wanted = withSize(s, 2 * kSide, 2 * kSide);
  wanted.settings.spp = 4;
  EXPECT_EQ(pictureOf(sceneOf(s), twice), shownBy(wanted, 0));
  EXPECT_EQ(pictureOf(sceneOf(s), {.edgeSamples = 4}), shownBy(s, 0)) << "in the window's size";
}

TEST(Shot, RefusesWhatCannotBe) {
  const SavedScene scene = sceneOf(balls(kSide));
  EXPECT_THROW(pictureOf(scene, {.size = {0, 5}}), std::runtime_error);
  EXPECT_THROW(pictureOf(scene, {.size = {32769, 5}}), std::runtime_error);
  EXPECT_THROW(pictureOf({}), std::runtime_error);
}

}  // namespace
}  // namespace gluray::saved
