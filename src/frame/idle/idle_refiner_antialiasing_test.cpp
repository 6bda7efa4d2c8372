// Images of a window that get better below the program's anti-aliasing.
#include "frame/testing/idle_refiner_stage.h"

namespace gluray::frame {
namespace {

using namespace std::chrono_literals;

/// The program's anti-aliasing went over the image and what stood beside it before.
struct AntialiasedWindow : IdleRefinerTest {
  scene::Fxaa fxaa;
  IdleFxaa pass;

  AntialiasedWindow() {
    tracer.antialias = [this](const Settings& settings, const scene::Fxaa& how, const uint32_t* in, int width,
                              int height, uint32_t* out) {
      return renderer.antialias(settings, how, in, width, height, out);
    };
    std::vector<uint32_t> before = first.color;
    for (size_t i = 0; i < 100; ++i) before[i] = 0xff123456;  // drawn over the image
    pass = {fxaa, {0, 0, first.width, first.height}, scene->settings, before};
    window->show(first.width, first.height, smoothed(before));
  }
  std::vector<uint32_t> smoothed(const std::vector<uint32_t>& in) {
    std::vector<uint32_t> out(in.size());
    EXPECT_TRUE(renderer.antialias(scene->settings, fxaa, in.data(), first.width, first.height, out.data()));
    return out;
  }
  void refine() {
    IdleRefiner refiner(tracer, 1ms);
    refiner.start(frameOf(written(), window, {pass}));
    waitForRest(refiner);
  }
  void expectLeftAlone() {
    const std::vector<uint32_t> shown = window->colors();
    const uint64_t refused = IdleRefiner::counts().refused;
    IdleRefiner refiner(tracer, 1ms);
    refiner.start(frameOf(written(), window, {pass}));
    EXPECT_TRUE(waitFor([&] { return IdleRefiner::counts().refused > refused; }));
    EXPECT_EQ(window->colors(), shown);
    EXPECT_EQ(passes, 0);
  }
};

TEST_F(AntialiasedWindow, IsRefinedBeforeItsAntiAliasing) {
  ASSERT_NE(window->colors(), pass.before) << "anti-aliasing changes noise";
  refine();
  scene::Snapshot many = *scene;
  many.settings.ao.samples = 1024;
  Image truth, now = seen();
  scene::TraceCost cost;
  std::string error;
  ASSERT_TRUE(renderer.render(many, truth, cost, error));
  truth.color = smoothed(truth.color);
  for (size_t i = 0; i < 160; ++i) truth.color[i] = now.color[i];  // below and beside what is drawn over
  EXPECT_LT(test::difference(now, truth), 0.02);
  const std::vector<uint32_t> after = window->colors();
  for (size_t i = 0; i < 32; ++i) EXPECT_EQ(after[i] & 0xffffff, 0x123456u) << i;
}

TEST_F(AntialiasedWindow, WhatWasDrawnAfterwardsStays) {
  std::vector<uint32_t> overlaid = window->colors();
  for (size_t i = 600; i < 700; ++i) overlaid[i] = 0xffff00ff;
  for (size_t i = 750; i < 800; ++i) overlaid[i] ^= 0x010101;
  window->show(first.width, first.height, overlaid);
  refine();
  const std::vector<uint32_t> after = window->colors();
  for (size_t i = 600; i < 700; ++i) EXPECT_EQ(after[i], 0xffff00ff);
  for (size_t i = 750; i < 800; ++i) EXPECT_EQ(after[i], overlaid[i]);
  EXPECT_NE(after, overlaid);
}

TEST_F(AntialiasedWindow, OfAnotherImageIsLeftAlone) {
  for (uint32_t& color : pass.before) color ^= 0x404040;
  expectLeftAlone();
}

TEST_F(AntialiasedWindow, PassesOutsideTheWindowAreForgotten) {
  for (const scene::Region region : {scene::Region{-1, 0, 32, 32}, scene::Region{0, 0, 33, 32},
                                     scene::Region{0, 0, 0, 0}, scene::Region{2147483647, 0, 32, 32}}) {
    pass.region = region;
    expectLeftAlone();
  }
}

}  // namespace
}  // namespace gluray::frame
