// Averages auxiliary features over the samples of a pixel, and over the layers of a sample. Part of
// kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_FEATURE_AVERAGES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_FEATURE_AVERAGES_INL_H_
#undef GLURAY_RENDER_FEATURE_AVERAGES_INL_H_
#else
#define GLURAY_RENDER_FEATURE_AVERAGES_INL_H_
#endif

#include "render/effects/feature_integrators.h"
#include "render/packets/work.inl.h"
#include "render/resolve/mixed_features.h"
#include "render/tiles/tile.h"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Accumulates the features of a tile's pixels (render/resolve/mixed_features.h). A shadow catcher counts
/// only where no sample of the pixel hits anything else, unless it shows a background.
class FeatureAverages {
 public:
  HWY_ATTR void add(const FrameData& frame, const Tile& tile, const Work& work) {
    if (frame.lens && work.sample == 0) return;
    const scene::Camera& camera = frame.snapshot->camera;
    const bool geometry = isGeometry(frame);
    const float weight =
        frame.sampleWeights.empty() ? 1.0f : frame.sampleWeights[static_cast<size_t>(work.sample)];
    for (int i = 0; i < kLanes; ++i) {
      const int x = work.imageX + laneX(i), y = work.imageY + laneY(i);
      if (x >= tile.x1 || y >= tile.y1 || work.depth[i] == Image::kMiss) continue;
      Pixel& pixel = at(x - tile.x0, y - tile.y0);
      const bool caught = isCaught(work.depth[i]);
      const bool shown = caught && frame.backdrop && frame.backdrop->covers(x, y);
      pixel.nearest =
          firstDepth(camera, pixel.nearest, caught ? depthOfCaught(work.depth[i]) : work.depth[i]);
      Features& sums = caught && !shown ? pixel.caught : pixel.surfaces;
      if (geometry)
        addPlane(frame, work, i, weight, sums);
      else if (caught)
        sums.add(shown ? glm::vec4(frame.backdrop->at(work.x[i], work.y[i]), 1) : glm::vec4(1), weight, 1);
      else
        addReflectance(frame, work, i, weight, sums);
    }
  }

  HWY_ATTR void store(const FrameData& frame, const Tile& tile) {
    Image& image = *frame.image;
    const bool geometry = isGeometry(frame);
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        const Pixel& pixel = at(x - tile.x0, y - tile.y0);
        const size_t i = static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(x);
        const bool onCatcher = !(pixel.surfaces.cover > 0);
        const Features& features = onCatcher ? pixel.caught : pixel.surfaces;
        image.depth[i] = pixel.nearest;
        float spread = 0;
        glm::vec4 out(0);
        if (features.cover > 0 && geometry)
          out = features.plane(frame.lens != nullptr, spread);
        else if (features.cover > 0)
          out = glm::vec4(glm::vec3(features.sum), onCatcher ? -features.cover : features.cover) *
                frame.averageFactor;
        for (size_t c = 0; c < 4; ++c) image.wideColor[4 * i + c] = out[static_cast<int>(c)];
        if (image.has(Plane::centerDepth)) image.centerDepth[i] = spread;
        if (image.has(Plane::transmittance)) image.transmittance[i] = 1;
      }
    }
  }

 private:
  struct Features {
    glm::vec4 sum{0};
    float cover = 0;               // sum of weights times opacities
    glm::vec4 first{0};            // plane of the first sample that hit
    glm::vec2 firstAt{0};          // its position in the pixel
    float squares = 0, count = 0;  // of distances from the first plane
    bool mixed = false;
    void add(const glm::vec4& v, float weight, float opacity) {
      sum += weight * opacity * v, cover += weight * opacity;
    }
    /// The mean plane; c > 0: the samples show several surfaces. `spread`: standard error of the distance
    /// from the plane that random samples of a lens leave, in widths of a pixel.
    glm::vec4 plane(bool lens, float& spread) const {
      glm::vec4 mean = sum / cover;
      mean.z = std::min(mean.z, 0.0f);
      if (!(mean.w > 0)) return glm::vec4(0);
      if (lens)
        spread = std::sqrt(squares / count) / std::sqrt(count);
      else if (mixed)
        mean.z = markMixed(mean.z);
      return mean;
    }
  };
  struct Pixel {
    Features surfaces, caught;
    float nearest = Image::kMiss;
  };
  static bool isGeometry(const FrameData& frame) {
    return frame.snapshot->lightSampling.mode == scene::LightSampling::Mode::geometry;
  }
  /// Colours of layers are premultiplied already.
  static void addReflectance(const FrameData& frame, const Work& work, int i, float weight, Features& sums) {
    const glm::vec3 color(work.wide[0][i], work.wide[1][i], work.wide[2][i]);
    const float cover = frame.snapshot->layers ? work.wide[3][i] : 1;
    sums.sum += weight * glm::vec4(color, 0), sums.cover += weight * cover;
  }
  static void addPlane(const FrameData& frame, const Work& work, int i, float weight, Features& sums) {
    glm::vec4 g(work.wide[0][i], work.wide[1][i], work.wide[2][i], work.wide[3][i]);
    float opacity = 1;
    if (frame.snapshot->layers) {
      opacity = g.w;
      if (!(opacity > 0)) return;
      const glm::vec3 mean = glm::vec3(g) / opacity;
      const scene::Region& region = frame.snapshot->region;
      const float x = work.x[i] - static_cast<float>(region.x) - 0.5f,
                  y = work.y[i] - static_cast<float>(region.y) - 0.5f;
      const auto* const planes = static_cast<const GeometryFeatures*>(frame.integrator);
      g = {mean.x, mean.y, planes->facing(mean.x, mean.y, x, y), mean.z};
    }
    if (!(g.w > 0) || !std::isfinite(g.x + g.y + g.z + g.w)) return;
    const glm::vec2 position(frame.samplePositions[static_cast<size_t>(work.sample)]);
    if (sums.count == 0) sums.first = g, sums.firstAt = position;
    const glm::vec2 shift = position - sums.firstAt;
    const float off = distanceFromPlane(sums.first, g, shift);
    sums.mixed = sums.mixed || !isOneSurface(sums.first, g, off);
    sums.squares += off * off, ++sums.count;
    sums.add(g, weight, opacity);
  }
  Pixel& at(int x, int y) { return pixels_[static_cast<size_t>(y * kTileSize + x)]; }
  std::vector<Pixel> pixels_ = std::vector<Pixel>(size_t{kTileSize} * kTileSize);
};

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
