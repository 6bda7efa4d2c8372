// Where the rays of a volume's pixels begin, and how they go on. Any thread.
#pragma once
#include "render/tiles/tile.h"
#include "scene/volumes/volume.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::render {

/// The part of a ray inside the volume, in texture space. Sample i lies at first + i * step.
struct VolumeRay {
  glm::vec3 first{0}, step{0};
  glm::vec3 towardsViewer{0};  // data space, length 1, at the ray's entry
  int samples = 0;             // 0: none
  float depth = 0;             // window depth of the entry
  float coverage = 1;          // share of the pixel's samples that show the volume
};

/// Finds the rays of a view: those through pixels whose centres the faces cover.
class VolumeRays {
 public:
  explicit VolumeRays(const scene::VolumeView& view);
  /// The ray of pixel (x, y) of the region.
  VolumeRay at(int x, int y) const { return at(x, y, everyFace_); }
  const scene::VolumeView& view() const { return view_; }

 private:
  friend class TileRays;
  using Faces = std::vector<uint32_t>;  // numbers of faces, in ascending order
  /// A triangle in the window: barycentric coordinates over w are linear in x and y.
  struct Face {
    glm::dvec3 edges[3];    // coefficients of x, y, 1
    glm::dvec3 borders[3];  // likewise, above 0 inside: of the corners as the real OpenGL rounds them
    glm::dvec3 corners[3];  // data space
    glm::dvec3 depths;      // window depth times w
    bool covers(const glm::dvec2& at) const;
    /// Whether it covers all of the pixel around a point.
    bool coversPixel(const glm::dvec2& centre) const;
    /// Whether it covers no point of a rectangle.
    bool misses(const glm::dvec2& lower, const glm::dvec2& upper) const;
  };
  static constexpr int kMostSamples = 1 << 24;  // beyond it floats cannot count
  struct Entry {
    const Face* face = nullptr;  // null: there is none
    double covered = 1;          // share of the pixel's samples
  };
  VolumeRay at(int x, int y, const Faces& faces) const;
  Entry entryOf(int x, int y, const Faces& faces) const;
  double startOf(int x, int y) const;
  /// A ray of data space; its ends are points of texture space.
  struct Line {
    glm::dvec3 origin, direction;  // length 1
    glm::dvec3 begin{0}, end{0};
  };
  bool clip(Line& line) const;
  int samplesOf(const VolumeRay& ray, const glm::dvec3& end) const;
  bool isInside(const glm::vec3& p) const;
  void castToSlice(const Line& line, float endDepth, VolumeRay& ray) const;
  /// A point of a face, in data space, and its window depth.
  struct FacePoint {
    glm::dvec3 data;
    double depth;
    bool visible() const { return depth >= 0 && depth <= 1; }
  };
  static FacePoint pointOf(const Face& face, const glm::dvec2& pixel);
  /// Of VolumeView::span: volume_spans.cpp.
  VolumeRay spanAt(int x, int y, const Faces& faces) const;
  VolumeRay spanTo(const FacePoint& end) const;

  const scene::VolumeView& view_;
  glm::dmat4 textureFromWindow_;
  glm::dmat4 textureFromClip_{1};
  glm::dmat3 textureDirection_;
  std::vector<Face> faces_;
  Faces everyFace_;
};

/// The rays of a tile's pixels: those of VolumeRays, found faster.
class TileRays {
 public:
  TileRays(const VolumeRays& rays, const Tile& tile);
  VolumeRay at(int x, int y) const { return rays_.at(x, y, faces_); }

 private:
  const VolumeRays& rays_;
  VolumeRays::Faces faces_;  // that the tile may show
};

}  // namespace gluray::render
