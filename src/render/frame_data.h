// Everything the kernels need to trace one snapshot. Made on the calling thread, read by every tracing
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

class Integrator;

/// NDC depth to window depth, glDepthRange and glPolygonOffset included.
struct DepthMap {
  double scale = 0.5, offset = 0.5;  // window = scale * ndc + offset
  double slopeFactor = 0,
         constant = 0;     // polygon offset: slopeFactor * steepest window-space slope + constant
  bool euclidean = false;  // the slope is the length of both directions' instead
  double floatUnits = 0;   // beside the constant, so many last digits of a triangle's largest depth, a float
  /// What polygon offset adds to all of a triangle, whose normalised depths reach from `ndc` to `further`.
  double constantOf(double ndc, double further) const;
};

struct FrameData {
  const accel::World* world = nullptr;
  const scene::Snapshot* snapshot = nullptr;
  RaySetup rays;
  RaySetup eyeRays;  // the same in eye space, t alike; where the former do not start at a sphere
  DepthMap depth;
  std::vector<Lighting> lightings;          // one for each of Snapshot::shadings
  std::vector<Surface> surfaces;            // one for each of Snapshot::instances
  std::vector<glm::dvec2> samplePositions;  // within the pixel, one a sample
  bool perVertex = false;
  bool oncePerPixel = false;                     // of several samples: surfaces are shaded at pixels' centres
  bool ownPlanes = false;                        // some surface has clip planes of its own
  bool averages = false;                         // a pixel is the average of all samples (Image::center)
  mutable std::atomic<bool> seenThrough{false};  // averages: some hit has an alpha that is not 1
  // Layers: LayerCounts::open and ::before.
  mutable std::array<std::array<std::atomic<uint32_t>, LayerCounts::kMost>, 2> layerCounts{};
  float widestEdge = 0;     // of painted edges, pixels; 0: there are none
  bool leastDepth = false;  // depths are moved by triangles' slopes: the nearest hit may not be what is seen
  // leastDepth: how far behind what is seen something may lie that comes before it, in eye space.
  double leastDepthReach = 0;
  glm::dvec4 clipZ{0}, clipW{0};  // leastDepth: rows of the matrix from world to clip space
  // Where hits are compared before they are shaded (edges that grow, leastDepth) and some may be culled or
  // cut by planes: passes by what is. Otherwise null.
  std::unique_ptr<const accel::HitFilter> accepted;
  const Integrator* integrator = nullptr;  // null: the local look alone
  Image* image = nullptr;

  /// Prepares `snapshot`, whose instances `world` holds, to be traced into `image`, already of the right
  /// shape: where that holds averages, settings.spp samples a pixel are taken. All three must outlive it.
  /// Throws std::runtime_error where a matrix cannot be inverted.
  FrameData(const scene::Snapshot& snapshot, const accel::World& world, Image& image);
};

constexpr int kTileSize = 32;  // pixels, a multiple of 4

/// A rectangle of the image, at most kTileSize wide and high, in pixels from its lower left corner.
struct Tile {
  int x0, y0, x1, y1;  // exclusive ends
};

}  // namespace gluray::render
