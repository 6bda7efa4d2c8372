// A WriteBack over an OpenGL in memory, for tests with each kind of context.
#pragma once
#include "intercept/present/write_back/write_back.h"
#include "tests/present/images.h"
#include "tests/support/osmesa_context.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gluray::present::test {

using gluray::test::ContextWish;
using gluray::test::OsmesaContext;

inline constexpr int kSize = 64;

inline bool isHit(int x, int y) { return (x + y) % 2 == 0; }

/// An image whose pixels with x + y even (counted within the image) are hits of `color` at `depth`.
inline Image checkerboard(int x, int y, int width, int height, uint32_t color, float depth, int samples = 1) {
  Image image;
  image.x = x, image.y = y;
  image.resize(width, height, samples);
  for (int s = 0; s < samples; ++s)
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column) {
        const auto i = static_cast<size_t>((s * height + row) * width + column);
        image.color[i] = isHit(column, row) ? color : 0;
        image.depth[i] = isHit(column, row) ? depth : Image::kMiss;
      }
  return image;
}

/// Colour cleared to blue, depth test on.
class WriteBackStage : public testing::TestWithParam<ContextWish> {
 protected:
  void SetUp() override {
    context_ = OsmesaContext::create(GetParam());
    ASSERT_TRUE(context_);
    writeBack_.emplace(gl());
    gl().Enable(GL_DEPTH_TEST);
    clear(0, 0, 1, 1);
  }
  const gl::RealGl& gl() const { return context_->real(); }

  void clear(float r, float g, float b, double depth) const {
    gl().ClearColor(r, g, b, 1);
    gl().ClearDepth(depth);
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  /// Leaves the pixels of a rasterised nearer or farther rectangle, without a shader program.
  void clearRectangle(int x, int y, int width, int height, float r, float g, float b, double depth) const {
    gl().Enable(GL_SCISSOR_TEST);
    gl().Scissor(x, y, width, height);
    clear(r, g, b, depth);
    gl().Disable(GL_SCISSOR_TEST);
  }
  void write(const Image& image, GLenum func = GL_LEQUAL) {
    std::string why;
    ASSERT_TRUE(writeBack_->ready(why)) << why;
    ASSERT_TRUE(writeBack_->write(image, {func}, pending_));
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
  static uint32_t at(const std::vector<uint32_t>& pixels, int x, int y) {
    return pixels[static_cast<size_t>(y * kSize + x)];
  }
  static float at(const std::vector<float>& pixels, int x, int y) {
    return pixels[static_cast<size_t>(y * kSize + x)];
  }

  std::unique_ptr<OsmesaContext> context_;
  std::optional<WriteBack> writeBack_;
  PendingErrors pending_;
};

inline std::string nameOf(const testing::TestParamInfo<ContextWish>& info) {
  const ContextWish& w = info.param;
  return std::string(w.core ? "core" : "compat") + std::to_string(w.major) + std::to_string(w.minor);
}

inline auto compatibilityContexts() {
  return testing::Values(ContextWish{kSize, kSize, false, 0, 0}, ContextWish{kSize, kSize, false, 2, 1});
}
inline auto allContexts() {
  return testing::Values(ContextWish{kSize, kSize, false, 0, 0}, ContextWish{kSize, kSize, false, 2, 1},
                         ContextWish{kSize, kSize, true, 3, 2}, ContextWish{kSize, kSize, true, 4, 5});
}

}  // namespace gluray::present::test
