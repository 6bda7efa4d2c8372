// A film as an uncompressed stream for encoders: YUV4MPEG2 on standard output. One thread.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace gluray::launcher {

/// Frames a second: "25", "23.976" or "24000/1001".
struct FrameRate {
  int number = 25, divisor = 1;
};
/// Empty, or one line that says what is wrong.
std::string readFrameRate(const std::string& text, FrameRate& rate);

/// The beginning of the stream. Sizes are even.
std::string videoHead(int width, int height, const FrameRate& rate);

/// A frame: Y'CbCr of ITU-R BT.709 in 8 bits of limited range (16 to 235, 16 to 240), with the colour of each
/// block of 2x2 pixels in its middle. `pixels`: RGBA8, whose alpha is ignored, red in the lowest byte, top
/// row first. If a side is odd, its last column or row is there twice.
void addVideoFrame(const std::vector<uint32_t>& pixels, int width, int height, std::string& to);

class VideoStream {
 public:
  /// Throws std::runtime_error with one line if standard output is a terminal. Ignores SIGPIPE from now on.
  explicit VideoStream(const FrameRate& rate);

  /// A picture begins; all have one size.
  void begin(int width, int height);
  /// Premultiplied RGBA8 over black, top row first.
  void add(int count, const uint32_t* pixels);
  /// Writes the picture. Throws std::runtime_error with one line if nobody reads it.
  void end();

 private:
  void write(const std::string& bytes) const;

  FrameRate rate_;
  int width_ = 0, height_ = 0, frames_ = 0;
  std::vector<uint32_t> pixels_;
  std::string bytes_;
};

}  // namespace gluray::launcher
