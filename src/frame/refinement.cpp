#include "frame/refinement.h"

#include "parallel/arena.h"
#include "render/float_guard.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace gluray::frame {
namespace {

constexpr size_t kBlock = 4096;  // pixels that one thread takes at a time

/// As the kernels clamp: what is no number is 0.
float displayed(float v) { return v > 0 ? std::min(v, 1.0f) : 0.0f; }

uint32_t rounded(const float* color) {
  uint32_t bits = 0;
  for (unsigned c = 0; c < 4; ++c)
    bits |= static_cast<uint32_t>(std::nearbyint(displayed(color[c]) * 255)) << (8 * c);
  return bits;
}

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

/// Of displayed red, green and blue.
double squaredDifference(const float* a, const float* b) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    const double d = double{displayed(a[c])} - double{displayed(b[c])};
    sum += d * d;
  }
  return sum;
}

struct Sum {
  double squares = 0;
  uint64_t pixels = 0;
};

}  // namespace

void Refinement::add(const Image& pass) {
  const size_t pixels = pass.depth.size();
  std::vector<Sum> sums((pixels + kBlock - 1) / kBlock);
  if (passes_ == 0) mean_.assign(4 * pixels, 0), half_.assign(3 * pixels, 0);
  const uint32_t n = ++passes_;
  const bool doubled = std::has_single_bit(n);
  eachBlock(pixels, [&](size_t first, size_t end, size_t block) {
    for (size_t i = first; i < end; ++i) {
      float color[4];
      colorOf(pass, i, color);
      for (size_t c = 0; c < 4; ++c) addTo(mean_[4 * i + c], color[c], n);
      const double square = n > 1 ? squaredDifference(&mean_[4 * i], &half_[3 * i]) : 0;
      if (doubled) std::copy_n(&mean_[4 * i], 3, &half_[3 * i]);
      if (pass.depth[i] == Image::kMiss && !(square > 0)) continue;
      sums[block].squares += square;
      ++sums[block].pixels;
    }
  });
  const uint32_t halfPasses = std::exchange(halfPasses_, doubled ? n : halfPasses_);
  if (n < 2) return;
  Sum all;
  for (const Sum& sum : sums) all.squares += sum.squares, all.pixels += sum.pixels;
  // M, the mean of n passes, and H, that of the first h: (M - H)^2 is expected to be (variance of M) (n - h)
  // / h.
  const double h = halfPasses, values = 3 * static_cast<double>(std::max<uint64_t>(all.pixels, 1));
  noise_ = std::sqrt(all.squares / values * h / (n - h));
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
  const bool bytes = pass.has(Plane::color);  // then misses are in the pass's colours already
  eachBlock(out.depth.size(), [&](size_t first, size_t end, size_t) {
    for (size_t i = first; i < end; ++i)
      out.color[i] = bytes || out.depth[i] != Image::kMiss ? rounded(&mean_[4 * i]) : out.missColor;
  });
}

}  // namespace gluray::frame
