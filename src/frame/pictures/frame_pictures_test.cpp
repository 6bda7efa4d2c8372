// Pictures that a program reads after they were written.
#include "frame/pictures/frame_pictures.h"

#include "frame/pictures/traced_pictures.h"
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

struct FramePicturesTest : testing::Test {
  test::CountingTrace tracer;
  std::shared_ptr<scene::Snapshot> scene = std::make_shared<scene::Snapshot>(test::litScene());
  TracedPictures pictures{Tracer{
      .trace = tracer.trace,
      .behind = [this](const scene::Snapshot& s, Image& image, scene::TraceCost& cost, std::string& error,
                       const std::function<bool()>&) { return tracer.trace(s, image, cost, error); }}};
  WindowPixels first;
  Image finished;
  std::vector<uint32_t> truth;

  FramePicturesTest() {
    scene->lightSampling.mode = scene::LightSampling::Mode::moving;
    scene::Snapshot full = *scene;
    full.lightSampling.mode = scene::LightSampling::Mode::full;
    finished = TracedPictures(Tracer{tracer.trace}).pictureOf(full, {.finished = true}).picture->image;
    truth = finished.color;
  }
  void write() {
    const LastPictures::Picture* const picture = pictures.pictureOf(*scene, {}).picture;
    pictures.frame().wrote(scene, *picture, picture->image);
    first = {picture->image.width, picture->image.height, picture->image.color};
  }
  FramePictures::Finished readInto(WindowPixels& pixels) {
    const auto window = std::make_shared<ReadWindow>(std::move(pixels));
    const FramePictures::Finished result = pictures.frame().finishIn(window);
    pixels = window->pixels;
    return result;
  }
};

TEST_F(FramePicturesTest, AreFinishedForReads) {
  write();
  EXPECT_EQ(pictures.frame().regions(), (std::vector<scene::Region>{{0, 0, first.width, first.height}}));
  WindowPixels read = first, again = first;
  EXPECT_NE(read.colors, truth);
  const int before = tracer.traces;
  const FramePictures::Finished result = readInto(read);
  EXPECT_TRUE(result.any);
  EXPECT_GE(result.passes, 4u);
  EXPECT_EQ(result.passes, static_cast<uint32_t>(tracer.traces - before));
  EXPECT_GT(result.cost.traceSeconds, 0);
  EXPECT_LE(result.noise, double{scene->settings.noise});
  EXPECT_EQ(read.colors, truth) << "as if it had been read before it was written";
  const int traces = tracer.traces;
  const FramePictures::Finished second = readInto(again);
  EXPECT_TRUE(second.any);
  EXPECT_EQ(second.passes, 0u);
  EXPECT_EQ(again.colors, truth);
  EXPECT_EQ(tracer.traces, traces) << "a second read traces nothing";
}

TEST_F(FramePicturesTest, AreFinishedAfterTheyWereShown) {
  write();
  pictures.frame().refineWhileIdle([] { return nullptr; });
  WindowPixels read = first, again = first;
  EXPECT_TRUE(readInto(read).any);
  EXPECT_EQ(read.colors, truth);
  EXPECT_TRUE(readInto(again).any);
  EXPECT_EQ(again.colors, truth);
}

TEST_F(FramePicturesTest, TheWindowGoesOnAfterARead) {
  write();
  const auto window = std::make_shared<ReadWindow>(first);
  pictures.frame().refineWhileIdle([&] { return window; });
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

TEST_F(FramePicturesTest, AreForgottenWithoutAWindowToOpen) {
  write();
  const std::weak_ptr<const scene::Snapshot> kept = scene;
  pictures.frame().refineWhileIdle([] { return nullptr; });
  scene.reset();
  EXPECT_FALSE(kept.expired());
  pictures.frame().refineWhileIdle({});
  EXPECT_TRUE(kept.expired());
  EXPECT_TRUE(pictures.frame().regions().empty());
}

TEST_F(FramePicturesTest, ThatTheWindowShowsAreRepeatedAsTheyAre) {
  write();
  pictures.frame().refineWhileIdle([] { return nullptr; });
  const int traces = tracer.traces;
  const TracedPictures::Result again = pictures.pictureOf(*scene, {.asShown = true});
  EXPECT_TRUE(again.repeated);
  EXPECT_EQ(again.picture->image.color, first.colors);
  pictures.frame().wrote(scene, *again.picture, again.picture->image);
  EXPECT_EQ(tracer.traces, traces);
  WindowPixels read = first;
  EXPECT_TRUE(readInto(read).any);
  EXPECT_EQ(read.colors, truth);
}

TEST_F(FramePicturesTest, WhatIsDrawnOverThemStays) {
  write();
  WindowPixels read = first;
  const auto middle = static_cast<size_t>(first.height / 2 * first.width);
  for (int x = 0; x < first.width; ++x) read.colors[middle + static_cast<size_t>(x)] = 0xffff00ff;
  EXPECT_TRUE(readInto(read).any);
  for (int x = 0; x < first.width; ++x) EXPECT_EQ(read.colors[middle + static_cast<size_t>(x)], 0xffff00ff);
  EXPECT_EQ(read.colors[0], truth[0]);
}

TEST_F(FramePicturesTest, AnotherPictureIsLeftAlone) {
  write();
  WindowPixels other = first;
  for (uint32_t& color : other.colors) color ^= 0x010101;
  const WindowPixels before = other;
  const int traces = tracer.traces;
  EXPECT_FALSE(readInto(other).any);
  EXPECT_EQ(other.colors, before.colors);
  EXPECT_EQ(tracer.traces, traces) << "and costs no rays";
}

TEST_F(FramePicturesTest, PassesOfAReadCountWhenTheFrameIsDrawnAgain) {
  write();
  WindowPixels read = first;
  readInto(read);
  const int traces = tracer.traces;
  auto same = std::make_shared<scene::Snapshot>(*scene);
  ++same->frame;
  const TracedPictures::Result result = pictures.pictureOf(*same, {});
  EXPECT_LE(tracer.traces, traces + 1) << "the one that tells what is where";
  EXPECT_TRUE(result.picture->refined);
  EXPECT_LT(test::difference(result.picture->image, finished), 0.004);
}

TEST_F(FramePicturesTest, ThoseOfAnEarlierFrameAreForgotten) {
  write();
  pictures.frame().refineWhileIdle([] { return nullptr; });
  EXPECT_FALSE(pictures.frame().regions().empty());
  auto moved = std::make_shared<scene::Snapshot>(*scene);
  ++moved->frame;
  moved->eyeFromWorld[3].x += 0.1;
  pictures.pictureOf(*moved, {});
  EXPECT_TRUE(pictures.frame().regions().empty());
  EXPECT_FALSE(readInto(first).any);
}

TEST_F(FramePicturesTest, FinishedOnesAreNotRemembered) {
  scene->lightSampling.mode = scene::LightSampling::Mode::full;
  write();
  EXPECT_TRUE(pictures.frame().regions().empty());
  EXPECT_EQ(first.colors, truth);
}

}  // namespace
}  // namespace gluray::frame
