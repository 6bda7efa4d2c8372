// Averages several samples per pixel (setting spp). Part of kernels.cpp (compiled once for each instruction
// set).
#if defined(GLURAY_RENDER_AVERAGES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_AVERAGES_INL_H_
#undef GLURAY_RENDER_AVERAGES_INL_H_
#else
#define GLURAY_RENDER_AVERAGES_INL_H_
#endif

#include "render/layers/drawn_layers.inl.h"
#include "render/resolve/averaged_byte.h"
#include "render/tiles/tile.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Accumulates the samples of a tile's pixels.
class Averages {
 public:
  HWY_ATTR void add(const FrameData& frame, const Tile& tile, const Work& work) {
    const scene::Camera& camera = frame.snapshot->camera;
    const bool bytes = frame.bytes, limits = frame.limits;
    const bool depthAlone = frame.lens && work.sample == 0;
    const float weight =
        frame.sampleWeights.empty() ? 1.0f : frame.sampleWeights[static_cast<size_t>(work.sample)];
    bool seenThrough = false;
    for (int i = 0; i < kLanes; ++i) {
      const int x = work.imageX + laneX(i), y = work.imageY + laneY(i);
      if (x >= tile.x1 || y >= tile.y1) continue;
      Pixel& pixel = at(x - tile.x0, y - tile.y0);
      const bool hit = work.depth[i] != Image::kMiss, caught = isCaught(work.depth[i]);
      // A catcher lies where it is, but hides nothing.
      if (work.sample == 0) pixel.center = caught ? Image::kMiss : work.depth[i];
      pixel.nearest =
          firstDepth(camera, pixel.nearest, caught ? depthOfCaught(work.depth[i]) : work.depth[i]);
      float alpha = work.wide[3][i];
      if (bytes) alpha = static_cast<float>(work.color[i] >> 24) / 255;
      seenThrough |= hit && !caught && !(std::abs(alpha - 1) <= kRounding);
      if (depthAlone) continue;
      const bool covered = (!hit || caught) && frame.backdrop && frame.backdrop->covers(x, y);
      if (covered)
        addBackdrop(*frame.backdrop, work, i, weight * (hit ? 1 - alpha : 1), bytes ? 255 : 1, pixel);
      if (covered) pixel.nearest = firstDepth(camera, pixel.nearest, BackdropLook::depthOf(camera));
      pixel.through += weight * work.through[i];
      for (int c = 0; c < 4; ++c) {
        const float wide = limits ? limited(work.wide[c][i]) : work.wide[c][i];
        pixel.sum[c] += weight * (bytes ? static_cast<float>(work.color[i] >> (8 * c) & 255) : wide);
      }
    }
    if (seenThrough) frame.seenThrough.store(true, std::memory_order_relaxed);
  }

  HWY_ATTR void store(const FrameData& frame, const Tile& tile) {
    Image& image = *frame.image;
    const float share = frame.averageFactor;
    // Filters with negative weights overshoot.
    const bool signedWeights = !frame.sampleWeights.empty(), coverage = !image.has(Plane::transmittance);
    const float least = signedWeights ? 0 : std::numeric_limits<float>::lowest();
    const float white = frame.bytes ? 255 : 1;  // in sums
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        const Pixel& pixel = at(x - tile.x0, y - tile.y0);
        const size_t i = static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(x);
        image.centerDepth[i] = pixel.center;
        image.depth[i] = pixel.center != Image::kMiss ? pixel.center : pixel.nearest;
        if (image.has(Plane::transmittance)) image.transmittance[i] = std::max(pixel.through * share, least);
        uint32_t color = 0;
        for (size_t c = 0; c < 4; ++c) {
          float average = std::max(pixel.sum[c] * share, least);
          if (signedWeights && coverage && c == 3) average = std::min(average, white);
          if (image.has(Plane::color))
            color |= averagedByte(average) << (8 * c);
          else
            image.wideColor[4 * i + c] = average / white;
        }
        if (image.has(Plane::color)) image.color[i] = color;
      }
    }
  }

 private:
  static constexpr float kRounding = 0x1p-20f;  // of an interpolated alpha of 1
  struct Pixel {
    float sum[4] = {};
    float through = 0;
    float center = Image::kMiss, nearest = Image::kMiss;
  };
  /// What is no number is 0.
  static float limited(float v) { return v > 0 ? std::min(v, 1.0f) : 0.0f; }
  /// `scale`: what the value 1 is in sums.
  static void addBackdrop(const BackdropLook& backdrop, const Work& work, int i, float weight, float scale,
                          Pixel& pixel) {
    const glm::vec3 color = backdrop.at(work.x[i], work.y[i]);
    for (int c = 0; c < 3; ++c) {
      const float shown = scale == 1 ? color[c] : std::clamp(color[c], 0.0f, 1.0f);
      pixel.sum[c] += weight * scale * shown;
    }
    pixel.sum[3] += weight * scale;
  }
  Pixel& at(int x, int y) { return pixels_[y * kTileSize + x]; }
  Pixel pixels_[kTileSize * kTileSize];
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
