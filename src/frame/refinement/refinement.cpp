#include "frame/refinement/refinement.h"

#include "parallel/arena.h"
#include "render/resolve/wavelet.h"
#include "render/tiles/float_guard.h"
#include "scene/light_sampling.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace gluray::frame {
namespace {

constexpr size_t kBlock = 4096;  // pixels that one thread takes at a time

/// As the kernels clamp, to 0 .. most: what is no number is 0.
float clamped(float v, float most) { return v > 0 ? std::min(v, most) : 0.0f; }

/// Calls body(first, end, number) for all blocks of `pixels` pixels.
template <class Body>
void eachBlock(size_t pixels, Body&& body) {
  sharedArena()->execute([&] {
    tbb::parallel_for(size_t{0}, (pixels + kBlock - 1) / kBlock, [&](size_t block) {
      const render::FloatGuard guard;
      body(block * kBlock, std::min(pixels, (block + 1) * kBlock), block);
    });
  });
}

void colorOf(const Image& image, size_t pixel, float* color) {
  if (image.has(Plane::wideColor)) return void(std::copy_n(&image.wideColor[4 * pixel], 4, color));
  const uint32_t bits = image.color[pixel];
  for (unsigned c = 0; c < 4; ++c) color[c] = static_cast<float>(bits >> (8 * c) & 255) / 255;
}

/// Adds the n-th value to a running mean. A first value counts whatever it is, as without refinement.
void addTo(float& mean, float value, uint32_t n) {
  if (n == 1) mean = value;
  if (n > 1 && std::isfinite(value)) mean += (value - mean) / static_cast<float>(n);
}

/// Of red, green and blue, clamped to 0 .. most.
double squaredDifference(const float* a, const float* b, float most) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    const double d = double{clamped(a[c], most)} - double{clamped(b[c], most)};
    sum += d * d;
  }
  return sum;
}

}  // namespace

double Refinement::Tile::noise() const {
  return std::sqrt(squares / (3 * static_cast<double>(std::max<uint64_t>(pixels, 1))));
}

/// Adds a pixel of the pass to the means. Call after passes_ has counted the pass.
void Refinement::addPixel(const Image& pass, size_t i, Tile& tile) {
  const uint32_t n = passes_;
  float color[4];
  colorOf(pass, i, color);
  for (size_t c = 0; c < 4; ++c) addTo(mean_[4 * i + c], color[c], n);
  // M, the mean of n passes, and H, that of the first h: (M - H)^2 is expected to be (variance of M) (n - h)
  // / h.
  const double h = halfPasses_;
  float judged[3];
  const float alpha = mean_[4 * i + 3];
  for (size_t c = 0; c < 3; ++c)
    judged[c] =
        judged_ == Judged::alpha ? alpha : mean_[4 * i + c] + (judged_ == Judged::onWhite ? 1 - alpha : 0);
  const auto variance = [&](float most) {
    return squaredDifference(judged, &half_[3 * i], most) * h / (static_cast<double>(n) - h);
  };
  const double square = n > 1 ? variance(1) : 0;
  if (!pixelNoise_.empty()) {
    const double noise = std::sqrt(variance(render::kBrightest) / 3);
    pixelNoise_[i] = static_cast<uint16_t>(std::lround(std::min(noise, 1.0) * double{render::kNoiseOne}));
  }
  if (std::has_single_bit(n)) std::copy_n(judged, 3, &half_[3 * i]);
  if (pass.depth[i] == Image::kMiss && !(square > 0)) return;
  tile.squares += square;
  ++tile.pixels;
}

void Refinement::addTile(const Image& pass, size_t index) {
  const int side = scene::LightSampling::kTile, column = static_cast<int>(index) % columns_;
  const int x0 = column * side, y0 = static_cast<int>(index) / columns_ * side;
  Tile tile;
  for (int sample = 0; sample < pass.samples; ++sample)
    for (int y = y0; y < std::min(y0 + side, pass.height); ++y) {
      const size_t row =
          (static_cast<size_t>(sample) * static_cast<size_t>(pass.height) + static_cast<size_t>(y)) *
          static_cast<size_t>(pass.width);
      for (int x = x0; x < std::min(x0 + side, pass.width); ++x)
        addPixel(pass, row + static_cast<size_t>(x), tile);
    }
  sums_[index] = tile;
}

