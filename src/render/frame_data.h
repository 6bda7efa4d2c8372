// All data that the kernels need to trace one snapshot. Made on the calling thread, read by every tracing
// thread.
#pragma once
#include "accel/world.h"
#include "base/image.h"
#include "render/local/surface.h"

#include <array>
#include <atomic>
#include <memory>
#include <vector>

namespace gluray::render {

struct DirectLook;
class Integrator;
struct HitFilm;
struct MovingFrame;

/// Maps NDC depth to window depth, including glDepthRange and glPolygonOffset.
struct DepthMap {
  double scale = 0.5, offset = 0.5;  // window = scale * ndc + offset
  double slopeFactor = 0,
         constant = 0;     // polygon offset: slopeFactor * steepest window-space slope + constant
  bool euclidean = false;  // the slope is the length of the gradient instead
  double floatUnits = 0;   // added too: this many units in the last place of a triangle's largest float depth
  /// The constant part of the polygon offset of a triangle whose NDC depths range from `ndc` to `further`.
  double constantOf(double ndc, double further) const;
};

struct FrameData {
  const accel::World* world = nullptr;
  const scene::Snapshot* snapshot = nullptr;
  RaySetup rays;
  RaySetup eyeRays;  // the same in eye space with equal t; unused if rays.startAtSphere
  DepthMap depth;
  std::vector<Lighting> lightings;          // one per Snapshot::shadings
  std::vector<Surface> surfaces;            // one per Snapshot::instances
  std::vector<glm::dvec2> samplePositions;  // within the pixel, one per sample
  bool perVertex = false;
  bool oncePerPixel = false;                     // multisampled: surfaces are shaded at pixels' centres
  bool ownPlanes = false;                        // some surface has its own clip planes
  bool averages = false;                         // a pixel averages all samples (Image::centerDepth)
  mutable std::atomic<bool> seenThrough{false};  // averages: some hit has an alpha other than 1
  // Layers: LayerCounts::open and ::before.
  mutable std::array<std::array<std::atomic<uint32_t>, LayerCounts::kMost>, 2> layerCounts{};
  float widestEdge = 0;     // largest width of painted edges, pixels; 0: there are none
  bool leastDepth = false;  // depths shift by triangles' slopes: the nearest hit may not have the least depth
  // leastDepth: largest eye-space distance by which a hit of lesser depth may lie behind another.
  double leastDepthReach = 0;
  glm::dvec4 clipZ{0}, clipW{0};  // leastDepth: rows of the matrix from world to clip space
  // Skips hits that are culled or clipped, where hits are compared before they are shaded (growing edges,
  // leastDepth). Otherwise null.
  std::unique_ptr<const accel::HitFilter> accepted;
  const Integrator* integrator = nullptr;  // null: the local look alone
  const DirectLook* direct = nullptr;      // the surfaces without ambient light, if the integrator needs them
  // Null: pixels get their final colours at once. Otherwise traceTile() keeps the hits here, and the
  // collector their factors of light; then relightTile() colours them.
  HitFilm* hits = nullptr;
  const Integrator* collector = nullptr;
  const MovingFrame* moving = nullptr;  // null: light takes all samples that the settings ask for
  Image* image = nullptr;

  /// Prepares tracing `snapshot`, whose instances `world` holds, into `image`, which already has the right
  /// shape. If that holds averages, takes settings.spp samples per pixel. All three must outlive this. Throws
  /// std::runtime_error if a matrix cannot be inverted.
  FrameData(const scene::Snapshot& snapshot, const accel::World& world, Image& image);
};

constexpr int kTileSize = 32;  // pixels, a multiple of 4

/// A rectangle of the image, at most kTileSize wide and high, in pixels from its lower left corner.
struct Tile {
  int x0, y0, x1, y1;  // exclusive ends
};

}  // namespace gluray::render
