// Shows complete images (CompletePresenter) where an MPI program draws the composed image of its ranks.
// Compares pixels before and after draws that could do so. A part of each Context, GL thread. Does nothing
// unless `gather` is on, and there is a ground, a background, or more than one sample per pixel.
#pragma once
#include "base/image.h"
#include "gl/basics/failsafe.h"
#include "gl/batch/batch.h"
#include "gl/framebuffers/cleared_framebuffers.h"
#include "gl/shadow/shadow_state.h"
#include "scene/snapshot.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::gl {

class Presenter;

class ComposedViews {
 public:
  struct Parts {
    ShadowState& shadow;
    const Failsafe& failsafe;
    ClearedFramebuffers& cleared;
  };
  ComposedViews(const Parts& parts, Presenter& presenter) : p_(parts), presenter_(presenter) {}

  /// Reports that a batch is about to be presented into the bound framebuffer.
  void presenting(const BatchKey& key, const scene::Snapshot& snapshot) noexcept;
  /// Reports the end of the presentation after presenting(). `traced`: the image is in the framebuffer.
  void presented(const BatchKey& key, const scene::SnapshotPtr& snapshot, bool traced) noexcept;
  /// Whether a complete image waits to be shown.
  bool waits() const { return !images_.empty(); }
  /// Reports that the real OpenGL draws surfaces next. Call only if waits().
  void drawing() noexcept;
  /// Call before anything else is drawn or read, and before another framebuffer is bound. Shows the complete
  /// image if the draw after drawing() has composed the ranks' images.
  void settle() noexcept {
    if (drawn_) finishDraw();
  }

 private:
  struct Complete {
    BatchKey key;
    scene::SnapshotPtr snapshot;
    std::shared_ptr<const Image> image;
  };
  template <class Body>
  void withMemory(const Body& body) noexcept;
  bool read(std::vector<uint32_t>& colors);
  bool follows(const BatchKey& key) const;
  void watch(const BatchKey& key, const scene::Snapshot& snapshot);
  bool isCandidate();
  void finishDraw() noexcept;
  void show();
  void drop() noexcept;

  Parts p_;
  Presenter& presenter_;
  std::vector<Complete> images_;  // complete images of one view, in drawing order
  scene::Region region_;          // region of that view
  std::vector<uint32_t> shown_;   // contents of the region after the last image was presented
  uint32_t empty_ = 0;            // value of each pixel before the first one
  bool watches_ = false;          // presenting() found a framebuffer that can be followed
  int draws_ = 0;                 // number of draws compared for images_
  bool drawn_ = false;            // a draw that could have composed the images has begun
  GLuint framebuffer_ = 0;        // framebuffer of that draw
  GLenum drawBuffer_ = 0;         // draw buffer of that draw
  std::vector<uint32_t> before_, colors_;
};

}  // namespace gluray::gl
