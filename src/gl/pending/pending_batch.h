// The batch that waits to be traced, with its presenter and the cost of its images. Flusher decides when it
// is presented. A part of each Context, GL thread.
#pragma once
#include "gl/basics/failsafe.h"
#include "gl/batch/batch.h"
#include "gl/batch/held_batch.h"
#include "gl/batch/presenter.h"
#include "gl/batch/unresolved_image.h"
#include "gl/clock/frame_clock.h"
#include "gl/counts/draw_counts.h"
#include "gl/framebuffers/cleared_framebuffers.h"
#include "gl/history/surface_history.h"
#include "gl/pending/captured_surfaces.h"
#include "gl/shadow/shadow_state.h"
#include "scene/secondary_scene.h"

#include <memory>
#include <optional>
#include <string_view>

namespace gluray::gl {

/// Why the draws of a batch that could not be traced were rasterised.
Reason reasonOf(scene::Loss loss);

/// Whether the image of such a batch may be lit again (Relighting): others are blended by the real OpenGL.
inline bool isRelightable(const BatchKey& key, const scene::Snapshot& snapshot) {
  using Layers = BatchKey::Layers;
  return (key.layers == Layers::none || key.layers == Layers::drawn) && !snapshot.catches &&
         !snapshot.wideColors && scene::needsSecondaryScene(snapshot.settings);
}

class PendingBatch {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    DrawCounts& counts;
    SurfaceHistory& surfaces;
    ClearedFramebuffers& cleared;
  };
  PendingBatch(const Parts& parts, Presenter& with)
      : presenter(with), capturedSurfaces({parts.shadow, parts.clock, parts.surfaces, with}), p_(parts) {}

  Batch batch;
  Presenter& presenter;
  CapturedSurfaces capturedSurfaces;
  UnresolvedImage unresolved;  // of ResolveDraws
  bool refines = false;        // images of the last frame are refined while the program is idle

  /// Whether this OpenGL can show traced images (Presenter::supports()). The first call builds shaders.
  bool canTrace();
  /// Whether canTrace() was called.
  bool knowsSupport() const { return supported_.has_value(); }
  /// Call when the program begins to draw.
  void stopRefining() {
    if (refines) presenter.window().stopRefining();
  }
  /// The program begins to draw what will be traced: how light is sampled for it.
  scene::LightSampling::Mode begin() {
    stopRefining();
    return p_.clock.lightMode(p_.shadow.settings);
  }
  /// Numbers the surfaces of the batch, and gives it its secondary scene. Call before it is traced or taken.
  void attachSecondaryScene();
  /// Peeled layers that were traced are drawn by the real OpenGL after all: they light nothing.
  void withdrawPeeled() noexcept { p_.surfaces.views.withdrawPeeled(p_.clock.frame); }
  /// Takes the batch, which is or will be traced, out before it is in its framebuffer. Call surround()
  /// before. `where`: what shows it, for the log.
  HeldBatch hold(std::string_view where);
  /// Presents it into its framebuffer. `known`: its image is traced already. The real OpenGL draws it where
  /// limits of address space leave too little for compiling what writes images.
  void presentLate(HeldBatch held, bool known);
  /// Call after each presentation: restores what it changed of the current material, and adds its result to
  /// the statistics. `known`: the image was shown before, elsewhere.
  void takeResult(const PresentResult& result, bool known = false);

 private:
  std::shared_ptr<const scene::Backdrop> backdrop();

  Parts p_;
  std::optional<bool> supported_;
};

}  // namespace gluray::gl
