// Draws that wait to be traced together: one framebuffer, one camera, one depth state. GL thread.
#pragma once
#include "gl/batch/snapshot_memory.h"
#include "gl/programs/program_draw.h"
#include "gl/state/state.h"
#include "scene/snapshot.h"

#include <memory>
#include <memory_resource>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gluray::gl {

/// What all draws of a batch have in common; a draw that differs starts the next batch.
struct BatchKey {
  GLuint framebuffer = 0;
  GLenum drawBuffer = 0, depthFunc = GL_LESS;
  int samples = 1;
  bool multisample = true;
  glm::dmat4 projection{1};
  glm::ivec4 viewport{0};
  scene::Region region;
  float depthNear = 0, depthFar = 1;
  scene::PolygonOffset offset;
  scene::ColorWrites colorWrites;
  bool encodes = false;                                                               // GL_FRAMEBUFFER_SRGB
  enum class Layers : uint8_t { none, peeled, summed, drawn } layers = Layers::none;  // that are seen through
  scene::Blending blending;  // of layers that are blended in the order of drawing
  double depthSteps = 0;     // the same: scene::Layers
  bool operator==(const BatchKey&) const = default;
};

/// Whether one of the draws reads a buffer as a texture; whether one reads textures, or a buffer as one.
bool readsBuffer(const std::vector<ProgramDraw>& draws, GLuint buffer);
bool readImages(const std::vector<ProgramDraw>& draws);

class Batch {
 public:
  bool empty() const { return !snapshot_; }
  const BatchKey& key() const { return key_; }
  /// What has been added. Only where not empty.
  const scene::Snapshot& waiting() const { return *snapshot_; }
  scene::SnapshotPtr pending() const { return snapshot_; }

  /// The common part of the state of now. Its region is empty where nothing could be drawn.
  static BatchKey keyOf(const State& state);

  /// Begins a batch. It must be empty.
  void start(const BatchKey& key, const State& state, const Settings& settings, uint64_t frame);
  /// All of the batch's surfaces are seen through. Before the first is added.
  void seeThrough(std::shared_ptr<const scene::Layers> layers) { snapshot_->layers = std::move(layers); }
  /// The same afterwards, of those that are blended in the order of drawing. They reach no farther than
  /// `region`.
  void seeThrough(std::shared_ptr<const scene::Layers> layers, const scene::Region& region) {
    snapshot_->layers = std::move(layers), snapshot_->region = region;
  }
  /// Begins a batch with all that is in a snapshot that was taken with the same key.
  void resume(const BatchKey& key, const scene::Snapshot& taken);
  /// Adds an instance whose eyeFromObject is set; shading is shared with earlier instances of the same
  /// shading. An equal surface drawn before is replaced, or keeps its place, as the depth function says.
  void add(scene::Instance instance, scene::Shading shading);
  /// Hands the batch over and is empty afterwards.
  scene::SnapshotPtr take();
  /// Keeps a draw by a shader program, whose instance was added, for the case that it cannot be traced.
  void keep(ProgramDraw draw) { programDraws_.push_back(std::move(draw)); }
  const std::vector<ProgramDraw>& programDraws() const { return programDraws_; }
  /// Whether one of those reads textures, or a buffer as a texture.
  bool readsImages() const;
  bool readsBuffer(GLuint buffer) const { return gl::readsBuffer(programDraws_, buffer); }
  /// Hands those over.
  std::vector<ProgramDraw> takeProgramDraws() { return std::exchange(programDraws_, {}); }

 private:
  std::shared_ptr<scene::Snapshot> snapshot_;
  glm::dmat4 worldFromEye_{1};  // of that
  BatchKey key_;
  std::vector<ProgramDraw> programDraws_;
  uint32_t drawn_ = 0;  // instances added, those that were replaced included
  SnapshotMemory memory_;
  std::pmr::unsynchronized_pool_resource blocks_;  // thousands of small ones a frame, again and again
  std::pmr::unordered_multimap<Hash128, size_t> instancesAt_{&blocks_};  // geometry and place -> instances
};

}  // namespace gluray::gl
