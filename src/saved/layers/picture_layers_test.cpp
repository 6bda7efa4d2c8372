// Layers of pictures with known answers: planes, balls, colours, coverage.
#include "saved/layers/picture_layers.h"

#include "render/testing/test_ball.h"
#include "saved/layers/cryptomatte.h"
#include "saved/shot/linear_color.h"
#include "saved/testing/saved_pictures.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>

namespace gluray::saved {
namespace {

using frame::test::averaged, frame::test::balls, frame::test::blurred, frame::test::Floor, frame::test::Hides,
    frame::test::layered, frame::test::litScene;
using namespace test;

/// All values of a picture, top row first, by channel.
struct Values {
  glm::ivec2 size{0};
  std::map<std::string, std::vector<float>> of;
  std::vector<std::string> notes;
  float at(const std::string& channel, int x, int y) const {
    return of.at(channel)[static_cast<size_t>(y * size.x + x)];
  }
  glm::vec3 vector(const std::string& layer, int x, int y) const {
    return {at(layer + ".X", x, y), at(layer + ".Y", x, y), at(layer + ".Z", x, y)};
  }
  glm::vec3 color(int x, int y) const {
    return {at("albedo.R", x, y), at("albedo.G", x, y), at("albedo.B", x, y)};
  }
};

Values layersOf(const SavedScene& scene, const std::string& list, const ShotOptions& options = {}) {
  frame::Renderer renderer;
  Shot shot(scene, options, renderer);
  PictureLayers layers(shot, renderer, layersIn(list));
  Values values{.size = shot.size(), .notes = layers.notes()};
  std::vector<std::string> names;
  for (const Layer layer : layers.layers())
    for (const std::string& name : channelsOf(layer)) names.push_back(name);
  EXPECT_EQ(names.size(), layers.channels());
  const size_t stride = names.size() + 3;
  for (int band = 0; band < shot.bands(); ++band) {
    const scene::Region region = shot.regionOf(band);
    const size_t pixels = static_cast<size_t>(region.width) * static_cast<size_t>(region.height);
    std::vector<float> some(pixels * stride, -7);
    layers.write(band, some.data(), stride);
    for (size_t i = 0; i < pixels; ++i) {
      for (size_t c = 0; c < names.size(); ++c) values.of[names[c]].push_back(some[i * stride + c]);
      EXPECT_EQ(some[i * stride + names.size()], -7) << "of other channels";
    }
  }
  return values;
}

scene::Snapshot numbered(scene::Snapshot s) {
  for (size_t i = 0; i < s.instances.size(); ++i) s.instances[i].object.value = static_cast<uint32_t>(i + 1);
  return s;
}

TEST(Layers, AreNamedInLists) {
  EXPECT_TRUE(layersIn("").empty());
  EXPECT_EQ(layersIn("all").size(), 6u);
  EXPECT_EQ(layersIn("depth,albedo,depth"), (std::vector<Layer>{Layer::albedo, Layer::depth}));
  for (const char* wrong : {"dpeth", "depth,", ",", "depth,,albedo", "depth, albedo", "All"})
    EXPECT_THROW(layersIn(wrong), std::runtime_error) << wrong;
  try {
    layersIn("dpeth");
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(), "--layers dpeth: use albedo, normal, position, depth, object, material, or all");
  }
}

TEST(Layers, OfAPlaneAreItsDistanceItsNormalAndItsPoints) {
  const SavedScene scene = sceneOf(litScene(Hides::nothing, kSide));
  for (const glm::ivec2 size : {glm::ivec2(kSide), glm::ivec2(100, 150)}) {
    const Values v = layersOf(scene, "depth,normal,position", {.size = size, .fit = Fit::stretch});
    const double half = 5 * std::tan(glm::radians(20.0));
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        ASSERT_NEAR(v.at("depth.Z", x, y), 5, 1e-5);
        ASSERT_LT(glm::distance(v.vector("normal", x, y), glm::vec3(0, 0, 1)), 1e-6f);
        const glm::dvec3 known(half * (2 * (x + 0.5) / size.x - 1), half * (1 - 2 * (y + 0.5) / size.y), 0);
        ASSERT_LT(glm::distance(glm::dvec3(v.vector("position", x, y)), known), 1e-4) << x << " " << y;
      }
  }
}

