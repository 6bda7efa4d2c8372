// Mean of many passes of one snapshot with different light samples, and an estimate of its noise. Used by one
// thread at a time.
#pragma once
#include "base/image.h"
#include "frame/refinement/auxiliary_features.h"
#include "render/resolve/averaged_byte.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace gluray::frame {

/// Running means of all passes, and of the first 1, 2, 4, 8 ... of them: the samples of such a first part are
/// well distributed, and so are those of the rest once it is as large, so that the difference of both means
/// estimates the noise of the mean. The variance of single passes, or of even and odd passes, would be too
/// large, because their samples are complementary. A value that is equal in all passes is kept to the bit.
/// Values that are not finite are ignored. Equal passes give equal bits for any number of threads.
class Refinement {
 public:
  using Tiles = std::vector<uint8_t>;  // a byte each, row by row, as scene::LightSampling::tiles

  /// Adds a pass with wide colours or bytes. All passes must have the same shape. Throws std::bad_alloc.
  void add(const Image& pass);
  uint32_t passes() const { return passes_; }
  /// Standard error of the mean that add() computed last: root mean square over the red, green and blue of
  /// all pixels that a ray hit, displayed values from 0 to 1. Infinite before the second pass.
  double noise() const { return noise_; }
  /// A displayed value, 0 .. 1, as the kernels round it in these passes.
  uint32_t byteOf(float v) const { return render::displayedByte(v, byteSamples_); }
  /// Writes the means into `out`: colours rounded by byteOf(), with misses in out.missColor;
  /// floats if `wide`. All else is copied from `pass`.
  void show(const Image& pass, bool wide, Image& out) const;

  /// Excludes tiles from later passes whose noise, and that of all neighbours, is at most `least`. Excluded
  /// tiles stay excluded and keep their noise. Does nothing until there are enough passes for a good
  /// estimate.
  void leaveOut(double least);
  /// Tiles of the next pass; null: all.
  std::shared_ptr<const Tiles> tiles() const { return tiles_; }
  /// Adds the time that a pass has taken.
  void addTime(double seconds) { seconds_ += seconds; }
  /// Time of all passes.
  double seconds() const { return seconds_; }
  /// Total number of tiles traced in all passes.
  uint64_t tracedTiles() const { return tracedTiles_; }

  /// From the first pass on, add() keeps the noise of each pixel.
  void keepNoise() { keepsNoise_ = passes_ == 0 || keepsNoise_; }
  /// The values whose noise is measured.
  enum class Judged : uint8_t {
    colors,
    alpha,    // where it is a fraction of light (scene::Snapshot::catches)
    onWhite,  // colours over a white background, where the alpha of some pixels is a fraction of light
  };
  /// Call before add().
  void judge(Judged values) { judged_ = values; }
  /// Call before add(): whether pixels of passes are averages of bytes (scene::Snapshot::byteSamples), which
  /// show() then rounds as the kernels round those.
  void setByteSamples(bool areBytes) { byteSamples_ = areBytes; }
  /// Estimated standard error of each pixel, render::kNoiseOne being 1, of values up to render::kBrightest;
  /// empty before the second pass, and where it is not kept.
  const std::vector<uint16_t>& pixelNoise() const { return pixelNoise_; }
  const std::vector<float>& mean() const { return mean_; }
  AuxiliaryFeatures features;  // for denoising

  size_t bytes() const {
    return 4 * (mean_.capacity() + half_.capacity()) + 2 * pixelNoise_.capacity() + features.bytes();
  }
  /// Memory for refining so many pixels, including an image with wide colours. `featureBytes`: of a pixel's
  /// auxiliary features, where the image is filtered: then with the noise of each pixel; 0: it is not.
  static size_t bytesFor(size_t pixels, size_t featureBytes = 0) {
    return pixels * (4 * (4 + 3 + 4 + 1) + (featureBytes ? sizeof(uint16_t) + featureBytes : 0));
  }

 private:
  struct Tile {
    double squares = 0;  // estimated variance: sum over values of all pixels hit
    uint64_t pixels = 0;
    double noise() const;
  };
  void addTile(const Image& pass, size_t tile);
  void addPixel(const Image& pass, size_t pixel, Tile& tile);
  uint32_t rounded(const float* color) const;
  bool isQuiet(int x, int y, double least) const;

  std::vector<float> mean_;  // four a pixel
  std::vector<float>
      half_;  // three per pixel: mean over the first halfPasses_ of the values whose noise is estimated
  std::vector<uint16_t> pixelNoise_;
  std::vector<Tile> sums_;
  int columns_ = 0, rows_ = 0;  // of tiles
  std::shared_ptr<const Tiles> tiles_;
  uint64_t tracedTiles_ = 0;
  uint32_t passes_ = 0, halfPasses_ = 0;
  double seconds_ = 0;
  bool keepsNoise_ = false, byteSamples_ = false;
  Judged judged_ = Judged::colors;
  double noise_ = std::numeric_limits<double>::infinity();
};

}  // namespace gluray::frame
