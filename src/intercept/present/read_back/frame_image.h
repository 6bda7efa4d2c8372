// Records a frame's image and which pixels were traced, for `gluray explain --html`. One per context, GL
// thread. Reads the framebuffer once per flush and once per frame, so it exists only if wanted.
#pragma once
#include "base/image.h"
#include "gl/real/real.h"
#include "intercept/present/state/features.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gluray::present {

/// Origin of a pixel of a finished frame.
enum class PixelOrigin : uint8_t {
  rasterised = 0,
  drawnOver = 128,  // traced, and changed afterwards
  traced = 255,
};

struct RecordedImage {
  uint64_t frame = 0;               // counts buffer swaps of the process, from 1
  int width = 0, height = 0;        // pixels
  std::vector<uint32_t> color;      // RGBA8, bottom row first
  std::vector<PixelOrigin> origin;  // the same shape
  uint64_t elsewhere = 0;           // pixels traced into framebuffer objects during the frame
};

class FrameImage {
 public:
  /// Call after writing a traced image into the draw framebuffer: records which pixels passed the depth
  /// test.
  void written(const gl::RealGl& real, const Image& image);
  /// Call when the frame is complete and about to be shown: reads it from the window's `buffer`.
  RecordedImage readFrame(const gl::RealGl& real, GLenum buffer, int width, int height, uint64_t frame);

 private:
  const Features& features(const gl::RealGl& real);
  void resize(int width, int height);

  std::optional<Features> features_;
  int width_ = 0, height_ = 0;
  std::vector<uint32_t> color_;  // after the flush that traced the pixel
  std::vector<uint8_t> traced_;
  uint64_t elsewhere_ = 0;
};

/// Writes `recorded` as two files: BASE.ppm, and BASE.origin.pgm with a PixelOrigin per pixel. False if they
/// cannot be written. These plain formats need no image library in the program.
bool writeImage(const RecordedImage& recorded, const std::string& base);

}  // namespace gluray::present
