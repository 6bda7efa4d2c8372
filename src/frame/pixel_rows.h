// Rows of traced pixels, looked at and turned into what framebuffers and windows hold, several pixels at a
// time (compiled once for each instruction set). Depths are window depths, of misses Image::kMiss.
#pragma once
#include <cstddef>
#include <cstdint>

namespace gluray::frame {

/// Column of the first of `count` depths that is a hit, that is, at most 1; `count` where none is.
size_t firstHit(const float* depth, size_t count);
/// One past the column of the last hit; 0 where there is none.
size_t endOfHits(const float* depth, size_t count);

/// Depth as a buffer of 24 bits and stencil holds it, in the upper 24 bits, of misses that of the far plane:
/// rounded as llvmpipe does, whose product with 2^24 - 1 is a float.
void toDepth24(const float* depth, size_t count, uint32_t* to);
/// The same for buffers of floats: their bits.
void toDepthFloat(const float* depth, size_t count, uint32_t* to);

/// Red and blue of a pixel exchanged.
constexpr uint32_t bgra(uint32_t rgba) {
  return (rgba & 0xff00ff00u) | (rgba >> 16 & 0xffu) | (rgba & 0xffu) << 16;
}

/// What a window of BGRX pixels shows: RGBA8 colours where depths are at most `farthest`, else `background`.
void toWindow(const uint32_t* color, const float* depth, float farthest, uint32_t background, size_t count,
              uint32_t* to);

}  // namespace gluray::frame