/// A ball about the origin of the world, in units of it, whatever the units of eye space.
scene::Snapshot ball(const glm::dmat4& eyeFromWorld, const glm::dmat4& clipFromEye) {
  scene::Snapshot s = gluray::test::makeSnapshot({gluray::test::ballMesh(200)}, kSide);
  s.camera.clipFromEye = clipFromEye;
  s.eyeFromWorld = s.instances[0].eyeFromObject = eyeFromWorld;
  return s;
}

TEST(Layers, OfABallAreInWorldSpace) {
  const glm::dvec3 eye(2, 3, 4);
  const glm::dmat4 view = glm::lookAt(eye, glm::dvec3(0), glm::dvec3(0, 1, 0)),
                   lens = glm::perspective(glm::radians(30.0), 1.0, 0.1, 100.0);
  const glm::dmat4 twice = glm::scale(glm::dmat4(1), glm::dvec3(2));
  // The second program has its view in the projection.
  for (const auto& [fromWorld, fromEye] :
       {std::pair(view, lens), std::pair(glm::dmat4(1), lens * view), std::pair(twice * view, lens)}) {
    const Values v = layersOf(sceneOf(ball(fromWorld, fromEye)), "depth,normal,position");
    const glm::dvec3 away = -glm::normalize(eye);
    size_t shown = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const glm::dvec3 p(v.vector("position", x, y));
        const glm::vec3 normal = v.vector("normal", x, y);
        if (v.at("depth.Z", x, y) == PictureLayers::kNoDepth) {
          ASSERT_EQ(normal, glm::vec3(0));
          continue;
        }
        ++shown;
        ASSERT_NEAR(glm::length(p), 1, 1e-3) << "of facets";
        ASSERT_LT(glm::distance(glm::vec3(glm::normalize(p)), normal), 0.01f);
        ASSERT_NEAR(glm::length(normal), 1, 1e-5);
        ASSERT_NEAR(v.at("depth.Z", x, y), glm::dot(away, p - eye), 1e-4);
        // The point lies on the ray of the pixel's centre.
        const glm::dvec4 clip = lens * view * glm::dvec4(p, 1);
        ASSERT_NEAR((clip.x / clip.w + 1) / 2 * kSide, x + 0.5, 0.05);
        ASSERT_NEAR((1 - clip.y / clip.w) / 2 * kSide, y + 0.5, 0.05);
      }
    EXPECT_GT(shown, 500u);
  }
}

TEST(Layers, OfParallelViewsHaveDistancesFromTheCamera) {
  const glm::dmat4 view = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -7));
  const Values v =
      layersOf(sceneOf(ball(view, glm::ortho(-2.0, 2.0, -2.0, 2.0, 1.0, 20.0))), "depth,position");
  EXPECT_NEAR(v.at("depth.Z", kSide / 2, kSide / 2), 6, 1e-2);
  EXPECT_NEAR(v.at("position.Z", kSide / 2, kSide / 2), 1, 1e-2);
}

TEST(Layers, OfAlbedoAreTheColorsOfSurfacesWithoutLight) {
  scene::Snapshot s = averaged(unlit(balls(kSide, Floor::none)));
  const SavedScene scene = sceneOf(s);
  const ShotOptions transparent{.transparent = true};
  const Values v = layersOf(scene, "albedo", transparent);
  frame::Renderer renderer;
  Shot shot(scene, transparent, renderer);
  const std::vector<glm::vec4> shown = shot.wideBand(0, Shot::Range::open);  // these balls have no light
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::vec4 light = lightOf(shown[static_cast<size_t>(y * kSide + x)]);
      ASSERT_LT(glm::distance(v.color(x, y), glm::vec3(light)), 2e-3f) << x << " " << y;
    }
}

