// Colours of surfaces that the real OpenGL has drawn, where rays from elsewhere than the viewer meet them
// (scene/framebuffer_picture.h, docs/adr/0074). Made once for a scene, read by every tracing thread.
#pragma once
#include "render/frame_data/frame_data.h"
#include "render/paths/space_colors.h"
#include "scene/framebuffer_picture.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::render {

/// A point that the picture shows has the colour of its pixel, between pixels that of the four around it. Any
/// other has that of points nearby on the same surface which the picture shows (SpaceColors). A surface of
/// which it shows nothing has the mean of all that it shows, and grey where that is nothing, too.
class PicturedColors {
 public:
  /// Null where the frame has no pictured surfaces. Those of the last scenes are kept. `frame`: its world
  /// holds the scene.
  static std::shared_ptr<const PicturedColors> create(const FrameData& frame);
  explicit PicturedColors(const FrameData& frame);

  /// Whether this instance of the snapshot and its surroundings is pictured.
  bool has(uint32_t instance) const { return instance < seen_.size() && seen_[instance].picture; }
  /// The colour at a point of it, eye space.
  glm::vec3 at(uint32_t instance, const glm::vec3& eye) const;

 private:
  /// Which surface each pixel shows.
  struct Shown {
    std::shared_ptr<const scene::FramebufferPicture> picture;
    std::vector<uint32_t> instances;  // accel::kNoHit: none
    std::vector<float> tolerances;    // of depths of the same surface, within a pixel
    glm::vec3 mean{0.5f};
  };
  struct Seen {
    const Shown* picture = nullptr;  // null: not pictured
    glm::dmat4 clipFromEye{1}, objectFromEye{1};
    SpaceColors colors;  // object space
  };
  void find(const FrameData& frame, Shown& shown, const glm::dmat4& clipFromEye) const;
  void spread(const FrameData& frame, Shown& shown);
  /// Adds the colours of the pixels around a point that show the instance. Returns their weights' sum.
  float addPixels(const Shown& shown, uint32_t instance, const glm::dvec4& clip, glm::vec3& sum) const;

  std::vector<Shown> shown_;
  std::vector<Seen> seen_;  // as FrameData::surfaces
};

}  // namespace gluray::render
