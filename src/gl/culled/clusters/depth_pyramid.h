// A hierarchy of the farthest depths of an image's pixels. GL thread; the loop runs in the shared arena.
#pragma once
#include <cstdint>
#include <vector>

namespace gluray::gl {

class DepthPyramid {
 public:
  /// `depths`: row by row from the bottom, 0 to 1; larger is farther. `depths` is not needed later.
  void build(const float* depths, int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }
  /// Upper bound of the depths of the pixels in [x0, x1] x [y0, y1], clamped to the image. Any thread.
  float farthest(int x0, int y0, int x1, int y1) const;

 private:
  struct Level {
    int width = 0, height = 0;
    std::vector<float> farthest;
  };
  int width_ = 0, height_ = 0;
  std::vector<Level>
      levels_;  // the first one has kFirst x kFirst pixels in a value, each next one twice that
};

}  // namespace gluray::gl
