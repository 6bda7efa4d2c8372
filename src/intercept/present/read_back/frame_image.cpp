#include "intercept/present/read_back/frame_image.h"

#include "base/files.h"
#include "gl/real/buffer_bits.h"
#include "gl/real/state_queries.h"
#include "intercept/present/state/state_guard.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace gluray::present {
namespace {

struct Box {
  int x = 0, y = 0, width = 0, height = 0;
  size_t pixels() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
};

/// Reads one plane of `box` into `target`.
template <class T>
void readPixels(const gl::RealGl& real, const Box& box, GLenum format, GLenum type, std::vector<T>& target) {
  target.resize(box.pixels());
  real.ReadPixels(box.x, box.y, box.width, box.height, format, type, target.data());
}

/// Whether a sample of the image's pixel `i` has `depth`, within the depth buffer's precision.
bool isAt(const Image& image, size_t i, float depth, float step) {
  const size_t plane = static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
  for (size_t s = 0; s < static_cast<size_t>(image.samples); ++s) {
    const float traced = image.depth[s * plane + i];
    if (traced != Image::kMiss && std::abs(traced - depth) <= step) return true;
  }
  return false;
}

}  // namespace

const Features& FrameImage::features(const gl::RealGl& real) {
  if (!features_) features_ = readFeatures(real);
  return *features_;
}

void FrameImage::resize(int width, int height) {
  if (width <= width_ && height <= height_) return;
  const int newWidth = std::max(width, width_), newHeight = std::max(height, height_);
  std::vector<uint32_t> color(static_cast<size_t>(newWidth) * static_cast<size_t>(newHeight));
  std::vector<uint8_t> traced(color.size());
  for (int y = 0; y < height_; ++y) {
    const auto from = static_cast<ptrdiff_t>(y) * width_, to = static_cast<ptrdiff_t>(y) * newWidth;
    std::copy_n(color_.begin() + from, width_, color.begin() + to);
    std::copy_n(traced_.begin() + from, width_, traced.begin() + to);
  }
  color_ = std::move(color), traced_ = std::move(traced);
  width_ = newWidth, height_ = newHeight;
}

void FrameImage::written(const gl::RealGl& real, const Image& image) {
  const Features& known = features(real);
  const GLint framebuffer = known.readFramebuffers ? gl::integer(real, GL_DRAW_FRAMEBUFFER_BINDING) : 0;
  if (framebuffer != 0) {
    const size_t plane = static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
    elsewhere_ += static_cast<uint64_t>(std::count_if(image.depth.begin(),
                                                      image.depth.begin() + static_cast<ptrdiff_t>(plane),
                                                      [](float depth) { return depth != Image::kMiss; }));
    return;
  }
  const Box box{image.x, image.y, image.width, image.height};
  if (box.pixels() == 0 || box.x < 0 || box.y < 0) return;
  std::vector<uint32_t> color;
  std::vector<float> depth;
  {
    StateGuard guard(real, known);
    guard.plainPack();
    guard.readFrom(0, static_cast<GLenum>(gl::integer(real, GL_DRAW_BUFFER)));
    readPixels(real, box, GL_RGBA, GL_UNSIGNED_BYTE, color);
    readPixels(real, box, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
  }
  const int depthBits = std::clamp(gl::depthBits(real, known.compatibility), 1, 24);
  const float step = std::ldexp(2.0f, -depthBits);
  resize(box.x + box.width, box.y + box.height);
  for (int y = 0; y < box.height; ++y)
    for (int x = 0; x < box.width; ++x) {
      const size_t i = static_cast<size_t>(y) * static_cast<size_t>(box.width) + static_cast<size_t>(x);
      if (!isAt(image, i, depth[i], step)) continue;
      const size_t at =
          static_cast<size_t>(y + box.y) * static_cast<size_t>(width_) + static_cast<size_t>(x + box.x);
      color_[at] = color[i];
      traced_[at] = 1;
    }
}

RecordedImage FrameImage::readFrame(const gl::RealGl& real, GLenum buffer, int width, int height,
                                    uint64_t frame) {
  RecordedImage recorded;
  recorded.frame = frame, recorded.width = width, recorded.height = height;
  {
    StateGuard guard(real, features(real));
    guard.plainPack();
    guard.readFrom(0, buffer);
    readPixels(real, {0, 0, width, height}, GL_RGBA, GL_UNSIGNED_BYTE, recorded.color);
  }
  resize(width, height);
  recorded.origin.assign(recorded.color.size(), PixelOrigin::rasterised);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const size_t i = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x),
                   at = static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
      if (traced_[at])
        recorded.origin[i] = color_[at] == recorded.color[i] ? PixelOrigin::traced : PixelOrigin::drawnOver;
    }
  recorded.elsewhere = elsewhere_;
  elsewhere_ = 0;
  std::fill(traced_.begin(), traced_.end(), uint8_t{0});
  return recorded;
}

namespace {

/// Writes a file of the Netpbm family.
bool writeRows(const std::string& path, const char* magic, const RecordedImage& recorded, int channels,
               const auto& valueOf) {
  std::string rows;
  rows.reserve(recorded.color.size() * static_cast<size_t>(channels));
  for (int y = recorded.height - 1; y >= 0; --y)
    for (int x = 0; x < recorded.width; ++x)
      for (int c = 0; c < channels; ++c)
        rows.push_back(static_cast<char>(valueOf(
            static_cast<size_t>(y) * static_cast<size_t>(recorded.width) + static_cast<size_t>(x), c)));
  const std::string size = std::to_string(recorded.width) + " " + std::to_string(recorded.height);
  return files::replace(path, magic + ("\n" + size) + "\n255\n" + rows).empty();
}

}  // namespace

bool writeImage(const RecordedImage& recorded, const std::string& base) {
  return writeRows(base + ".ppm", "P6", recorded, 3,
                   [&](size_t i, int c) { return static_cast<uint8_t>(recorded.color[i] >> (8 * c)); }) &&
         writeRows(base + ".origin.pgm", "P5", recorded, 1,
                   [&](size_t i, int) { return static_cast<uint8_t>(recorded.origin[i]); });
}

}  // namespace gluray::present
