// Images that a program reads after they were written.
#include "frame/images/frame_images.h"

#include "frame/images/traced_images.h"
#include "frame/testing/lit_scene.h"

#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <thread>

namespace gluray::frame {
namespace {

/// Pixels that the program reads.
class ReadWindow final : public IdleWindow {
 public:
  explicit ReadWindow(WindowPixels pixels) : pixels(std::move(pixels)) {}
  bool read(WindowPixels& out) noexcept override {
    const std::lock_guard lock(mutex_);
    return out = pixels, true;
  }
  bool replace(const WindowPixels&, const WindowPixels& next) noexcept override {
    const std::lock_guard lock(mutex_);
    return pixels = next, true;
  }
  bool isEqual(const std::vector<uint32_t>& colors) {
    const std::lock_guard lock(mutex_);
    return pixels.colors == colors;
  }
  WindowPixels pixels;

 private:
  std::mutex mutex_;
};

struct FrameImagesTest : testing::Test {
  test::CountingTrace tracer;
  std::shared_ptr<scene::Snapshot> scene = std::make_shared<scene::Snapshot>(test::litScene());
  TracedImages images{Tracer{
      .trace = tracer.trace,
      .behind = [this](const scene::Snapshot& s, Image& image, scene::TraceCost& cost, std::string& error,
                       const std::function<bool()>&) { return tracer.trace(s, image, cost, error); }}};
  WindowPixels first;
  Image finished;
  std::vector<uint32_t> truth;

