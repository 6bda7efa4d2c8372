// Traces layers into textures of the program. GL thread.
#pragma once
#include "gl/batch/layer_presenter.h"
#include "intercept/present/presented_images.h"

#include <vector>

namespace gluray::present {

class TracedLayers final : public gl::LayerPresenter {
 public:
  explicit TracedLayers(PresentedImages& shared) : shared_(shared) {}
  gl::PresentResult present(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                            const gl::LayersTarget& target, bool rasterise) noexcept override;
  gl::PresentResult trace(const scene::SnapshotPtr& snapshot,
                          const gl::LayersTarget& target) noexcept override;
  bool countPixels(const gl::RealGl& real, const gl::HeldPass& pass, GLuint texture, glm::ivec2 size,
                   uint64_t pixels) noexcept override;
  bool readDepths(const gl::RealGl& real, GLint unit, glm::ivec2 size,
                  std::vector<glm::vec2>& out) noexcept override;

 private:
  gl::PresentResult tracedOrRasterised(const gl::RealGl& real, const scene::Snapshot* snapshot,
                                       const gl::LayersTarget& target);

  PresentedImages& shared_;
};

}  // namespace gluray::present
