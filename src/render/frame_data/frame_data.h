// All data that the kernels need to trace one snapshot. Made on the calling thread, read by every tracing
// thread.
#pragma once
#include "accel/world.h"
#include "base/image.h"
#include "render/camera/depth_map.h"
#include "render/camera/ray_setup.h"
#include "render/frame_data/backdrop_look.h"
#include "render/frame_data/known_depths.h"
#include "render/local/honest_look.h"
#include "render/local/surface.h"
#include "render/media/medium_lattice.h"
#include "render/resolve/tone.h"
#include "render/tiles/drawn_part.h"

#include <array>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

namespace gluray::render {

struct DirectLook;
class GrownTriangles;
class Lamps;
struct Lens;
class Integrator;
class RemoteSurfaces;
struct Relit;
struct HitBuffer;
struct MovingFrame;

/// Whether the image is blended over the framebuffer, because it has a catcher or a background.
bool isComposed(const scene::Snapshot&);

struct FrameData {
  const accel::World* world = nullptr;
  const scene::Snapshot* snapshot = nullptr;
  RaySetup rays;
  RaySetup eyeRays;  // the same in eye space with equal t; unused if rays.startAtSphere
  DepthMap depth;
  std::shared_ptr<const Relit> relit;  // shadings in place of the snapshot's, if settings change lights
  // One entry for each shading and instance of the snapshot (or relit), followed by those of the
  // secondary scene. Surfaces that cannot be visible have no instance.
  std::vector<Lighting> lightings;
  std::vector<Surface> surfaces;
  std::vector<glm::dvec2> samplePositions;  // from the pixel's lower left corner, one per sample
  std::vector<float> sampleWeights;         // of averages; empty: all 1
  float averageFactor = 1;                  // of averages: 1 / the sum of weights
  bool perVertex = false;
  bool oncePerPixel = false;  // multisampled: surfaces are shaded at pixels' centres
  bool ownPlanes = false;     // some surface has its own clip planes
  bool averages = false;      // a pixel averages all samples (Image::centerDepth)
  bool bytes = false;         // the colours of samples are bytes
  bool limits = false;        // the colours of samples are limited to 0 .. 1 before they are averaged
  bool features = false;      // colours are auxiliary features for denoising
  // The instance that is a shadow catcher, which needs averages; kNoHit: none.
  uint32_t catcher = accel::kNoHit;
  // Null: rays start at the viewpoint. Otherwise sample 0, through the centre of the lens, gives only the
  // depth of the pixel, and the other samples give its colour.
  std::unique_ptr<const Lens> lens;
  mutable std::atomic<bool> seenThrough{false};  // averages: some hit has an alpha other than 1
  // Layers: LayerCounts::open and ::before.
  mutable std::array<std::array<std::atomic<uint32_t>, LayerCounts::kMax>, 2> layerCounts{};
  bool edgesGrow = false;                       // some surface's triangles grow by their edges
  std::unique_ptr<const GrownTriangles> grown;  // null: no triangle grows by its edges
  // Depths shift by triangles' slopes, or the depth buffer is coarse: the nearest hit may not be the visible
  // one.
  bool leastDepth = false;
  // leastDepth: largest eye-space distance by which a hit of lesser depth may lie behind another.
  double leastDepthReach = 0;
  glm::dvec4 clipZ{0}, clipW{0};  // leastDepth: rows of the matrix from world to clip space
  // Rejects culled and clipped hits if hits are compared before they are shaded (growing edges, leastDepth);
  // otherwise null.
  std::unique_ptr<const accel::HitFilter> accepted;
  const Integrator* integrator = nullptr;  // null: local look only
  RemoteSurfaces* remote = nullptr;        // null: no other process has surfaces of this view
  std::vector<PlacedLattice> media;        // volumes of the view, which block light
  std::optional<ToneMap> tone;             // of unlit surfaces and visible lights; none: colours stay
  std::optional<ToneMap> litTone;          // of surfaces with lighting
  std::unique_ptr<const Lamps> lamps;      // null: no visible lights
  std::optional<KnownDepths> knownDepths;  // of catchers; none: their rays are not shortened
  const DirectLook* direct = nullptr;      // the surfaces without ambient light, if the integrator needs them
  // Null: traceTile() writes final colours. Otherwise traceTile() stores the hits here, the collector stores
  // their visibility, and relightTile() colours them.
  HitBuffer* hits = nullptr;
  // Null: hits are lit when they are found. Otherwise traceEyeRays() stores the hits here, and lightSeen()
  // lights those that no other process hides (remote).
  HitBuffer* seen = nullptr;
  DrawnPart drawn;  // with `seen`: the tiles that may show surfaces
  const Integrator* collector = nullptr;
  // Of moving frames whose surfaces all catch light and lose nothing but occlusion: the opacity of a hit is
  // this times 1 - Visibility::occlusion, so that hits are not stored but their depths. None: shades hits.
  std::optional<float> caughtOcclusion;
  const MovingFrame* moving = nullptr;   // null: light uses all samples of the settings
  std::optional<HonestLook> honest;      // none: the local look is the program's
  std::optional<BackdropLook> backdrop;  // of averages: what misses show; none: the framebuffer's content
  Image* image = nullptr;

  /// Prepares tracing `snapshot`, whose instances `world` holds, into `image`, which already has the right
  /// shape. If that holds averages, takes settings.spp samples per pixel. All three must outlive this. Throws
  /// std::runtime_error if a matrix cannot be inverted.
  FrameData(const scene::Snapshot& snapshot, const accel::World& world, Image& image);
  ~FrameData();
  /// Brightens lit surfaces, and the environment behind them, by a factor of linear light.
  void exposeLit(float factor);
  /// Colours become auxiliary features, which no tone map changes.
  void dropTones() { tone.reset(), litTone.reset(); }
  const std::vector<scene::Shading>& shadings() const;
  /// How many of a pixel's `count` light samples each of its samples takes: a part of them, at least 1, where
  /// pixels are averages; otherwise all.
  int lightSamplesEach(int count) const;
  /// Index of the first light sample of pixel sample `sample` in this pass, if each has `count` of them.
  uint32_t firstLightSample(int sample, int count) const;
  /// Index into shadings() and lightings of one of the snapshot's instances.
  uint32_t shadingOf(size_t instance) const;
  /// Whether anything changes the colours of the local look.
  bool changesColors() const { return integrator || tone || litTone; }

 private:
  void prepareAverages();
  void addSecondaryScene(const View&);
};

}  // namespace gluray::render
