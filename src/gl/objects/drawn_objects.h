// The objects that a context draws: numbers its surfaces, and keeps what it has drawn for ShownFrames. Does
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

  /// Call when a frame begins: looks whether somebody asks for what is drawn. While it is so, the ray tracer
  /// draws all frames. Returns whether that has changed.
  bool checkAsked() noexcept;
  bool asked() const { return asked_; }

  /// Numbers the surfaces of a batch that is about to be traced.
  void number(const BatchKey& key, scene::Snapshot& batch) noexcept;
  /// The batch was traced, or surely will be.
  void traced(const BatchKey& key, const scene::SnapshotPtr& snapshot) noexcept;
  /// The real OpenGL draws an image into the window that may fill these rectangles (shown_places.h).
  void placed(const std::vector<glm::ivec4>& places);
  /// A frame of a context that never swaps is over: another context has swapped.
  void endFrame() noexcept { ended_ = true; }
  /// Colours of the framebuffer were cleared in `box`.
  void colorCleared(uint32_t framebuffer, const scene::Region& box) noexcept;
  /// A frame was shown; `frame`: as SettingsSource counts. The window's content is undefined.
  void shown(uint64_t frame) noexcept;
  /// Whether clears matter.
  bool empty() const { return !numbers_ && batches_.empty(); }

 private:
  static constexpr size_t kMaxBatches = 256, kMaxPlaces = 256;
  void publish(uint64_t frame) noexcept;
  void forget() noexcept;

  bool asked_ = false;
  bool swaps_ = false;  // frames are shown; otherwise each batch is a frame so far
  std::unique_ptr<ObjectNumbers> numbers_;
  // Of the frame whose surfaces were numbered last: Snapshot::frame, and where its first batch was drawn.
  uint64_t frame_ = 0;
  uint32_t firstFramebuffer_ = 0;
  scene::Region firstRegion_;
  bool ended_ = false;               // that was cleared, or endFrame() was called
  std::vector<ShownBatch> batches_;  // what framebuffers show now
  std::vector<glm::ivec4> places_;   // of this frame
};

}  // namespace gluray::gl
