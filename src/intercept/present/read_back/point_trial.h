// Finds out by drawing where fragment programs see points (gl_PointCoord) in multisampled framebuffers. One
// per context. GL thread, context current; restores all state.
#pragma once
#include "gl/real/real.h"
#include "intercept/present/state/features.h"

#include <glm/glm.hpp>

#include <map>
#include <optional>

namespace gluray::present {

class PointTrial {
 public:
  /// FramebufferReader::pointCoordinateShift(). Draws at the first call with each number of samples.
  std::optional<glm::vec2> shift(const gl::RealGl& real, const Features& features, int samples);

 private:
  std::map<int, std::optional<glm::vec2>> shifts_;  // by number of samples
};

}  // namespace gluray::present