  FrameImagesTest() {
    scene->lightSampling.mode = scene::LightSampling::Mode::moving;
    scene::Snapshot full = *scene;
    full.lightSampling.mode = scene::LightSampling::Mode::full;
    finished = TracedImages(Tracer{tracer.trace}).imageOf(full, {.finished = true}).cached->image;
    truth = finished.color;
  }
  void write() {
    const ImageCache::CachedImage* const cached = images.imageOf(*scene, {}).cached;
    images.frame().wrote(scene, *cached, cached->image);
    first = {cached->image.width, cached->image.height, cached->image.color};
  }
  FrameImages::Finished readInto(WindowPixels& pixels) {
    const auto window = std::make_shared<ReadWindow>(std::move(pixels));
    const FrameImages::Finished result = images.frame().finishIn(window);
    pixels = window->pixels;
    return result;
  }
};

TEST_F(FrameImagesTest, AreFinishedForReads) {
  write();
  EXPECT_EQ(images.frame().regions(), (std::vector<scene::Region>{{0, 0, first.width, first.height}}));
  WindowPixels read = first, again = first;
  EXPECT_NE(read.colors, truth);
  const int before = tracer.traces;
  const FrameImages::Finished result = readInto(read);
  EXPECT_TRUE(result.any);
  EXPECT_GE(result.passes, 4u);
  EXPECT_EQ(result.passes, static_cast<uint32_t>(tracer.traces - before));
  EXPECT_GT(result.cost.traceSeconds, 0);
  EXPECT_LE(result.noise, double{scene->settings.noise});
  EXPECT_EQ(read.colors, truth) << "as if it had been read before it was written";
  const int traces = tracer.traces;
  const FrameImages::Finished second = readInto(again);
  EXPECT_TRUE(second.any);
  EXPECT_EQ(second.passes, 0u);
  EXPECT_EQ(again.colors, truth);
  EXPECT_EQ(tracer.traces, traces) << "a second read traces nothing";
}

TEST_F(FrameImagesTest, MoveWithOneSampleWhereTheWindowIsRefined) {
  scene->settings.spp = 4;
  std::shared_ptr<ReadWindow> window;
  const auto movedOn = [&] {
    scene->eyeFromWorld[3].x += 0.01;
    for (scene::Instance& instance : scene->instances) instance.eyeFromObject = scene->eyeFromWorld;
    write();
    const bool averages = images.imageOf(*scene, {.asShown = true}).cached->image.isAverages();
    if (window) window = std::make_shared<ReadWindow>(first);
    images.frame().refineWhileIdle([&] { return window; });
    return averages;
  };
  EXPECT_TRUE(movedOn()) << "not known yet";
  EXPECT_TRUE(movedOn()) << "a window that is not refined";
  window = std::make_shared<ReadWindow>(first);
  EXPECT_TRUE(movedOn());
  EXPECT_FALSE(movedOn());
  images.frame().refineWhileIdle({});
  EXPECT_TRUE(movedOn()) << "without light";
}

TEST_F(FrameImagesTest, MoveWithAllSamplesWhereTheWindowShowsSomethingElse) {
  scene->settings.spp = 4;
  write();
  WindowPixels other = first;
  for (uint32_t& color : other.colors) color ^= 0x030303;
  const uint64_t refused = IdleRefiner::counts().refused;
  images.frame().refineWhileIdle([&] { return std::make_shared<ReadWindow>(other); });
  EXPECT_TRUE(images.frame().restsInWindow());
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (IdleRefiner::counts().refused == refused && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_FALSE(images.frame().restsInWindow());
}

TEST_F(FrameImagesTest, AreFinishedAfterTheyWereShown) {
  write();
  images.frame().refineWhileIdle([] { return nullptr; });
  WindowPixels read = first, again = first;
  EXPECT_TRUE(readInto(read).any);
  EXPECT_EQ(read.colors, truth);
  EXPECT_TRUE(readInto(again).any);
  EXPECT_EQ(again.colors, truth);
}

TEST_F(FrameImagesTest, TheWindowGoesOnAfterARead) {
  write();
  const auto window = std::make_shared<ReadWindow>(first);
  images.frame().refineWhileIdle([&] { return window; });
  WindowPixels read = first;
  EXPECT_TRUE(readInto(read).any);
  EXPECT_EQ(read.colors, truth);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  bool same = false;
  while (!same && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    same = window->isEqual(truth);
  }
  EXPECT_TRUE(same);
}

TEST_F(FrameImagesTest, AreForgottenWithoutAWindowToOpen) {
  write();
  const std::weak_ptr<const scene::Snapshot> kept = scene;
  images.frame().refineWhileIdle([] { return nullptr; });
  scene.reset();
  EXPECT_FALSE(kept.expired());
  images.frame().refineWhileIdle({});
  EXPECT_TRUE(kept.expired());
  EXPECT_TRUE(images.frame().regions().empty());
}

TEST_F(FrameImagesTest, ThatTheWindowShowsAreRepeatedAsTheyAre) {
  write();
  images.frame().refineWhileIdle([] { return nullptr; });
  const int traces = tracer.traces;
  const TracedImages::Result again = images.imageOf(*scene, {.asShown = true});
  EXPECT_TRUE(again.repeated);
  EXPECT_EQ(again.cached->image.color, first.colors);
  images.frame().wrote(scene, *again.cached, again.cached->image);
  EXPECT_EQ(tracer.traces, traces);
  WindowPixels read = first;
  EXPECT_TRUE(readInto(read).any);
  EXPECT_EQ(read.colors, truth);
}

TEST_F(FrameImagesTest, WhatIsDrawnOverThemStays) {
  write();
  WindowPixels read = first;
  const auto middle = static_cast<size_t>(first.height / 2 * first.width);
  for (int x = 0; x < first.width; ++x) read.colors[middle + static_cast<size_t>(x)] = 0xffff00ff;
  EXPECT_TRUE(readInto(read).any);
  for (int x = 0; x < first.width; ++x) EXPECT_EQ(read.colors[middle + static_cast<size_t>(x)], 0xffff00ff);
  EXPECT_EQ(read.colors[0], truth[0]);
}

TEST_F(FrameImagesTest, AnotherImageIsLeftAlone) {
  write();
  WindowPixels other = first;
  for (uint32_t& color : other.colors) color ^= 0x010101;
  const WindowPixels before = other;
  const int traces = tracer.traces;
  EXPECT_FALSE(readInto(other).any);
  EXPECT_EQ(other.colors, before.colors);
  EXPECT_EQ(tracer.traces, traces) << "and costs no rays";
}

TEST_F(FrameImagesTest, PassesOfAReadCountWhenTheFrameIsDrawnAgain) {
  write();
  WindowPixels read = first;
  readInto(read);
  const int traces = tracer.traces;
  auto same = std::make_shared<scene::Snapshot>(*scene);
  ++same->frame;
  const TracedImages::Result result = images.imageOf(*same, {});
  EXPECT_LE(tracer.traces, traces + 1) << "the one that tells what is where";
  EXPECT_TRUE(result.cached->refined);
  EXPECT_LT(test::difference(result.cached->image, finished), 0.004);
}

TEST_F(FrameImagesTest, ThoseOfAnEarlierFrameAreForgotten) {
  write();
  images.frame().refineWhileIdle([] { return nullptr; });
  EXPECT_FALSE(images.frame().regions().empty());
  auto moved = std::make_shared<scene::Snapshot>(*scene);
  ++moved->frame;
  moved->eyeFromWorld[3].x += 0.1;
  images.imageOf(*moved, {});
  EXPECT_TRUE(images.frame().regions().empty());
  EXPECT_FALSE(readInto(first).any);
}

TEST_F(FrameImagesTest, FinishedOnesAreNotRemembered) {
  scene->lightSampling.mode = scene::LightSampling::Mode::full;
  write();
  EXPECT_TRUE(images.frame().regions().empty());
  EXPECT_EQ(first.colors, truth);
}

}  // namespace
}  // namespace gluray::frame
