// The background of a view (setting `background`). Made once a frame, called on all tracing threads.
#pragma once
#include "render/camera/ray_setup.h"
#include "render/lights/environment.h"
#include "render/resolve/tone.h"
#include "scene/backdrop.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>

namespace gluray::render {

class BackdropLook {
 public:
  /// Depth of the background: the largest float below the cleared depth of 1. With GL_GREATER and a cleared
  /// depth of 0, as far from that.
  static constexpr float kDepth = 0x1.fffffep-1f;
  static constexpr float depthOf(const scene::Camera& camera) {
    return camera.largestWins ? 1 - kDepth : kDepth;
  }

  /// `eyeRays`: of the snapshot's camera. Its backdrop must not be null; both must outlive this.
  BackdropLook(const scene::Snapshot&, const RaySetup& eyeRays);
  /// Whether pixel (x, y) of the region may show the background.
  bool covers(int x, int y) const {
    return isClear_.empty() || isClear_[static_cast<size_t>(y) * width_ + static_cast<size_t>(x)] != 0;
  }
  /// Brightens an environment by a factor of linear light.
  void expose(const scene::Snapshot&, float factor);
  /// Its colour at a window position, encoded as in the framebuffer.
  glm::vec3 at(float x, float y) const noexcept;

 private:
  glm::vec3 environmentAt(float x, float y) const noexcept;

  const std::vector<uint8_t>& isClear_;
  size_t width_;
  const RaySetup& rays_;
  std::optional<ToneMap> tone_;                     // of the environment
  std::shared_ptr<const Environment> environment_;  // null: colours
  glm::vec3 bottom_{0}, top_{0};
  float base_ = 0, height_ = 1;  // of the view, pixels
};

}  // namespace gluray::render
