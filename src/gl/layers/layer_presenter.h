// How peeled layers leave the shadow GL: traced in the place of the program's peels, or made by them.
// Implemented in intercept/present/. GL thread, context current.
#pragma once
#include "gl/batch/present_result.h"
#include "gl/programs/held_pass.h"
#include "gl/real.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::gl {

/// The base class presents nothing.
class LayerPresenter {
 public:
  virtual ~LayerPresenter() = default;
  /// Traces the layers of `snapshot` into `target.result`, or puts there the picture that waits. Where that
  /// fails, or `rasterise`, the real OpenGL makes the held passes instead. Otherwise as
  /// Presenter::present().
  virtual PresentResult present(const RealGl&, const scene::SnapshotPtr&, const LayersTarget& /*target*/,
                                bool /*rasterise*/) noexcept {
    return {};
  }
  /// Traces layers alone: their picture is in the result, as where present() lets it wait.
  virtual PresentResult trace(const scene::SnapshotPtr&, const LayersTarget& /*target*/) noexcept {
    return {};
  }
  /// Makes a pass for its fragments to be counted alone, where the texture that it reads has so many pixels
  /// that are not 0. False where that is not possible. Never throws.
  virtual bool countPixels(const RealGl&, const HeldPass&, GLuint /*texture*/, glm::ivec2 /*size*/,
                           uint64_t /*pixels*/) noexcept {
    return false;
  }
  /// Reads red and green of level 0 of the texture bound to GL_TEXTURE_2D of unit `unit`, `size` pixels of
  /// two floats. False where it is of another kind, or cannot be read. Never throws.
  virtual bool readDepths(const RealGl&, GLint /*unit*/, glm::ivec2 /*size*/,
                          std::vector<glm::vec2>& /*out*/) noexcept {
    return false;
  }
};

}  // namespace gluray::gl
