// The mean of many passes over one snapshot whose samples of light differ, and an estimate of its noise. Used
// by one thread at a time.
#pragma once
#include "base/image.h"
#include "frame/refinement/light_guides.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace gluray::frame {

/// Running means of all passes, and of the first 1, 2, 4, 8 ... of them: in these the samples are well
/// distributed, and in the rest, too, once there are as many, so that their difference tells the noise of the
/// mean. The variance of single passes, or of even and odd ones, would be too large, because their samples
/// complete each other. A value that is equal in all passes is kept to the bit. Values that are not finite do
/// not count. The same passes give the same bits, whatever the number of threads.
class Refinement {
 public:
  using Tiles = std::vector<uint8_t>;  // a byte each, row by row, as scene::LightSampling::tiles

  /// Adds a pass with wide colours or bytes. All passes must have the same shape. Throws std::bad_alloc.
  void add(const Image& pass);
  uint32_t passes() const { return passes_; }
  /// Standard error of the mean that add() computed last: root mean square over the red, green and blue of
  /// all pixels that a ray hit, displayed values from 0 to 1. Infinite before the second pass.
  double noise() const { return noise_; }
  /// Writes the means into `out`: colours rounded as the kernels round them, with misses in out.missColor;
  /// floats if `wide`. All else is copied from `pass`.
  void show(const Image& pass, bool wide, Image& out) const;

  /// Leaves out tiles from the next pass on: those with no more noise than `least` that have no noisier
  /// neighbour. Tiles that are left out once stay so: their passes are fewer, and their noise counts as it
  /// is. Only after as many passes as give a good estimate.
  void leaveOut(double least);
  /// The tiles that the next pass traces; null: all.
  std::shared_ptr<const Tiles> tiles() const { return tiles_; }
  /// Tiles that all passes have traced together.
  uint64_t tracedTiles() const { return tracedTiles_; }

  /// From the first pass on, add() keeps the noise of each pixel.
  void keepNoise() { keepsNoise_ = passes_ == 0 || keepsNoise_; }
  /// The pictures show shares of light as alphas (scene::Snapshot::catches): their noise is that of alpha.
  /// Call before add().
  void judgeAlpha() { judgesAlpha_ = true; }
  /// Estimated standard error of each pixel, render::kNoiseOne being 1; empty before the second pass, and
  /// where it is not kept.
  const std::vector<uint16_t>& pixelNoise() const { return pixelNoise_; }
  const std::vector<float>& mean() const { return mean_; }
  LightGuides guides;  // for filters

  size_t bytes() const {
    return 4 * (mean_.capacity() + half_.capacity()) + 2 * pixelNoise_.capacity() + guides.bytes();
  }
  /// Memory for the passes of so many pixels, an image with wide colours included; `filtered`: with guides
  /// and the noise of each pixel.
  static size_t bytesFor(size_t pixels, bool filtered = false) {
    return pixels * (4 * (4 + 3 + 4 + 1) + (filtered ? sizeof(uint16_t) + LightGuides::kBytes : 0));
  }

 private:
  struct Tile {
    double squares = 0;  // estimated variance: sum over values of all pixels hit
    uint64_t pixels = 0;
    double noise() const;
  };
  void addTile(const Image& pass, size_t tile);
  void addPixel(const Image& pass, size_t pixel, Tile& tile);
  bool isQuiet(int x, int y, double least) const;

  std::vector<float> mean_;  // four a pixel
  std::vector<float> half_;  // three a pixel: the mean of the first halfPasses_, of what noise is judged by
  std::vector<uint16_t> pixelNoise_;
  std::vector<Tile> sums_;
  int columns_ = 0, rows_ = 0;  // of tiles
  std::shared_ptr<const Tiles> tiles_;
  uint64_t tracedTiles_ = 0;
  uint32_t passes_ = 0, halfPasses_ = 0;
  bool keepsNoise_ = false, judgesAlpha_ = false;
  double noise_ = std::numeric_limits<double>::infinity();
};

}  // namespace gluray::frame
