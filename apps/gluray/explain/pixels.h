// Images: reading, encoding and comparing them.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gluray::launcher {

/// RGB8 (or one byte a pixel), top row first.
struct Pixels {
  int width = 0, height = 0, channels = 3;
  std::vector<uint8_t> bytes;
  size_t count() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
  const uint8_t* at(size_t pixel) const { return bytes.data() + pixel * static_cast<size_t>(channels); }
};

/// Reads a binary 8-bit PPM or PGM file; empty if it is no such file.
std::optional<Pixels> readNetpbm(const std::string& path);

/// The bytes of a PNG file. Throws std::runtime_error.
std::string pngOf(const Pixels& pixels);

/// Who drew a pixel of the frame with GLuRay. The origin image holds one a pixel.
enum class Origin : uint8_t { rasterised = 0, drawnOver = 128, traced = 255 };

struct Comparison {
  bool sameSize = false;
  uint64_t pixels = 0, traced = 0, drawnOver = 0;
  uint64_t differing = 0;  // by more than kTolerance in some channel
  uint64_t differingAtAll = 0;
  int largest = 0;                // of 255
  uint64_t outside = 0;           // pixels further than kMargin from any traced one: rasterised in both runs
  uint64_t outsideDiffering = 0;  // of those, by more than kTolerance
  static constexpr int kTolerance = 8, kMargin = 2;

  /// Whether the two images show the same frame: at most 0.1 % of the pixels outside differ.
  bool sameFrame() const { return sameSize && outsideDiffering * 1000 <= outside; }
};

/// Compares the images `with` and `without` GLuRay; `origin` holds an Origin for each pixel of `with`.
Comparison compare(const Pixels& with, const Pixels& without, const Pixels& origin);

/// The absolute difference of two images of equal size, times `times`.
Pixels difference(const Pixels& a, const Pixels& b, int times);

/// The image in grey, traced pixels green, those drawn over afterwards orange.
Pixels tinted(const Pixels& image, const Pixels& origin);

}  // namespace gluray::launcher
