// Framebuffer pixels of surfaces that the real OpenGL has drawn (docs/adr/0074), for reflection by other
// surfaces. Made by gl/pending/captured_surfaces, shared, immutable.
#pragma once
#include "base/hash.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::scene {

struct FramebufferCapture {
  static constexpr float kNothing = 2;  // depth of pixels that show none of the surfaces

  glm::ivec4 viewport{0, 0, 1, 1};
  float depthNear = 0, depthFar = 1;  // glDepthRange
  Region region;                      // of the pixels; empty if the surfaces lie outside of the view
  PolygonOffset offset;               // of the surfaces' draws; `resolution`: one step of depth
  std::vector<uint32_t> colors;       // RGBA8 as stored, red in the lowest byte; bottom row first
  std::vector<float> depths;          // of the same pixels, window depths, or kNothing
  Hash128 content;                    // hash of all members above
};

/// Maps a surface to such an image.
struct CapturedSurface {
  static constexpr uint32_t kNone = ~0u;
  uint32_t capture = kNone;      // index into SecondaryScene::images; kNone: the surface is not captured
  glm::dmat4 clipFromObject{1};  // of the draw
  bool operator==(const CapturedSurface&) const = default;
};

}  // namespace gluray::scene
