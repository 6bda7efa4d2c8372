// SIMD conversions of rows of traced pixels to the formats of framebuffers and windows (compiled once per
// instruction set). Depths are window depths; misses have Image::kMiss. Any thread.
#pragma once
#include <cstddef>
#include <cstdint>

namespace gluray::frame {

/// Column of the first hit (depth at most 1) among `count` depths; `count` if there is none.
size_t firstHit(const float* depth, size_t count);
/// One past the column of the last hit; 0 if there is none.
size_t endOfHits(const float* depth, size_t count);

/// Depths for a buffer of 24-bit depth and stencil, in the upper 24 bits; misses get the far plane's. Rounds
/// as llvmpipe does, which computes the product with 2^24 - 1 in float.
void toDepth24(const float* depth, size_t count, uint32_t* to);
/// The same for float depth buffers: the bits of the floats.
void toDepthFloat(const float* depth, size_t count, uint32_t* to);

/// Swaps red and blue of a pixel.
constexpr uint32_t bgra(uint32_t rgba) {
  return (rgba & 0xff00ff00u) | (rgba >> 16 & 0xffu) | (rgba & 0xffu) << 16;
}

/// Pixels of a BGRX window: RGBA8 colours where depths are at most `farthest`, else `background`.
void toWindow(const uint32_t* color, const float* depth, float farthest, uint32_t background, size_t count,
              uint32_t* to);

}  // namespace gluray::frame
