// What samples of a picture's pixels show of opaque surfaces: the data of layers. One thread.
#pragma once
#include "frame/tracing/renderer.h"
#include "saved/shot/shot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::saved {

/// One sample of each pixel of a region, bottom row first. Only what was asked for has values.
struct SurfaceSamples {
  static constexpr uint32_t kNone = 0xffffffffu;
  std::vector<float> windowDepth;           // Image::kMiss: no surface
  std::vector<uint32_t> surface;            // index into SurfaceNames; kNone
  std::vector<float> depth;                 // from the viewpoint along the line of sight, world space
  std::vector<glm::vec3> position, normal;  // world space; normals of unit length, on the viewer's side
  std::vector<glm::vec3> albedo;            // displayed values
};

/// Where the samples of pixels lie, from their lower left corners, and their weights: those of the picture's
/// colours, without a lens. The nearest to the centre is the first.
struct PixelSamples {
  std::vector<glm::dvec2> positions;
  std::vector<float> weights;
};
PixelSamples pixelSamples(const std::vector<Shot::Placed>& batches);

class SampleTracer {
 public:
  struct Wanted {
    bool points = false, normals = false, albedo = false;  // points: depth and position
  };
  /// Both must outlive it.
  SampleTracer(const Shot& shot, frame::Renderer& renderer, Wanted wanted);
  ~SampleTracer();
  /// Traces the sample at a place of each pixel. Throws std::runtime_error with one line.
  void trace(const scene::Region& region, const glm::dvec2& place, SurfaceSamples& out);

 private:
  struct Batch;
  void trace(Batch& batch, const scene::Region& region, const glm::dvec2& place, SurfaceSamples& out);
  void render(Batch& batch, scene::LightSampling::Mode mode);

  frame::Renderer& renderer_;
  Wanted wanted_;
  std::vector<Batch> batches_;
  Image image_;
};

}  // namespace gluray::saved
