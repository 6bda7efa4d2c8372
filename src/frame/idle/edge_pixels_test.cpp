// Edges of images that move with one sample per pixel and rest with several.
#include "frame/idle/edge_pixels.h"

#include "base/sanitized.h"
#include "frame/testing/idle_refiner_stage.h"
#include "frame/testing/mixed_scenes.h"
#include "scene/premultiplied.h"

#include <algorithm>
#include <cstdlib>
#include <functional>

namespace gluray::frame {
namespace {

using namespace std::chrono_literals;
using scene::blended, scene::LightSampling;

constexpr int kBallSide = 64;
using Background = std::function<uint32_t(int x, int y)>;

uint32_t even(int /*x*/, int /*y*/) { return 0xff604020; }
uint32_t gradient(int /*x*/, int y) { return 0xff202020u + 0x010101u * static_cast<uint32_t>(y); }

/// Balls over a background in a window, drawn while the camera moves.
struct MovingBalls : IdleRefinerTest {
  MovingBalls() { draw(even); }
  void draw(const Background& behind) {
    *scene = test::averaged(test::balls(kBallSide, test::Floor::none), 16);
    scene->lightSampling = {.mode = LightSampling::Mode::moving, .aliased = true};
    scene->settings.noise = 0.01f;
    scene->settings.denoise = Denoise::off;
    first.missColor = 0;
    scene::TraceCost cost;
    std::string error;
    EXPECT_TRUE(renderer.render(*scene, first, cost, error)) << error;
    for (size_t i = 0; i < first.color.size(); ++i)
      if (first.depth[i] == Image::kMiss) first.color[i] = behind(xOf(i), yOf(i));
    window->show(kBallSide, kBallSide, first.color);
  }
  static int xOf(size_t i) { return static_cast<int>(i) % kBallSide; }
  static int yOf(size_t i) { return static_cast<int>(i) / kBallSide; }
  std::vector<IdleImage> images() {
    std::vector<IdleImage> all = written();
    for (const float depth : first.depth) all[0].hits.push_back(depth != Image::kMiss);
    return all;
  }
  void refine() {
    IdleRefiner refiner(tracer, 1ms);
    refiner.start(frameOf(images(), window));
    waitForRest(refiner);
  }
  /// What the program shows with all samples.
  std::vector<uint32_t> truth(const Background& behind) {
    scene::Snapshot still = test::manyRays(*scene, 16);
    still.lightSampling.mode = LightSampling::Mode::full;
    Image image;
    scene::TraceCost cost;
    std::string error;
    EXPECT_TRUE(renderer.render(still, image, cost, error)) << error;
    EXPECT_TRUE(image.isAverages());
    for (size_t i = 0; i < image.color.size(); ++i)
      image.color[i] = blended(image.color[i], behind(xOf(i), yOf(i)));
    return image.color;
  }
};

int apart(uint32_t a, uint32_t b) {
  int most = 0;
  for (int shift = 0; shift < 24; shift += 8)
    most = std::max(most, std::abs(static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255)));
  return most;
}

int countApart(const std::vector<uint32_t>& a, const std::vector<uint32_t>& b, int least) {
  int count = 0;
  for (size_t i = 0; i < a.size(); ++i) count += apart(a[i], b[i]) >= least;
  return count;
}

TEST_F(MovingBalls, AreDrawnWithOneSamplePerPixel) {
  EXPECT_FALSE(first.isAverages());
  scene::Snapshot lens = *scene, usual = *scene;
  lens.settings.camera.aperture = 0.1f;
  usual.lightSampling.aliased = false;
  for (const scene::Snapshot& s : {lens, usual}) {
    Image image;
    scene::TraceCost cost;
    std::string error;
    ASSERT_TRUE(renderer.render(s, image, cost, error)) << error;
    EXPECT_TRUE(image.isAverages());
  }
}

TEST_F(MovingBalls, GetSmoothEdgesAtRest) {
  for (const Background& behind : {Background(even), Background(gradient)}) {
    draw(behind);
    const std::vector<uint32_t> wanted = truth(behind);
    ASSERT_GT(countApart(window->colors(), wanted, 24), 150) << "pixels of edges";
    refine();
    EXPECT_LE(countApart(window->colors(), wanted, 24), 4);
  }
}

TEST_F(MovingBalls, GetNoEdgesUnderWhatWasDrawnOverThem) {
  std::vector<uint32_t> overlaid = window->colors();
  const auto covered = [](size_t i) { return xOf(i) >= 20 && xOf(i) < 44 && yOf(i) % 16 < 8; };
  for (size_t i = 0; i < overlaid.size(); ++i)
    if (covered(i)) overlaid[i] = 0xffffffff;
  window->show(kBallSide, kBallSide, overlaid);
  const std::vector<uint32_t> wanted = truth(even);
  ASSERT_GT(countApart(overlaid, wanted, 24), 150);
  refine();
  const std::vector<uint32_t> after = window->colors();
  int smoothed = 0;
  for (size_t i = 0; i < after.size(); ++i) {
    if (covered(i)) {
      EXPECT_EQ(after[i], overlaid[i]) << xOf(i) << ' ' << yOf(i);
    } else {
      smoothed += first.depth[i] == Image::kMiss && after[i] != overlaid[i];
    }
  }
  EXPECT_GT(smoothed, 20) << "edges beside the overlay";
}

TEST_F(MovingBalls, KeepTheirColourBeforeABackgroundThatIsUneven) {
  const auto chequered = [](int x, int y) { return (x + y) % 2 ? 0xff000000u : 0xffffffffu; };
  draw(chequered);
  const std::vector<uint32_t> before = window->colors();
  refine();
  const std::vector<uint32_t> after = window->colors();
  for (size_t i = 0; i < after.size(); ++i)
    if (first.depth[i] == Image::kMiss) { EXPECT_EQ(after[i], before[i]); }
  // Inside, and on edges with the whole colour of the surface.
  EXPECT_GT(countApart(before, after, 1), 300);
  EXPECT_LT(countApart(before, after, 160), 8);
}

/// A window of 8x8 pixels, whose left half shows a surface.
struct Halves : testing::Test {
  WindowPixels window{8, 8, std::vector<uint32_t>(64, 0xff808080)};
  Compared compared{window, {0, 0}, {8, 8}, std::vector<bool>(64)};
  std::vector<uint8_t> hits = std::vector<uint8_t>(64);
  bool covered = false;
  Halves() {
    for (size_t i = 0; i < 64; ++i)
      if (i % 8 < 4) hits[i] = 1, compared.equal[i] = true, window.colors[i] = 0xff0000ff;
  }
  std::optional<uint32_t> behind(int x, int y) {
    return colorBehind({compared, hits, [&](glm::ivec2) { return covered; }}, {x, y});
  }
};

TEST_F(Halves, OfferTheColourBesideTheEdge) {
  window.colors[8 * 4 + 5] = 0xff828080;  // nearly equal
  EXPECT_EQ(behind(3, 4), 0xff808080u);
  EXPECT_EQ(behind(2, 4), 0xff808080u);
  EXPECT_EQ(behind(1, 4), std::nullopt) << "far from the edge";
  EXPECT_EQ(behind(5, 4), 0xff828080u) << "its own";
  EXPECT_EQ(behind(6, 4), std::nullopt);
}

TEST_F(Halves, OfferNothingWhereSomethingElseIsDrawn) {
  covered = true;
  EXPECT_EQ(behind(3, 4), std::nullopt);
  EXPECT_EQ(behind(4, 4), std::nullopt);
  covered = false;
  window.colors[8 * 4 + 5] = 0xffffffff;
  EXPECT_EQ(behind(3, 4), std::nullopt);
  EXPECT_EQ(behind(4, 4), std::nullopt);
  EXPECT_EQ(behind(3, 1), 0xff808080u);
  window.colors[8 * 4 + 5] = 0xff808080, compared.equal[8 * 4 + 3] = false;
  EXPECT_EQ(behind(3, 4), std::nullopt);
  EXPECT_EQ(behind(5, 4), std::nullopt);
}

TEST(EdgePixels, ShowWhatIsBehindThem) {
  EXPECT_EQ(shownColor(0xff102030, 0xffffffffu), 0xff102030);
  EXPECT_EQ(shownColor(0x80400000, 0xff000080u), blended(0x80400000, 0xff000080));
  EXPECT_EQ(shownColor(0, 0xff123456u), 0xff123456);
  EXPECT_EQ(shownColor(0, std::nullopt), std::nullopt);
  EXPECT_EQ(shownColor(0x80402010, std::nullopt), 0xff804020);
}

}  // namespace
}  // namespace gluray::frame