TEST(Layers, OfObjectsCoverWhatThePictureShows) {
  for (const PixelFilter filter : {PixelFilter::box, PixelFilter::mitchell}) {
    scene::Snapshot s = averaged(numbered(unlit(balls(kSide, Floor::none))));
    s.settings.pixelFilter = filter;
    const SavedScene scene = sceneOf(s);
    const ShotOptions transparent{.transparent = true};
    const Values v = layersOf(scene, "object,material", transparent);
    frame::Renderer renderer;
    Shot shot(scene, transparent, renderer);
    const std::vector<glm::vec4> shown = shot.wideBand(0, Shot::Range::open);
    size_t mixed = 0;
    std::map<float, size_t> ids;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        for (const std::string layer : {"CryptoObject", "CryptoMaterial"}) {
          float sum = 0, last = 1;
          for (const std::string part : {"00", "01", "02"})
            for (const std::string pair : {".R.G", ".B.A"}) {
              const float id = v.at(layer + part + pair.substr(0, 2), x, y),
                          cover = v.at(layer + part + pair.substr(2), x, y);
              ASSERT_LE(cover, last);
              ASSERT_GE(cover, 0);
              ASSERT_EQ(cover > 0, id != 0);
              sum += cover, last = cover;
              if (cover == 1) ++ids[id];
              mixed += cover > 0 && cover < 1;
            }
          ASSERT_LE(sum, 1 + 1e-6f);
          const float alpha = shown[static_cast<size_t>(y * kSide + x)].a;
          const float expected = filter == PixelFilter::box ? alpha : sum;
          ASSERT_NEAR(sum, expected, 1e-5) << x << " " << y;
        }
      }
    EXPECT_GT(mixed, 200u);
    for (int object = 1; object <= 6; ++object)
      EXPECT_GT(ids[cryptoId("object " + std::to_string(object))], 3u) << object;
    EXPECT_GT(ids[cryptoId("program #4d80e6")], 50u) << "a material by its colour";
  }
}

TEST(Layers, AreTheSameInBands) {
  const SavedScene scene = sceneOf(averaged(numbered(balls(kSide))));
  ShotOptions options{.size = {200, 300}, .fit = Fit::stretch};
  const Values whole = layersOf(scene, "all", options);
  options.bandPixels = 1;
  EXPECT_TRUE(layersOf(scene, "all", options).of == whole.of);
}

TEST(Layers, FollowTheDepthsOfBatches) {
  const scene::Snapshot near = numbered(unlit(balls(kSide)));
  scene::Snapshot far = near;
  for (scene::Instance& instance : far.instances) {
    instance.object.value += 10;
    instance.eyeFromObject = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -3)) * far.eyeFromWorld;
  }
  SavedScene both = sceneOf(near);
  both.batches.push_back({std::make_shared<scene::Snapshot>(far)});
  const Values alone = layersOf(sceneOf(near), "depth,object"), behind = layersOf(both, "depth,object");
  EXPECT_TRUE(behind.of.at("CryptoObject00.R") == alone.of.at("CryptoObject00.R"));
  both.batches[1].cleared = {{0, 0, kSide, kSide / 2}};
  const Values over = layersOf(both, "depth,object"), other = layersOf(sceneOf(far), "depth,object");
  const auto half = static_cast<ptrdiff_t>(kSide * kSide / 2);
  for (const char* channel : {"CryptoObject00.R", "depth.Z"}) {
    const auto &mixed = over.of.at(channel), &top = alone.of.at(channel), &bottom = other.of.at(channel);
    EXPECT_TRUE(std::equal(mixed.begin(), mixed.begin() + half, top.begin())) << channel;
    EXPECT_TRUE(std::equal(mixed.begin() + half, mixed.end(), bottom.begin() + half)) << channel;
  }
}

TEST(Layers, ThatASceneCannotGiveAreLeftOut) {
  const Values unnumbered = layersOf(sceneOf(balls(kSide)), "all");
  EXPECT_FALSE(unnumbered.of.contains("CryptoObject00.R"));
  EXPECT_EQ(unnumbered.notes,
            std::vector<std::string>{"the layer object is left out: the program's objects are not known"});
  const Values lens = layersOf(sceneOf(blurred(numbered(balls(kSide)))), "all");
  EXPECT_EQ(lens.notes.size(), 2u);
  EXPECT_FALSE(lens.of.contains("CryptoMaterial00.R"));
  EXPECT_TRUE(lens.of.contains("depth.Z"));
  SavedScene glass = sceneOf(numbered(balls(kSide)));
  glass.batches.push_back({std::make_shared<scene::Snapshot>(layered(balls(kSide, Floor::none)))});
  const Values opaque = layersOf(glass, "depth");
  EXPECT_EQ(opaque.notes.size(), 1u);
  EXPECT_TRUE(opaque.of == layersOf(sceneOf(balls(kSide)), "depth").of);
}

}  // namespace
}  // namespace gluray::saved
