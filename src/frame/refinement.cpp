#include "frame/refinement.h"

#include "parallel/arena.h"
#include "render/float_guard.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

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

struct Sum {
  double squares = 0;
  uint64_t pixels = 0;
};

}  // namespace

void Refinement::add(const Image& pass) {
  const size_t pixels = pass.depth.size();
  std::vector<Sum> sums((pixels + kBlock - 1) / kBlock);
  if (passes_ == 0) mean_.assign(4 * pixels, 0), squares_.assign(pixels, 0);
  const float n = static_cast<float>(++passes_);
  eachBlock(pixels, [&](size_t first, size_t end, size_t block) {
    Sum sum;
    for (size_t i = first; i < end; ++i) {
      float color[4];
      colorOf(pass, i, color);
      float* const mean = &mean_[4 * i];
      for (int c = 0; c < 4; ++c) {
        if (passes_ > 1 && !std::isfinite(color[c])) continue;
        const float before = displayed(mean[c]), now = displayed(color[c]);
        mean[c] = passes_ == 1 ? color[c] : mean[c] + (color[c] - mean[c]) / n;
        if (passes_ > 1 && c < 3) squares_[i] += (now - before) * (now - displayed(mean[c]));
      }
      if (pass.depth[i] == Image::kMiss && !(squares_[i] > 0)) continue;
      sum.squares += double{squares_[i]};
      ++sum.pixels;
    }
    sums[block] = sum;
  });
  if (passes_ < 2) return;
  Sum all;
  for (const Sum& sum : sums) all.squares += sum.squares, all.pixels += sum.pixels;
  const double values = 3 * static_cast<double>(std::max<uint64_t>(all.pixels, 1));
  noise_ = std::sqrt(std::max(all.squares, 0.0) / values / (double{n} * (double{n} - 1)));
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
