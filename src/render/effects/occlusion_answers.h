// Answers occlusion queries of other processes in the scene of a frame. Made once a frame, called on all
// tracing threads.
#pragma once
#include "accel/rays/occlusion.h"
#include "render/integrators/metric.h"
#include "render/integrators/occluders.h"
#include "render/remote/remote_surfaces.h"

#include <glm/glm.hpp>

#include <list>
#include <mutex>
#include <vector>

namespace gluray::render {

class OcclusionAnswers {
 public:
  /// `frame` must outlive it. Throws std::runtime_error where the modelview matrix cannot be inverted.
  explicit OcclusionAnswers(const FrameData& frame);
  /// Returns bit i if ray i is blocked, and writes the transmittance of the other rays to `through`. `valid`
  /// is aligned to 64 bytes. `lamp`: RemoteQuery::lamp.
  uint32_t occluded(const int32_t* valid, accel::OcclusionRays&, accel::RayKind, const glm::vec3* lamp,
                    glm::vec3 (&through)[accel::kLanes]) const;

 private:
  const std::vector<uint32_t>& lampsAround(const glm::vec3& light) const;

  struct Lamps {
    glm::vec3 light;
    std::vector<uint32_t> instances;
  };
  const FrameData& frame_;
  Metric metric_;
  Occluders occluders_;
  mutable std::mutex mutex_;
  mutable std::list<Lamps> lamps_;
};

}  // namespace gluray::render
