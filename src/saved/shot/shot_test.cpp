// Pictures of saved scenes: equal to what the program gets, whatever their bands, and larger ones like them.
#include "saved/shot/shot.h"

#include "base/testing/temporary_folder.h"
#include "frame/images/traced_images.h"
#include "frame/testing/mixed_scenes.h"
#include "render/testing/lit_wall.h"
#include "render/testing/test_ball.h"
#include "scene/premultiplied.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace gluray::saved {
namespace {

using frame::test::averaged, frame::test::balls, frame::test::Floor, frame::test::layered;
using scene::blended;

constexpr int kSide = 64;
constexpr uint32_t kBackground = 0xff604020;

SavedScene sceneOf(const scene::Snapshot& s) {
  SavedScene scene;
  scene.window = {s.region.width, s.region.height};
  scene.batches.push_back({std::make_shared<scene::Snapshot>(s)});
  return scene;
}

/// What the program gets of it, over a background; bottom row first.
std::vector<uint32_t> shownBy(const scene::Snapshot& s, uint32_t background = kBackground) {
  frame::test::CountingTrace tracer;
  frame::TracedImages images(frame::Tracer{.trace = tracer.trace});
  const auto result = images.imageOf(s, {.finished = true});
  EXPECT_TRUE(result.cached) << result.why;
  const Image& image = result.cached->image;
  std::vector<uint32_t> colors(image.depth.size(), background);
  for (size_t i = 0; i < colors.size(); ++i)
    if (image.depth[i] != Image::kMiss)
      colors[i] = image.isAverages() || s.layers ? blended(image.color[i], background) : image.color[i];
  return colors;
}

/// All bands, bottom row first.
std::vector<uint32_t> pictureOf(Shot& shot) {
  std::vector<uint32_t> rows;
  for (int band = 0; band < shot.bands(); ++band) {
    const std::vector<uint32_t> some = shot.band(band);
    rows.insert(rows.end(), some.begin(), some.end());
  }
  const auto width = static_cast<ptrdiff_t>(shot.size().x);
  std::vector<uint32_t> flipped;
  for (auto row = rows.end(); row != rows.begin(); row -= width)
    flipped.insert(flipped.end(), row - width, row);
  return flipped;
}

std::vector<uint32_t> pictureOf(const SavedScene& scene, const ShotOptions& options = {}) {
  frame::Renderer renderer;
  Shot shot(scene, options, renderer);
  return pictureOf(shot);
}

int apart(uint32_t a, uint32_t b) {
  int most = 0;
  for (int shift = 0; shift < 24; shift += 8)
    most = std::max(most, std::abs(static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255)));
  return most;
}

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

TEST(Shot, TurnsAroundTheScene) {
  scene::Snapshot s = balls(kSide, Floor::none);
  s.settings.ao.enabled = false;
  s.settings.lights.up = LightsUp::y;
  const SavedScene scene = sceneOf(s);
  const std::vector<uint32_t> front = pictureOf(scene), whole = pictureOf(scene, {.turn = 360});
  size_t differing = 0;
  for (size_t i = 0; i < front.size(); ++i) differing += apart(front[i], whole[i]) > 2;
  EXPECT_LT(differing, 8u);
  // By hand: the camera goes around the middle of the balls.
  for (const double degrees : {90.0, 180.0, 250.0}) {
    scene::Snapshot turned = s;
    // The box that counts is that of eye space.
    glm::dvec3 lower(1e9), upper(-1e9);
    for (const scene::Instance& i : s.instances)
      for (int c = 0; c < 8; ++c) {
        const glm::vec3 p(c & 1 ? i.mesh->upper.x : i.mesh->lower.x,
                          c & 2 ? i.mesh->upper.y : i.mesh->lower.y,
                          c & 4 ? i.mesh->upper.z : i.mesh->lower.z);
        const glm::dvec3 e(s.eyeFromWorld * glm::dvec4(p, 1));
        lower = glm::min(lower, e), upper = glm::max(upper, e);
      }
    const glm::dvec3 middle(glm::inverse(s.eyeFromWorld) * glm::dvec4((lower + upper) / 2.0, 1));
    const glm::dmat4 around = glm::translate(glm::dmat4(1), middle) *
                              glm::rotate(glm::dmat4(1), glm::radians(-degrees), glm::dvec3(0, 1, 0)) *
                              glm::translate(glm::dmat4(1), -middle);
    turned.eyeFromWorld = s.eyeFromWorld * around;
    for (scene::Instance& instance : turned.instances) instance.eyeFromObject = turned.eyeFromWorld;
    const std::vector<uint32_t> wanted = shownBy(turned, 0), got = pictureOf(scene, {.turn = degrees});
    differing = 0;
    for (size_t i = 0; i < got.size(); ++i) differing += apart(got[i], wanted[i]) > 2;
    EXPECT_LT(differing, 8u) << degrees;
    EXPECT_NE(got, front) << degrees;
  }
}

