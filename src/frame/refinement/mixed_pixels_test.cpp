// Denoising of images whose pixels mix samples, surfaces and layers.
#include "base/log.h"
#include "base/sanitized.h"
#include "frame/refinement/denoiser.h"
#include "frame/testing/mixed_scenes.h"
#include "scene/backdrop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gluray::frame {
namespace {

using test::averaged, test::balls, test::blurred, test::caught, test::Floor, test::layered, test::manyRays,
    test::Refined;

scene::Snapshot denoised(scene::Snapshot s) {
  s.settings.denoise = Denoise::filter;
  return s;
}

/// A channel of a pixel, 0 .. 1; red, green and blue over white.
double onWhite(const Image& image, size_t pixel, unsigned channel) {
  const uint32_t bits = image.color[pixel], alpha = bits >> 24;
  return (static_cast<double>(bits >> (8 * channel) & 255) + (channel < 3 ? 255.0 - alpha : 0)) / 255;
}

/// dB, of the pixels for which counts(pixel) is true.
template <class Counts>
double psnrOf(const Image& a, const Image& b, const Counts& counts) {
  double sum = 0;
  size_t values = 0;
  for (size_t i = 0; i < a.color.size(); ++i)
    for (unsigned c = 0; c < 3 && counts(i); ++c, ++values)
      sum += std::pow(onWhite(a, i, c) - onWhite(b, i, c), 2);
  return -10 * std::log10(sum / static_cast<double>(values));
}
double psnrOf(const Image& a, const Image& b) {
  return psnrOf(a, b, [](size_t) { return true; });
}

scene::Snapshot filteredBy(PixelFilter filter, scene::Snapshot s) {
  s.settings.pixelFilter = filter;
  return s;
}

/// Before a background that changes from below to above.
scene::Snapshot behind(scene::Snapshot s) {
  s.settings.background.kind = BackgroundKind::gradient;
  s.backdrop = std::make_shared<scene::Backdrop>();
  return s;
}

/// The shadow alone, over surfaces that the framebuffer has.
scene::Snapshot catching(scene::Snapshot s) {
  s.catches = true;
  return s;
}

/// Some 2000 rays a pixel. Passes take at most 16; many of them would take too long where pixels average
/// samples.
Image converged(const scene::Snapshot& s) {
  return s.settings.spp > 1 ? test::CountingTrace().image(manyRays(s, 128))
                            : Refined(manyRays(s, 16), 128).image;
}

TEST(MixedPixels, AreNearerToTheConvergedImageInEachCombination) {
  GLURAY_RELEASE_ONLY();
  const scene::Snapshot onFloor = balls(96), free = balls(96, Floor::none);
  const std::pair<const char*, scene::Snapshot> scenes[] = {
      {"samples", averaged(onFloor)},
      {"few samples", averaged(onFloor, 4)},
      {"gauss", filteredBy(PixelFilter::gauss, averaged(onFloor))},
      {"mitchell", filteredBy(PixelFilter::mitchell, averaged(onFloor))},
      {"layers", layered(free)},
      {"layers and samples", averaged(layered(free))},
      {"catcher", averaged(caught(free))},
      {"catcher alone", caught(free)},
      {"background", behind(averaged(onFloor))},
      {"catcher and background", behind(averaged(caught(free)))},
      {"surfaces that catch", catching(onFloor)},
      {"surfaces that catch, samples", catching(averaged(onFloor))},
  };
  for (const auto& [name, s] : scenes) {
    const Image truth = converged(s);
    const double plain = psnrOf(Refined(s, 4).image, truth),
                 filtered = psnrOf(Refined(denoised(s), 4).image, truth);
    RecordProperty(name, std::to_string(plain) + " to " + std::to_string(filtered));
    EXPECT_GT(filtered, plain + 1.5) << name << ": " << plain;
  }
}

TEST(MixedPixels, ThroughALensAreNearerToTheConvergedImage) {
  GLURAY_RELEASE_ONLY();
  const scene::Snapshot s = blurred(balls(64, Floor::plane, 4));
  const Image truth = Refined(s, 400).image;
  const double plain = psnrOf(Refined(s, 4).image, truth),
               filtered = psnrOf(Refined(denoised(s), 4).image, truth);
  EXPECT_GT(filtered, plain + 0.5) << plain;
}

TEST(MixedPixels, OfAConvergedImageKeepTheirBits) {
  for (scene::Snapshot s : {averaged(balls(48), 4), layered(balls(48, Floor::none)),
                            averaged(caught(balls(48, Floor::none)), 4)}) {
    s.settings.noise = 0.5f;  // more than any pixel has
    EXPECT_EQ(Refined(denoised(s), 4).image.color, Refined(s, 4).image.color);
  }
}

TEST(MixedPixels, KeepTheColoursThatNoEffectChanges) {
  for (const bool layers : {false, true}) {
    scene::Snapshot s = averaged(balls(64, Floor::none), 6);
    if (layers) s = layered(s, 0.37f);
    s.settings.ao.radius = 1e-9f;
    const Image filtered = Refined(denoised(s), 5).image;
    s.settings.ao.enabled = false;
    EXPECT_EQ(filtered.color, test::CountingTrace().image(s).color) << layers;
  }
}

/// A white wall, of whose sky a half or more is hidden, and a yellow plate before its right half.
scene::Snapshot edgeScene() {
  const glm::vec3 tilt(0.17f, 0.985f, 0);  // the edge crosses pixels at all places
  scene::Snapshot s =
      gluray::test::makeSnapshot({test::plane({0, 0, 0}, {500, 0, 0}, {0, 500, 0}),
                                  test::plane(glm::vec3(2, 0, 3), glm::vec3(2, 0, 0), 9.0f * tilt),
                                  test::plane({-2.2f, 0, 10}, {0, 50, 0}, {0, 0, 10})},
                                 64);
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5});
  for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
  s.instances[1].color = {1, 0.6f, 0.2f, 1};
  s.settings.ao.enabled = true;
  s.settings.ao.samples = 16;
  s.settings.ao.radius = 100;
  s.settings.noise = 0.002f;
  return averaged(s);
}