void Refinement::add(const Image& pass) {
  const size_t pixels = pass.depth.size();
  if (passes_ == 0) {
    constexpr int kTile = scene::LightSampling::kTile;
    columns_ = (pass.width + kTile - 1) / kTile, rows_ = (pass.height + kTile - 1) / kTile;
    sums_.assign(static_cast<size_t>(columns_) * static_cast<size_t>(rows_), {});
    mean_.assign(4 * pixels, 0), half_.assign(3 * pixels, 0);
  }
  if (passes_ == 1 && keepsNoise_) {
    try {
      pixelNoise_.assign(pixels, 0);
    } catch (const std::bad_alloc&) { keepsNoise_ = false; }  // it stays unknown
  }
  ++passes_;
  sharedArena()->execute([&] {
    tbb::parallel_for(size_t{0}, sums_.size(), [&](size_t tile) {
      const render::FloatGuard guard;
      if (!tiles_ || (*tiles_)[tile]) addTile(pass, tile);
    });
  });
  tracedTiles_ +=
      tiles_ ? static_cast<uint64_t>(std::count(tiles_->begin(), tiles_->end(), 1)) : sums_.size();
  if (std::has_single_bit(passes_)) halfPasses_ = passes_;
  if (passes_ < 2) return;
  Tile all;
  for (const Tile& tile : sums_) all.squares += tile.squares, all.pixels += tile.pixels;
  noise_ = all.noise();
}

/// Whether neither the tile nor a neighbour has more noise than `least`.
bool Refinement::isQuiet(int x, int y, double least) const {
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, rows_ - 1); ++row)
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, columns_ - 1); ++column)
      if (!(sums_[static_cast<size_t>(row * columns_ + column)].noise() <= least)) return false;
  return true;
}

void Refinement::leaveOut(double least) {
  // The rest of the passes must be about as many as the first half: their noise is known best then. Rare
  // looks also find few tiles quiet by chance.
  const bool tells = std::has_single_bit(passes_) || (passes_ % 3 == 0 && std::has_single_bit(passes_ / 3));
  if (passes_ < 4 || !tells) return;
  auto next = tiles_ ? std::make_shared<Tiles>(*tiles_) : std::make_shared<Tiles>(sums_.size(), uint8_t{1});
  for (int y = 0; y < rows_; ++y)
    for (int x = 0; x < columns_; ++x)
      if (isQuiet(x, y, least)) (*next)[static_cast<size_t>(y * columns_ + x)] = 0;
  tiles_ = std::move(next);
}

uint32_t Refinement::rounded(const float* color) const {
  uint32_t bits = 0;
  for (unsigned c = 0; c < 4; ++c) bits |= byteOf(color[c]) << (8 * c);
  return bits;
}

void Refinement::show(const Image& pass, bool wide, Image& out) const {
  const Planes colors = wide ? Plane::wideColor : Plane::color;
  Planes planes = colors | Plane::depth;
  for (const Plane plane : {Plane::transmittance, Plane::centerDepth})
    if (pass.has(plane)) planes = planes | plane;
  out.x = pass.x, out.y = pass.y;
  out.resize(pass.width, pass.height, pass.samples, planes);
  out.depth = pass.depth, out.transmittance = pass.transmittance, out.centerDepth = pass.centerDepth;
  out.layers = pass.layers;
  if (wide) {
    out.wideColor = mean_;
    return;
  }
  // Misses are in the pass's colours already.
  const bool bytes = pass.has(Plane::color) || pass.isAverages();
  eachBlock(out.depth.size(), [&](size_t first, size_t end, size_t) {
    for (size_t i = first; i < end; ++i)
      out.color[i] = bytes || out.depth[i] != Image::kMiss ? rounded(&mean_[4 * i]) : out.missColor;
  });
}

}  // namespace gluray::frame
