// The batch: draws that wait to be traced together, with one framebuffer, camera and depth state. BatchFiller
// fills it, Flusher empties it. GL thread.
#pragma once
#include "gl/batch/program_draw.h"
#include "gl/batch/snapshot_memory.h"
#include "gl/state/state.h"
#include "scene/effects.h"
#include "scene/snapshot.h"

#include <memory>
#include <memory_resource>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gluray::gl {

/// State that all draws of a batch share. A draw with another key starts the next batch.
struct BatchKey {
  GLuint framebuffer = 0;
  GLenum drawBuffer = 0, depthFunc = GL_LESS;
  bool depthsFromZero = false;  // scene::Camera::depthsFromZero
  int samples = 1;
  bool multisample = true;
  glm::dmat4 projection{1};
  glm::ivec4 viewport{0};
  scene::Region region;
  float depthNear = 0, depthFar = 1;
  scene::PolygonOffset offset;
  scene::ColorWrites colorWrites;
  bool encodes = false;  // GL_FRAMEBUFFER_SRGB
  // Kind of the batch's layers, if it has any. `visibility`: the surfaces are already in the framebuffer, and
  // the light that they take from each other is multiplied onto it (Snapshot::catches).
  enum class Layers : uint8_t { none, peeled, summed, drawn, visibility } layers = Layers::none;
  scene::Blending blending;  // for layers of kind `drawn`
  double depthSteps = 0;     // likewise: scene::Layers::depthSteps
  /// Likewise: what draws the layers. Draws of one kind can be repeated in their order if tracing fails.
  enum class DrawnBy : uint8_t { fixedFunction, builtIns, arrays } drawnBy = DrawnBy::fixedFunction;
  /// Whether the largest depth is visible.
  bool keepsLargest() const { return depthFunc == GL_GREATER || depthFunc == GL_GEQUAL; }
  bool operator==(const BatchKey&) const = default;
};

/// Whether one of the draws reads `buffer` as a buffer texture.
bool readsBuffer(const std::vector<ProgramDraw>& draws, GLuint buffer);
/// Whether one of the draws reads a texture other than a buffer texture.
bool readImages(const std::vector<ProgramDraw>& draws);

class Batch {
 public:
  bool empty() const { return !snapshot_; }
  const BatchKey& key() const { return key_; }
  /// The draws added so far. Must not be empty().
  const scene::Snapshot& waiting() const { return *snapshot_; }
  scene::SnapshotPtr pending() const { return snapshot_; }
  /// The draws added so far, for numbering their surfaces. Call before the batch is handed over.
  scene::Snapshot& unnumbered() { return *snapshot_; }

  /// The key of draws in this state. Its region is empty if such draws cannot change any pixel.
  static BatchKey keyOf(const PixelState& state, const glm::dmat4& projection);
  /// The polygon offset of draws in this state.
  static scene::PolygonOffset offsetOf(const PixelState& state);

  /// Begins a batch; must be empty(). `modelview`: matrix of its first surface, used with the projection of
  /// `key`.
  void start(const BatchKey& key, const TargetState& target, const glm::dmat4& modelview,
             const Settings& settings, uint64_t frame,
             scene::LightSampling::Mode mode = scene::LightSampling::Mode::full);
  /// Makes all surfaces of the batch layers. Call before the first one is added.
  void seeThrough(std::shared_ptr<const scene::Layers> layers) { snapshot_->layers = std::move(layers); }
  /// Makes all surfaces layers of kind `drawn` in `region`. Call after the last one was added.
  void seeThrough(std::shared_ptr<const scene::Layers> layers, const scene::Region& region) {
    snapshot_->layers = std::move(layers), snapshot_->region = region;
  }
  /// Sets the batch's secondary scene. Call before it is handed over.
  void setSecondaryScene(std::shared_ptr<const scene::SecondaryScene> secondaryScene) {
    snapshot_->secondaryScene = std::move(secondaryScene);
  }
  /// Sets Snapshot::extent, after the secondary scene.
  void setExtent(float extent) { snapshot_->extent = extent; }
  /// Records that colours are not dithered (GL_DITHER).
  void setUndithered() { undithered_ = true; }
  /// Whether the program uses the pixels as data rather than as an image: all surfaces have one colour each,
  /// without light, blending, dithering or antialiasing. Such pixels can be object numbers that a program
  /// reads to find what is under the pointer.
  bool holdsData() const;
  /// Traces the batch as if no setting changed images.
  void dropImageChanges() { snapshot_->settings = snapshot_->settings.withoutImageChanges(); }
  /// Leaves surfaces the program's own light.
  void dropLight() { scene::dropLight(snapshot_->settings); }
  void setUpwardAxis(LightsUp axis) { snapshot_->settings.lights.up = axis; }
  /// Sets the number of the view's frame to which the batch belongs, and the context's buffer swaps before
  /// it.
  void setViewFrame(uint64_t frame, uint64_t swaps) {
    snapshot_->viewFrame = frame, snapshot_->swaps = swaps;
  }
  void setLightMode(scene::LightSampling::Mode mode) { snapshot_->lightSampling.mode = mode; }
  /// Sets the ground and background that settings add. Call before the batch is handed over.
  void stand(scene::GroundUse ground, std::shared_ptr<const scene::Backdrop> backdrop) {
    snapshot_->ground = ground, snapshot_->backdrop = std::move(backdrop);
  }
  /// Begins a batch with the contents of a snapshot that was taken from a batch of the same key.
  void resume(const BatchKey& key, const scene::Snapshot& taken);
  /// Adds an instance whose eyeFromObject is set. Equal shadings are stored once. If an equal surface was
  /// added before, only the one that passes the depth function is kept.
  void add(scene::Instance instance, scene::Shading shading);
  /// Makes the batch that of a volume, in place of instances. Its world space is data space.
  void add(scene::PlacedVolume volume) { snapshot_->volumes.push_back(std::move(volume)); }
  /// Whether an instance with this matrix can be expressed in the batch's world space.
  bool takes(const glm::dmat4& eyeFromObject) const;
  /// Hands over the snapshot and leaves the batch empty.
  scene::SnapshotPtr takeSnapshot();
  /// Keeps the shader program's draw of an added instance, to replay it if tracing fails.
  void keep(ProgramDraw draw) { programDraws_.push_back(std::move(draw)); }
  const std::vector<ProgramDraw>& programDraws() const { return programDraws_; }
  /// readImages() and readsBuffer() of the kept draws.
  bool readsImages() const;
  bool readsBuffer(GLuint buffer) const { return gl::readsBuffer(programDraws_, buffer); }
  /// Hands the kept draws over.
  std::vector<ProgramDraw> takeProgramDraws() { return std::exchange(programDraws_, {}); }

 private:
  void startVisibility(const TargetState& target);

  std::shared_ptr<scene::Snapshot> snapshot_;
  glm::dmat4 worldFromEye_{1};  // for snapshot_
  BatchKey key_;
  std::vector<ProgramDraw> programDraws_;
  uint32_t drawn_ = 0;  // calls of add(), including replaced instances
  bool undithered_ = false;
  SnapshotMemory memory_;
  std::pmr::unsynchronized_pool_resource blocks_;  // reused: thousands of small allocations a frame
  std::pmr::unordered_multimap<Hash128, size_t> instancesAt_{&blocks_};  // from geometry and matrix
};

}  // namespace gluray::gl