TEST(MixedPixels, OfAnEdgeKeepTheirShape) {
  GLURAY_RELEASE_ONLY();
  const scene::Snapshot s = edgeScene();
  const Image truth = test::CountingTrace().image(manyRays(s, 256)), plain = Refined(s, 4).image,
              filtered = Refined(denoised(s), 4).image;
  // Pixels of the edge have neither the left nor the right neighbour's colour.
  std::vector<char> isEdge(truth.color.size());
  int edges = 0;
  for (size_t i = 3; i + 3 < truth.color.size(); ++i) {
    const auto red = [&](size_t at) { return onWhite(truth, at, 0); };
    const double low = std::min(red(i - 2), red(i + 2)), high = std::max(red(i - 2), red(i + 2));
    isEdge[i] = high - low > 0.2 && red(i) > low + 0.03 && red(i) < high - 0.03;
    edges += isEdge[i];
  }
  ASSERT_GT(edges, 40);
  const auto onEdge = [&](size_t i) { return isEdge[i] != 0; };
  EXPECT_GT(psnrOf(filtered, truth, onEdge), psnrOf(plain, truth, onEdge) + 2);
  for (size_t i = 0; i < isEdge.size(); ++i)
    if (isEdge[i]) {
      EXPECT_NEAR(onWhite(filtered, i, 0), onWhite(truth, i, 0), 0.05)
          << i % 64 << ' ' << i / 64 << ", unfiltered " << onWhite(plain, i, 0);
    }
}

TEST(MixedPixels, AreTheSameForAnyNumberOfThreads) {
  scene::Snapshot s = denoised(averaged(caught(balls(100, Floor::none)), 4));
  const Refined one(s, 2);
  s.settings.threads = 5;
  EXPECT_EQ(one.image.color, Refined(s, 2).image.color);
}

TEST(MixedPixels, OfALensHaveFeaturesOfFourPasses) {
  const Refined lens(denoised(blurred(balls(32))), 6), none(denoised(averaged(balls(32), 4)), 6);
  EXPECT_EQ(lens.refinement.features.passes, 4u);
  EXPECT_EQ(lens.tracer.traces, 6 + 8);
  EXPECT_EQ(none.tracer.traces, 6 + 2);
}

TEST(MixedPixels, TakeTheMemoryThatIsCounted) {
  const Refined on(denoised(averaged(balls(32), 4)), 3);
  const size_t pixels = on.image.depth.size();
  EXPECT_EQ(on.refinement.bytes(), pixels * 48);
  EXPECT_EQ(Refinement::bytesFor(pixels, AuxiliaryFeatures::kMixedBytes), 68 * pixels);
}

TEST(MixedPixels, AlphaThatIsNoOpacityLeavesOneSample) {
  scene::Snapshot s = averaged(balls(48), 4);
  for (scene::Instance& instance : s.instances) instance.color.a = 0.5f;
  const Image filtered = Refined(denoised(s), 4).image, plain = Refined(s, 4).image;
  EXPECT_FALSE(filtered.isAverages());
  EXPECT_NE(filtered.color, plain.color);
}

/// The number of the last messages that contain `text`.
int messagesWith(const std::string& text) {
  int count = 0;
  for (const std::string& line : log::recent()) count += line.find(text) != std::string::npos;
  return count;
}

TEST(Denoiser, SaysOnceWhyItHasNoEffect) {
  scene::Snapshot s = denoised(balls(16));
  logUndenoised(s);
  EXPECT_EQ(messagesWith("denoise has no effect"), 0);
  s.settings.look = Look::honest;
  for (int i = 0; i < 3; ++i) logUndenoised(s);
  EXPECT_EQ(messagesWith("denoise has no effect: look = honest"), 1);
  s = denoised(layered(balls(16)));
  auto layers = std::make_shared<scene::Layers>(*s.layers);
  layers->of = scene::Layers::Of::drawn;
  s.layers = layers;
  for (int i = 0; i < 3; ++i) logUndenoised(s);
  EXPECT_EQ(messagesWith("blended in the order of drawing"), 1);
}

}  // namespace
}  // namespace gluray::frame
