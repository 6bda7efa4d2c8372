// Colours of surfaces that the real OpenGL has drawn, for secondary rays (scene/framebuffer_capture.h,
// docs/adr/0074). Made once for a scene, read by every tracing thread.
#pragma once
#include "render/frame_data/frame_data.h"
#include "render/paths/space_colors.h"
#include "scene/framebuffer_capture.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::render {

/// A point that is visible in the image gets the interpolated colour of the four pixels around it. Any
/// other point gets the colour of nearby visible points of the same surface (SpaceColors). A surface without
/// visible points gets the mean colour of all captured surfaces, or grey if none is visible.
class CapturedColors {
 public:
  /// Null if the frame has no captured surfaces. Caches the last scenes. `frame`: its world holds the scene.
  static std::shared_ptr<const CapturedColors> create(const FrameData& frame);
  explicit CapturedColors(const FrameData& frame);

  /// Whether this instance of the snapshot and its secondary scene is captured.
  bool has(uint32_t instance) const { return instance < seen_.size() && seen_[instance].capture; }
  /// Colour at a point of the instance, eye space.
  glm::vec3 at(uint32_t instance, const glm::vec3& eye) const;

 private:
  /// The visible surface of each pixel.
  struct Shown {
    std::shared_ptr<const scene::FramebufferCapture> capture;
    std::vector<uint32_t> instances;  // accel::kNoHit: none
    std::vector<float> tolerances;    // depth tolerance of a surface within a pixel
    glm::vec3 mean{0.5f};
  };
  struct Seen {
    const Shown* capture = nullptr;  // null: not captured
    glm::dmat4 clipFromEye{1}, objectFromEye{1};
    SpaceColors colors;  // object space
  };
  void find(const FrameData& frame, Shown& shown, const glm::dmat4& clipFromEye) const;
  void spread(const FrameData& frame, Shown& shown);
  /// Adds the colours of the pixels around a point that show the instance. Returns the sum of their weights.
  float addPixels(const Shown& shown, uint32_t instance, const glm::dvec4& clip, glm::vec3& sum) const;

  std::vector<Shown> shown_;
  std::vector<Seen> seen_;  // as FrameData::surfaces
};

}  // namespace gluray::render
