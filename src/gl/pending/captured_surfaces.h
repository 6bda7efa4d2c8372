// Collects surfaces of the real OpenGL that mirrors and traced paths shall show (setting light.rasterised,
// docs/adr/0074), and captures their pixels. A part of the Flusher, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/batch/presenter.h"
#include "gl/clock/frame_clock.h"
#include "gl/history/surface_history.h"
#include "gl/real/errors.h"
#include "gl/shadow/shadow_state.h"
#include "scene/framebuffer_capture.h"

#include <memory>
#include <optional>

namespace gluray::gl {

class CapturedSurfaces {
 public:
  struct Parts {
    ShadowState& shadow;
    FrameClock& clock;
    SurfaceHistory& surfaces;
    Presenter& presenter;
  };
  explicit CapturedSurfaces(const Parts& parts) : p_(parts) {}

  /// A key with the camera that the next ones are likely to have: of those that wait, of the pending batch,
  /// or of the last one that was traced beside such surfaces. Null: none is known.
  const BatchKey* likely(const Batch& pending) const {
    if (!batch_.empty()) return &batch_.key();
    return !pending.empty() ? &pending.key() : last_ ? &*last_ : nullptr;
  }
  /// Adds a surface that was drawn with the current state. Those of another key are collected before.
  void add(const BatchKey& key, scene::Instance instance, scene::Shading shading, const Batch& pending);
  /// Reads what those that wait have drawn, and adds them to their view. Call before anything else is drawn
  /// over them that writes no depth, and before the framebuffer is cleared or another one is bound. Those
  /// whose framebuffer cannot be read, or has another draw buffer by now, are in no view. `beside`: the batch
  /// that is traced next; they take its eye space if that is possible, so that they are in its view.
  void collect(const Batch& beside) noexcept {
    if (!batch_.empty()) read(beside.empty() ? nullptr : &beside.key());
  }

 private:
  void read(const BatchKey* beside) noexcept;
  bool readPixels(bool samples, scene::FramebufferCapture& capture);
  void takeCamera(const BatchKey& beside);
  std::shared_ptr<const scene::FramebufferCapture> captureOf(const BatchKey& key, const scene::Snapshot& s);

  Parts p_;
  Batch batch_;
  std::optional<BatchKey> last_;
};

/// One depth a pixel of those of its samples: their middle, or kNothing where they are of several surfaces.
/// `nearest` becomes the result. Any thread.
void mergeSamples(int width, const std::vector<float>& farthest, float resolution,
                  std::vector<float>& nearest);

/// Where surfaces drawn with `key` may be in the framebuffer: leaves an image their pixels, and makes all
/// others nothing. `image` has all pixels of its region. Any thread.
void leaveSurfaces(const scene::Snapshot& surfaces, scene::FramebufferCapture& capture);

}  // namespace gluray::gl