TEST(Shot, TurnsLightingInItsOwnSpace) {
  // The lighting's space is turned against eye space, as in programs whose matrices hold another camera.
  scene::Snapshot s =
      gluray::test::litView({gluray::test::ballMesh(40)}, gluray::test::Shader::phong, {0, 0, 1, 0});
  s.shadings[0].fragment.normals = scene::FragmentShading::Normals::vertices;
  s.settings.lights.rig = LightRig::headlightAndKey;
  for (scene::Instance& instance : s.instances) {  // normals alone say where the lights are
    instance.normalMatrix = glm::mat3(instance.eyeFromObject);
    instance.lightingFromObject = glm::mat4(1);
  }
  scene::Snapshot other = s;
  const glm::dmat4 between = glm::rotate(glm::dmat4(1), 1.0, glm::dvec3(1, 2, 3));
  other.camera.clipFromEye = s.camera.clipFromEye * between;
  other.eyeFromWorld = glm::inverse(between) * s.eyeFromWorld;
  for (scene::Instance& instance : other.instances)
    instance.eyeFromObject = glm::inverse(between) * instance.eyeFromObject;
  const std::vector<uint32_t> one = pictureOf(sceneOf(s), {.turn = 70}),
                              same = pictureOf(sceneOf(other), {.turn = 70});
  size_t differing = 0, shown = 0;
  for (size_t i = 0; i < one.size(); ++i) differing += apart(one[i], same[i]) > 2, shown += one[i] != 0;
  EXPECT_LT(differing, 8u);
  EXPECT_GT(shown, 300u);
}

TEST(Shot, TurnsWhatLayBehindTheNearPlaneIntoView) {
  scene::Snapshot s = balls(kSide, Floor::none);
  s.settings.ao.enabled = false;
  scene::Snapshot tight = s;
  tight.camera.clipFromEye = glm::perspective(glm::radians(35.0), 1.0, 4.0, 8.0);
  scene::Snapshot flat = s, flatter = s;
  flat.camera.clipFromEye = glm::ortho(-3.0, 3.0, -3.0, 3.0, 0.1, 100.0);
  flatter.camera.clipFromEye = glm::ortho(-3.0, 3.0, -3.0, 3.0, 4.0, 8.0);
  for (const auto& [roomy, narrow] : {std::pair(s, tight), std::pair(flat, flatter)}) {
    const auto expected = pictureOf(sceneOf(roomy), {.turn = 90}),
               got = pictureOf(sceneOf(narrow), {.turn = 90});
    size_t differing = 0, shown = 0;
    for (size_t i = 0; i < got.size(); ++i) differing += apart(got[i], expected[i]) > 2, shown += got[i] != 0;
    EXPECT_LT(differing, 8u);
    EXPECT_GT(shown, 300u);
  }
}

TEST(Shot, RefusesWhatCannotBe) {
  const SavedScene scene = sceneOf(balls(kSide));
  EXPECT_THROW(pictureOf(scene, {.size = {0, 5}}), std::runtime_error);
  EXPECT_THROW(pictureOf(scene, {.size = {32769, 5}}), std::runtime_error);
  EXPECT_THROW(pictureOf({}), std::runtime_error);
}

TEST(SavedScene, IsReadAsItWasWritten) {
  const gluray::test::TemporaryFolder folder;
  const std::string path = folder.file("scene.gluray");
  scene::Snapshot s = averaged(balls(kSide), 4);
  s.settings.ao.radius = 0.123456789f, s.settings.lights.file = "lights of mine.toml";
  SavedScene scene = sceneOf(s);
  scene.batches.front().place = {3, 4}, scene.batches.front().strict = false;
  scene.batches.front().cleared = {{1, 2, 3, 4}};
  scene.facts = {{"program", "a \xff program"}};
  scene.shown = {1, 2, {5, 6}};
  ASSERT_EQ(saveScene(scene, path), "");
  const SavedScene read = readScene(path);
  EXPECT_EQ(read.window, scene.window);
  EXPECT_EQ(read.shown.pixels, scene.shown.pixels);
  ASSERT_EQ(read.batches.size(), 1u);
  const SavedBatch& batch = read.batches.front();
  EXPECT_EQ(batch.place, glm::ivec2(3, 4));
  EXPECT_FALSE(batch.strict);
  EXPECT_EQ(batch.cleared, scene.batches.front().cleared);
  EXPECT_EQ(batch.snapshot->settings.ao.radius, s.settings.ao.radius);
  EXPECT_EQ(batch.snapshot->settings.lights.file, s.settings.lights.file);
  ASSERT_EQ(batch.snapshot->instances.size(), s.instances.size());
  frame::test::CountingTrace tracer;
  EXPECT_EQ(tracer.image(*batch.snapshot).color, tracer.image(s).color);
  // To the byte: what is read is written again equally.
  const std::string again = folder.file("again.gluray");
  ASSERT_EQ(saveScene(read, again), "");
  EXPECT_TRUE(gluray::test::textOf(folder.file("scene.gluray")) ==
              gluray::test::textOf(folder.file("again.gluray")));
}

TEST(SavedScene, SaysWhatIsWrong) {
  const gluray::test::TemporaryFolder folder;
  const SavedScene scene = sceneOf(balls(kSide));
  EXPECT_NE(saveScene(scene, folder.file("no/scene.gluray")).find("cannot be written"), std::string::npos);
  EXPECT_THROW(readScene(folder.file("missing.gluray")), std::runtime_error);
  SavedScene volumes = scene;
  auto s = std::make_shared<scene::Snapshot>(*scene.batches.front().snapshot);
  s->volumes.emplace_back();
  volumes.batches.push_back({s});
  EXPECT_NE(saveScene(volumes, folder.file("scene.gluray")).find("volumes"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace gluray::saved
