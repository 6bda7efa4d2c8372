// Triangles that have grown by their painted edges (edged_triangle.h) over samples which they did
// not cover before, so that rays miss them. Found by rasterising the triangles' grown parts. Built by
// FrameData, read by every tracing thread.
#pragma once
#include "accel/rays/hit_filter.h"
#include "render/camera/depth_map.h"
#include "render/edges/seen_before.h"
#include "render/local/surface.h"
#include "render/tiles/tile.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace gluray::render {

/// Whether triangles of the surface grow.
bool growsByEdges(const Surface&);

/// What triangles grow in. All of it must outlive what refers to it.
struct GrowthStage {
  const scene::Snapshot& snapshot;
  const std::vector<Surface>& surfaces;
  const DepthMap& depth;
  const accel::HitFilter* accepted;  // of the surfaces' points; null: all
  int width, height;                 // of the image, in pixels
  const std::vector<glm::dvec2>& samplePositions;
};

/// The triangles that may grow, by the squares of kTileSize pixels of the image that they may touch.
class GrownTriangles {
 public:
  /// Throws std::bad_alloc.
  explicit GrownTriangles(const GrowthStage&);

  /// Finds for each pixel of `tile`, row by row, the triangle that OpenGL's depth test leaves among those
  /// that have grown over the sample; pixels without one have none.
  void findNearest(int sample, const Tile& tile, std::span<Nearest> pixels) const;

 private:
  struct Triangle {
    uint32_t instance, primitive;
  };
  template <class Visit>
  void eachSquare(Visit&& visit) const;

  void tryTriangle(const Triangle&, const Tile&, const glm::dvec2& shift, std::span<Nearest> pixels) const;

  GrowthStage stage_;
  int across_, down_;             // squares
  std::vector<uint32_t> begins_;  // of each square's triangles, and the end
  std::vector<Triangle> triangles_;
};

/// What has grown over the samples of a tile. One thread.
class GrownSamples {
 public:
  /// Keeps results of `samples` samples at a time. `triangles`: null if nothing grows; then it has no
  /// results.
  GrownSamples(const GrownTriangles* triangles, const Tile&, int samples);
  /// Computes those of a sample, which replace those of sample - `samples`.
  void find(int sample);
  /// The triangle at a pixel of the image.
  const Nearest& at(int sample, int x, int y) const {
    return pixels_[slot(sample) + static_cast<size_t>(y - tile_.y0) * width_ +
                   static_cast<size_t>(x - tile_.x0)];
  }

 private:
  size_t slot(int sample) const { return static_cast<size_t>(sample % samples_) * perSample_; }

  const GrownTriangles* triangles_;
  Tile tile_;
  int samples_;
  size_t width_, perSample_;
  std::vector<Nearest> pixels_;
};

}  // namespace gluray::render
