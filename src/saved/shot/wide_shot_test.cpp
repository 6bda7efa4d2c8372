// Pictures of floats: those of bytes before they are rounded, and light that is brighter than the window
// shows.
#include "render/resolve/averaged_byte.h"
#include "saved/shot/linear_color.h"
#include "saved/testing/saved_pictures.h"
#include "scene/srgb.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::saved {
namespace {

using frame::test::averaged, frame::test::balls, frame::test::Floor, frame::test::layered;
using namespace test;
using Range = Shot::Range;

/// All bands, top row first.
std::vector<glm::vec4> wideOf(const SavedScene& scene, const ShotOptions& options, Range range) {
  frame::Renderer renderer;
  Shot shot(scene, options, renderer);
  std::vector<glm::vec4> rows;
  for (int band = 0; band < shot.bands(); ++band) {
    const std::vector<glm::vec4> some = shot.wideBand(band, range);
    rows.insert(rows.end(), some.begin(), some.end());
  }
  return rows;
}

std::vector<uint32_t> bytesOf(const SavedScene& scene, const ShotOptions& options) {
  frame::Renderer renderer;
  Shot shot(scene, options, renderer);
  return test::rowsOf(shot);
}

/// The largest difference of a channel from the bytes, in steps of these. `others`: how many round to other
/// bytes.
double apartFrom(const std::vector<uint32_t>& bytes, const std::vector<glm::vec4>& wide, size_t& others) {
  EXPECT_EQ(bytes.size(), wide.size());
  double most = 0;
  others = 0;
  for (size_t i = 0; i < bytes.size(); ++i)
    for (int c = 0; c < 4; ++c) {
      const uint32_t byte = bytes[i] >> (8 * c) & 255;
      most = std::max(most, std::abs(255.0 * static_cast<double>(wide[i][c]) - byte));
      others += render::displayedByte(wide[i][c], false) != byte;
    }
  return most;
}

TEST(WideShot, RoundsToTheBytes) {
  SavedScene scene = sceneOf(unlit(balls(kSide, Floor::none)));
  scene.shown = {kSide, kSide, shownBy(*scene.batches[0].snapshot)};
  for (const glm::ivec2 size : {glm::ivec2(kSide), glm::ivec2(3 * kSide)}) {
    const ShotOptions options{.size = size};
    size_t others = 0;
    apartFrom(bytesOf(scene, options), wideOf(scene, options, Range::limited), others);
    EXPECT_EQ(others, 0u);
  }
}

TEST(WideShot, DiffersFromAveragesAndBlendsByTheirRounding) {
  SavedScene scene = sceneOf(averaged(unlit(balls(kSide))));
  scene.batches.push_back({std::make_shared<scene::Snapshot>(layered(unlit(balls(kSide, Floor::none))))});
  for (const bool transparent : {false, true}) {
    const ShotOptions options{.transparent = transparent};
    size_t others = 0;
    EXPECT_LE(apartFrom(bytesOf(scene, options), wideOf(scene, options, Range::limited), others), 2);
    EXPECT_LT(others, size_t{kSide} * kSide / 2);
  }
}

TEST(WideShot, KeepsLightThatIsBrighterThanWhite) {
  scene::Snapshot s = averaged(unlit(balls(kSide, Floor::none)));
  s.settings.exposure = 2;
  const SavedScene scene = sceneOf(s);
  const auto largest = [](const std::vector<glm::vec4>& colors) {
    float most = 0;
    for (const glm::vec4& color : colors) most = std::max({most, color.r, color.g, color.b});
    return most;
  };
  EXPECT_NEAR(largest(wideOf(scene, {}, Range::open)), scene::encodedSrgb(4 * scene::decodedSrgb(0.95f)),
              1e-4);
  EXPECT_EQ(largest(wideOf(scene, {}, Range::limited)), 1);
  size_t others = 0;
  EXPECT_LE(apartFrom(bytesOf(scene, {}), wideOf(scene, {}, Range::limited), others), 2)
      << "edges of what is too bright are those of the window";
}

TEST(WideShot, IsTheSameInBands) {
  const SavedScene scene = sceneOf(averaged(unlit(balls(kSide))));
  ShotOptions options{.size = {200, 300}, .fit = Fit::stretch};
  const std::vector<glm::vec4> whole = wideOf(scene, options, Range::open);
  options.bandPixels = 1;
  EXPECT_TRUE(wideOf(scene, options, Range::open) == whole);
}

TEST(LinearColor, DecodesWhatIsDisplayed) {
  const auto near = [](const glm::vec4& a, const glm::vec4& b) { return glm::length(a - b) < 1e-6f; };
  EXPECT_TRUE(near(lightOf({1, 0.5f, 0, 1}), {1, scene::decodedSrgb(0.5f), 0, 1}));
  EXPECT_TRUE(near(lightOf({0.5f, 0.25f, 0, 0.5f}), {0.5f, scene::decodedSrgb(0.5f) / 2, 0, 0.5f}));
  EXPECT_TRUE(near(lightOf({1, 0.5f, 0, 0}), {1, scene::decodedSrgb(0.5f), 0, 0}));
  EXPECT_GT(lightOf({2, 0, 0, 1}).r, 4) << "the curve goes on";
}

}  // namespace
}  // namespace gluray::saved
