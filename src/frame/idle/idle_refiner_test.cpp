// Images of a window that get better while nothing else happens.
#include "frame/testing/idle_refiner_stage.h"

#include <algorithm>
#include <map>

namespace gluray::frame {
namespace {

using namespace std::chrono_literals;

TEST_F(IdleRefinerTest, TheWindowBecomesCleanerAndThenWorkEnds) {
  scene::Snapshot many = *scene;
  many.settings.ao.samples = 1024;
  scene::TraceCost cost;
  std::string error;
  Image truth;
  ASSERT_TRUE(renderer.render(many, truth, cost, error));
  IdleRefiner refiner(tracer, 1ms);
  refiner.start(frameOf(written(), window));
  waitForRest(refiner);
  EXPECT_LT(test::difference(seen(), truth), 0.012);
  EXPECT_GT(test::difference(first, truth), 0.05);
  EXPECT_GE(window->painted(), 2);
  const int traced = passes;
  refiner.stop();
  const auto refinement = refiner.takePasses(5);
  ASSERT_TRUE(refinement);
  EXPECT_EQ(static_cast<int>(refinement->passes()), traced);
  EXPECT_LE(refinement->noise(), 0.01);
  EXPECT_FALSE(refiner.takePasses(5));
  EXPECT_FALSE(refiner.takePasses(6));
}

TEST_F(IdleRefinerTest, WhatWasDrawnOverTheImageStays) {
  std::vector<uint32_t> overlaid = first.color;
  for (size_t i = 0; i < 200; ++i) overlaid[i] = 0xff123456;
  for (size_t i = 300; i < 400; ++i) overlaid[i] ^= 0x010101;  // blended over
  overlaid[500] ^= 0x80000000;                                 // alpha is not seen
  window->show(first.width, first.height, overlaid);
  IdleRefiner refiner(tracer, 1ms);
  refiner.start(frameOf(written(), window));
  waitForRest(refiner);
  const std::vector<uint32_t> after = window->colors();
  for (size_t i = 0; i < 200; ++i) EXPECT_EQ(after[i], 0xff123456);
  for (size_t i = 300; i < 400; ++i) EXPECT_EQ(after[i], overlaid[i]);
  EXPECT_NE(after, overlaid);
}

TEST_F(IdleRefinerTest, NoiseThatEqualsAFlatOverlayIsNotTakenForTheImage) {
  // An overlay of the image's commonest colour over its middle: some pixels beneath it are equal by chance.
  std::map<uint32_t, int> counts;
  for (const uint32_t color : first.color) ++counts[color];
  const auto common = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<uint32_t> overlaid = first.color;
  const auto covered = [&](size_t i) {
    const int x = static_cast<int>(i) % first.width, y = static_cast<int>(i) / first.width;
    return x >= 8 && x < 24 && y >= 10 && y < 22;
  };
  int equal = 0;
  for (size_t i = 0; i < overlaid.size(); ++i) {
    if (!covered(i)) continue;
    equal += overlaid[i] == common->first;
    overlaid[i] = common->first;
  }
  ASSERT_GT(equal, 5);
  window->show(first.width, first.height, overlaid);
  IdleRefiner refiner(tracer, 1ms);
  refiner.start(frameOf(written(), window));
  waitForRest(refiner);
  const std::vector<uint32_t> after = window->colors();
  for (size_t i = 0; i < after.size(); ++i) {
    if (covered(i)) { EXPECT_EQ(after[i], common->first) << i; }
  }
  EXPECT_NE(after, overlaid);
}

TEST_F(IdleRefinerTest, InsidesOfMultisampledImagesAreRefined) {
  scene->samples = 4;
  scene->samplePositions = {{0.4f, 0.1f}, {0.9f, 0.4f}, {0.1f, 0.6f}, {0.6f, 0.9f}};
  scene::TraceCost cost;
  std::string error;
  ASSERT_TRUE(renderer.render(*scene, first, cost, error));
  first.color.resize(first.color.size() / 4);
  window->show(first.width, first.height, first.color);
  std::vector<IdleImage> images = written();
  images[0].mixed.resize(first.color.size());
  images[0].mixed[500] = 1;
  IdleRefiner refiner(tracer, 1ms);
  refiner.start(frameOf(std::move(images), window));
  waitForRest(refiner);
  const std::vector<uint32_t> after = window->colors();
  EXPECT_NE(after, first.color);
  EXPECT_EQ(after[500], first.color[500]);
}

TEST_F(IdleRefinerTest, AWindowThatShowsSomethingElseIsLeftAlone) {
  std::vector<uint32_t> other = first.color;
  for (uint32_t& color : other) color ^= 0x030303;
  window->show(first.width, first.height, other);
  IdleRefiner refiner(tracer, 1ms);
  const uint64_t refused = IdleRefiner::counts().refused;
  refiner.start(frameOf(written(), window));
  EXPECT_TRUE(waitFor([&] { return IdleRefiner::counts().refused > refused; }));
  EXPECT_EQ(window->colors(), other);
  EXPECT_EQ(passes, 0);
}

TEST_F(IdleRefinerTest, WhatTheProgramShowsMeanwhileStays) {
  scene->settings.noise = 1e-6f;
  IdleRefiner refiner(tracer, 1ms);
  refiner.start(frameOf(written(), window));
  ASSERT_TRUE(waitFor([&] { return window->painted() > 0; }));
  const std::vector<uint32_t> newer(first.color.size(), 0xff00ff00);
  window->show(first.width, first.height, newer);
  waitForRest(refiner);
  EXPECT_EQ(window->colors(), newer);
}

TEST_F(IdleRefinerTest, NothingHappensBeforeItIsQuiet) {
  IdleRefiner refiner(tracer, 10s);
  for (int i = 0; i < 20; ++i) refiner.start(frameOf(written(), window));
  std::this_thread::sleep_for(30ms);
  refiner.stop();
  EXPECT_EQ(passes, 0);
  EXPECT_EQ(window->colors(), first.color);
}

TEST_F(IdleRefinerTest, StopsAtOnceAndLeavesTheLastImage) {
  scene->settings.noise = 1e-6f;
  scene->settings.ao.samples = 1024;  // a pass takes long
  IdleRefiner refiner(tracer, 0ms);
  for (int i = 0; i < 5; ++i) {
    window->show(first.width, first.height, first.color);
    const int before = passes;
    refiner.start(frameOf(written(), window));
    ASSERT_TRUE(waitFor([&] { return passes > before; }));
    std::this_thread::sleep_for(5ms * i);
    refiner.stop();
    const int traced = passes;
    const std::vector<uint32_t> shown = window->colors();
    std::this_thread::sleep_for(5ms);
    EXPECT_EQ(passes, traced);
    EXPECT_EQ(window->colors(), shown);
  }
}

TEST_F(IdleRefinerTest, WindowsMayGo) {
  IdleRefiner refiner(tracer, 1ms);
  window->leave();
  refiner.start(frameOf(written(), window));
  std::this_thread::sleep_for(20ms);
  refiner.start(frameOf(written(), nullptr));
  refiner.start(frameOf({}, window));
  refiner.stop();
  EXPECT_EQ(passes, 0);
}

TEST_F(IdleRefinerTest, EndsWithWorkInHand) {
  scene->settings.noise = 1e-6f;
  IdleRefiner refiner(tracer, 0ms);
  refiner.start(frameOf(written(), window));
  waitFor([&] { return passes > 0; });
}

TEST_F(IdleRefinerTest, AnotherImageComesFirst) {
  scene->settings.noise = 1e-6f;
  IdleRefiner refiner(tracer, 0ms);
  refiner.start(frameOf(written(), window));
  for (int i = 0; i < 20; ++i) {
    Image image;
    scene::TraceCost cost;
    std::string error;
    ASSERT_TRUE(renderer.render(*scene, image, cost, error)) << error;
    ASSERT_EQ(image.color, first.color);
  }
  const int traced = passes;
  EXPECT_TRUE(waitFor([&] { return passes > traced + 2; })) << "it goes on afterwards";
}

TEST_F(IdleRefinerTest, GoesOnFromThePassesSoFar) {
  scene->settings.refine.passes = 12;
  scene->settings.noise = 1e-6f;
  auto refinement = std::make_unique<Refinement>();
  Refiner before(*scene, *refinement);
  scene::TraceCost cost;
  std::string error;
  const Trace trace = [this](const scene::Snapshot& s, Image& image, scene::TraceCost& c, std::string& why) {
    return renderer.render(s, image, c, why);
  };
  for (int i = 0; i < 8; ++i) ASSERT_TRUE(before.pass(trace, 0, cost, error));
  before.show(first);
  window->show(first.width, first.height, first.color);
  std::vector<IdleImage> images = written();
  images[0].refinement = std::move(refinement);
  IdleRefiner refiner(tracer, 1ms);
  refiner.start(frameOf(std::move(images), window));
  waitForRest(refiner);
  EXPECT_EQ(passes, 4);
  EXPECT_EQ(window->painted(), 1);
  refiner.stop();
  EXPECT_EQ(refiner.takePasses(5)->passes(), 12u);
}

TEST_F(IdleRefinerTest, SeveralViewsOfAWindowAreRefined) {
  // Two images side by side.
  auto right = std::make_shared<scene::Snapshot>(*scene);
  const int w = first.width, h = first.height;
  std::vector<uint32_t> both(static_cast<size_t>(2 * w * h));
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < 2 * w; ++x)
      both[static_cast<size_t>(y * 2 * w + x)] = first.color[static_cast<size_t>(y * w + x % w)];
  window->show(2 * w, h, both);
  std::vector<IdleImage> images = written();
  images.push_back({right, 6, {w, 0}, {w, h}, first.color});
  IdleRefiner refiner(tracer, 1ms);
  refiner.start(frameOf(std::move(images), window));
  waitForRest(refiner);
  const std::vector<uint32_t> after = window->colors();
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      ASSERT_EQ(after[static_cast<size_t>(y * 2 * w + x)], after[static_cast<size_t>(y * 2 * w + w + x)]);
  EXPECT_NE(after, both);
}

}  // namespace
}  // namespace gluray::frame
