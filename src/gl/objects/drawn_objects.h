// The objects that a context draws: numbers its surfaces, and stores what it has drawn in ShownFrames. Does
// nothing until the first request, or until settings name objects; from then on surfaces keep their numbers.
// A part of each Context, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/objects/object_numbers.h"
#include "gl/objects/shown_frames.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::gl {

class DrawnObjects {
 public:
  DrawnObjects() = default;
  ~DrawnObjects();
  DrawnObjects(const DrawnObjects&) = delete;
  DrawnObjects& operator=(const DrawnObjects&) = delete;

  /// Call when a frame begins: checks whether drawn objects are requested. While they are, the ray tracer
  /// draws all frames. Returns whether that has changed.
  bool checkAsked() noexcept;
  bool asked() const { return asked_; }

  /// Numbers the surfaces of a batch that is about to be traced.
  void number(const BatchKey& key, scene::Snapshot& batch) noexcept;
  /// Reports that the batch was traced, or surely will be.
  void traced(const BatchKey& key, const scene::SnapshotPtr& snapshot) noexcept;
  /// Reports that the real OpenGL draws an image into the window that may fill these rectangles
  /// (shown_places.h).
  void placed(const std::vector<glm::ivec4>& places);
  /// Reports the end of a frame of a context that never swaps: another context has swapped.
  void endFrame() noexcept { ended_ = true, swaps_ = false; }
  /// Reports that the framebuffer's colours were cleared in `box`.
  void colorCleared(uint32_t framebuffer, const scene::Region& box) noexcept;
  /// Reports that the framebuffer's depth was cleared in `box`.
  void depthCleared(uint32_t framebuffer, const scene::Region& box) noexcept;
  /// Reports that a frame was shown, and that the window's contents are now undefined. `frame`: its number in
  /// SettingsSource.
  void shown(uint64_t frame) noexcept;
  /// What framebuffers show now, since frames were requested. Throws std::bad_alloc.
  ShownFramePtr now() const;
  /// Whether calls of colorCleared() and depthCleared() have no effect.
  bool empty() const { return !numbers_ && batches_.empty(); }

 private:
  static constexpr size_t kMaxBatches = 256, kMaxPlaces = 256;
  void publish(uint64_t frame) noexcept;
  void forget() noexcept;

  bool asked_ = false;
  bool swaps_ = false;  // frames are shown; until then, each batch counts as a frame
  std::unique_ptr<ObjectNumbers> numbers_;
  // The frame whose surfaces were numbered last: Snapshot::frame, and where its first batch was drawn.
  uint64_t frame_ = 0;
  uint32_t firstFramebuffer_ = 0;
  scene::Region firstRegion_;
  bool ended_ = false;                // the first batch's place was cleared, or endFrame() was called
  std::vector<ShownBatch> batches_;   // what framebuffers show now
  std::vector<ClearedDepth> clears_;  // since the last batch
  std::vector<glm::ivec4> places_;    // of the current frame
};

}  // namespace gluray::gl
