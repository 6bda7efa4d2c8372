// Images with depth: comparison against a tolerance, and PNG files of failures.
#pragma once
#include "scenes/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gluray::test {

struct DrawnImage {
  int width = 0, height = 0;
  std::vector<uint32_t> colors;  // RGBA8, red in the lowest byte, bottom row first
  std::vector<float> depths;     // window depth
  bool operator==(const DrawnImage&) const = default;
};

struct Comparison {
  size_t pixels = 0;
  size_t colorOutside = 0;  // pixels with a channel farther off than the tolerance
  size_t offEdge =
      0;  // of these: not even between the extremes of their 3x3 neighbourhood in the expected image
  int colorMax = 0;         // largest difference of a channel
  size_t depthOutside = 0;  // pixels hit in both images with depths farther apart than the tolerance
  float depthMax = 0;       // largest of these differences, over all pixels whose colours agree
  bool accepted = false;
  std::string text;  // the numbers in one line
};

/// Accepts if at most tolerance.edgeShare of the pixels are outside in colour, as many in depth, and a
/// tenth of that away from edges. Compares alpha like the other channels.
Comparison compare(const DrawnImage& expected, const DrawnImage& got, const scenes::Tolerance& tolerance);

/// An opaque RGB image, top row first in the file. False where the file cannot be written.
bool writePng(const std::string& file, const DrawnImage& image);

/// Writes NAME-expected.png, NAME-got.png, NAME-diff.png (differences times eight) to a new `folder`.
void writeFailure(const std::string& folder, const std::string& name, const DrawnImage& expected,
                  const DrawnImage& got);

}  // namespace gluray::test
