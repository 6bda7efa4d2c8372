// Maps points of this frame to pixels of an earlier frame, and detects changes. Made once a frame, read by
// all tracing threads.
#pragma once
#include "render/moving/pixel_space.h"

#include <vector>

namespace gluray::render {

/// Positions of the surfaces of a snapshot and its secondary scene; kept for the next frame.
struct Placement {
  struct Object {
    Hash128 geometry;
    uint32_t triangles = 0;
    glm::dmat4 eyeFromObject{1};
    float radius = 0;                    // of impostors
    std::vector<glm::dvec4> clipPlanes;  // object space
  };
  std::vector<Object> objects;
  glm::dmat4 eyeFromWorld{1};

  /// Throws std::bad_alloc.
  void rememberScene(const scene::Snapshot&);
};

struct Reprojection {
  glm::mat4 earlierFromEye{1};        // for points of surfaces that did not move
  glm::mat3 earlierFromEyeNormal{1};  // their normals, not of unit length
  glm::mat4 earlierPixelFromEye{1};   // as PixelSpace::pixelFromEye
  std::vector<uint8_t> moved;         // by instance: moved relative to the others, or new
  bool changed = false;               // some instance moved, changed, appeared or disappeared

  Reprojection() = default;
  /// `earlier`: placement and space of the earlier frame. The motion of most triangles counts as the camera's
  /// motion.
  Reprojection(const Placement& earlier, const PixelSpace& earlierSpace, const Placement& now,
               const FrameData& frame);
  bool stayed(uint32_t instance) const { return moved.empty() || !moved[instance]; }
};

}  // namespace gluray::render
