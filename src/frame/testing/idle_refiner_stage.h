// A window in memory whose images are refined, for idle_refiner*_test.cpp.
#pragma once
#include "frame/idle/idle_refiner.h"
#include "frame/testing/lit_scene.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace gluray::frame {

/// A window in memory. The program may show something else in it at any time.
class FakeWindow final : public IdleWindow {
 public:
  bool read(WindowPixels& out) noexcept override {
    const std::lock_guard lock(mutex_);
    if (!gone_) out = pixels_;
    return !gone_;
  }
  bool replace(const WindowPixels& now, const WindowPixels& next) noexcept override {
    const std::lock_guard lock(mutex_);
    if (gone_ || now.colors != pixels_.colors) return false;
    pixels_ = next;
    ++painted_;
    return true;
  }
  void show(int width, int height, std::vector<uint32_t> colors) {
    const std::lock_guard lock(mutex_);
    pixels_ = {width, height, std::move(colors)};
  }
  std::vector<uint32_t> colors() {
    const std::lock_guard lock(mutex_);
    return pixels_.colors;
  }
  int painted() {
    const std::lock_guard lock(mutex_);
    return painted_;
  }
  void leave() {
    const std::lock_guard lock(mutex_);
    gone_ = true;
  }

 private:
  std::mutex mutex_;
  WindowPixels pixels_;
  int painted_ = 0;
  bool gone_ = false;
};

inline std::unique_ptr<IdleFrame> frameOf(std::vector<IdleImage> images, std::shared_ptr<IdleWindow> window,
                                          std::vector<IdleFxaa> passes = {}) {
  return std::make_unique<IdleFrame>(std::move(images), std::move(window), std::move(passes));
}

struct IdleRefinerTest : testing::Test {
  Renderer renderer;
  std::atomic<int> passes{0};
  Tracer tracer;
  std::shared_ptr<FakeWindow> window = std::make_shared<FakeWindow>();
  std::shared_ptr<scene::Snapshot> scene = std::make_shared<scene::Snapshot>(test::litScene());
  Image first;

  IdleRefinerTest() {
    tracer.behind = [this](const scene::Snapshot& s, Image& image, scene::TraceCost& cost, std::string& error,
                           const std::function<bool()>& stop) {
      ++passes;
      return renderer.renderBehind(s, image, cost, error, stop);
    };
    scene::TraceCost cost;
    std::string error;
    EXPECT_TRUE(renderer.render(*scene, first, cost, error));
    window->show(first.width, first.height, first.color);
  }
  std::vector<IdleImage> written() {
    std::vector<IdleImage> images;
    images.push_back({scene, 5, {first.x, first.y}, {first.width, first.height}, first.color});
    return images;
  }
  template <class Done>
  static bool waitFor(Done&& done) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(100);
    while (!done() && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return done();
  }
  static void waitForRest(IdleRefiner& refiner) {
    EXPECT_TRUE(waitFor([&] { return refiner.isResting(); }));
  }
  Image seen() {
    Image image = first;
    image.color = window->colors();
    return image;
  }
};

}  // namespace gluray::frame
