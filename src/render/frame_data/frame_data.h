// All data that the kernels need to trace one snapshot. Made on the calling thread, read by every tracing
// thread.
#pragma once
#include "accel/world.h"
#include "base/image.h"
#include "render/camera/depth_map.h"
#include "render/camera/ray_setup.h"
#include "render/film/tone.h"
#include "render/frame_data/backdrop_look.h"
#include "render/frame_data/known_depths.h"
#include "render/local/honest_look.h"
#include "render/local/surface.h"

#include <array>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

namespace gluray::render {

struct DirectLook;
class Lamps;
struct Lens;
class Integrator;
class RemoteSurfaces;
struct Relit;
struct HitFilm;
struct MovingFrame;

/// Whether the picture is blended over the framebuffer, because it holds a catcher or a background.
bool isComposed(const scene::Snapshot&);

struct FrameData {
  const accel::World* world = nullptr;
  const scene::Snapshot* snapshot = nullptr;
  RaySetup rays;
  RaySetup eyeRays;  // the same in eye space with equal t; unused if rays.startAtSphere
  DepthMap depth;
  std::shared_ptr<const Relit> relit;  // shadings in place of the snapshot's, if settings change lights
  // Each one per Snapshot's (or relit), and after those one per Surroundings', shadings and instances.
  // Surfaces that nothing can be seen of have no instance.
  std::vector<Lighting> lightings;
  std::vector<Surface> surfaces;
  std::vector<glm::dvec2> samplePositions;  // from the pixel's lower left corner, one per sample
  std::vector<float> sampleWeights;         // of averages; empty: all 1
  float averageFactor = 1;                  // of averages: 1 / the sum of weights
  bool perVertex = false;
  bool oncePerPixel = false;  // multisampled: surfaces are shaded at pixels' centres
  bool ownPlanes = false;     // some surface has its own clip planes
  bool averages = false;      // a pixel averages all samples (Image::centerDepth)
  // The instance that shows nothing but what falls on it, which only averages can show; kNoHit: none.
  uint32_t catcher = accel::kNoHit;
  // Null: rays leave the viewpoint. Otherwise sample 0 gives a pixel's depth alone, through the middle of the
  // lens, and the others its colour.
  std::unique_ptr<const Lens> lens;
  mutable std::atomic<bool> seenThrough{false};  // averages: some hit has an alpha other than 1
  // Layers: LayerCounts::open and ::before.
  mutable std::array<std::array<std::atomic<uint32_t>, LayerCounts::kMax>, 2> layerCounts{};
  float widestEdge = 0;     // largest width of painted edges, pixels; 0: there are none
  bool leastDepth = false;  // depths shift by triangles' slopes: the nearest hit may not have the least depth
  // leastDepth: largest eye-space distance by which a hit of lesser depth may lie behind another.
  double leastDepthReach = 0;
  glm::dvec4 clipZ{0}, clipW{0};  // leastDepth: rows of the matrix from world to clip space
  // Skips hits that are culled or clipped, where hits are compared before they are shaded (growing edges,
  // leastDepth). Otherwise null.
  std::unique_ptr<const accel::HitFilter> accepted;
  const Integrator* integrator = nullptr;  // null: the local look alone
  RemoteSurfaces* remote = nullptr;        // null: no other process holds surfaces of this view
  std::optional<ToneMap> tone;             // none: colours stay
  std::unique_ptr<const Lamps> lamps;      // null: the viewer sees no lights
  std::optional<KnownDepths> knownDepths;  // of catchers; none: their rays are whole
  const DirectLook* direct = nullptr;      // the surfaces without ambient light, if the integrator needs them
  // Null: pixels get their final colours at once. Otherwise traceTile() keeps the hits here, and the
  // collector their factors of light; then relightTile() colours them.
  HitFilm* hits = nullptr;
  const Integrator* collector = nullptr;
  const MovingFrame* moving = nullptr;   // null: light takes all samples that the settings ask for
  std::optional<HonestLook> honest;      // none: the local look is the program's
  std::optional<BackdropLook> backdrop;  // of averages: what misses show; none: the framebuffer's content
  Image* image = nullptr;

  /// Prepares tracing `snapshot`, whose instances `world` holds, into `image`, which already has the right
  /// shape. If that holds averages, takes settings.spp samples per pixel. All three must outlive this. Throws
  /// std::runtime_error if a matrix cannot be inverted.
  FrameData(const scene::Snapshot& snapshot, const accel::World& world, Image& image);
  ~FrameData();
  const std::vector<scene::Shading>& shadings() const;
  /// Of one of the snapshot's instances: an index of shadings() and lightings.
  uint32_t shadingOf(size_t instance) const;
  /// Whether anything changes the colours of the local look.
  bool changesColors() const { return integrator || tone; }

 private:
  void prepareAverages();
  void addSurroundings(const View&);
};

}  // namespace gluray::render
