// Presents peeled layers: traces them in place of the host program's peels, or draws them by replaying these
// peels. Implemented in intercept/present/, called by LayerDraws. GL thread, context current.
#pragma once
#include "gl/batch/held_pass.h"
#include "gl/batch/present_result.h"
#include "gl/real/real.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::gl {

/// The base class presents nothing.
class LayerPresenter {
 public:
  virtual ~LayerPresenter() = default;
  /// Traces the layers of `snapshot` into `target.result`, or writes `target.image` there. If tracing fails,
  /// or if `rasterise`, the real OpenGL draws the held passes instead. Otherwise like Presenter::present().
  virtual PresentResult present(const RealGl&, const scene::SnapshotPtr&, const LayersTarget& /*target*/,
                                bool /*rasterise*/) noexcept {
    return {};
  }
  /// Traces layers without writing: returns the image in PresentResult::image.
  virtual PresentResult trace(const scene::SnapshotPtr&, const LayersTarget& /*target*/) noexcept {
    return {};
  }
  /// Draws the pass for the active query so that the query counts it only if `pixels` pixels of `texture`,
  /// which the pass reads, are not 0.
  /// Leaves all images unchanged. Returns false if that is not possible. Never throws.
  virtual bool countPixels(const RealGl&, const HeldPass&, GLuint /*texture*/, glm::ivec2 /*size*/,
                           uint64_t /*pixels*/) noexcept {
    return false;
  }
  /// Reads red and green of level 0 of the texture bound to GL_TEXTURE_2D of unit `unit` as floats, `size`
  /// pixels. False if its format or size differs, or it cannot be read. Never throws.
  virtual bool readDepths(const RealGl&, GLint /*unit*/, glm::ivec2 /*size*/,
                          std::vector<glm::vec2>& /*out*/) noexcept {
    return false;
  }
};

}  // namespace gluray::gl
