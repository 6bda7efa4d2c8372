// Points of a lattice over a volume at which light arrives. Any thread.
#pragma once
#include "render/frame_data/frame_data.h"
#include "render/integrators/metric.h"
#include "render/integrators/occluders.h"
#include "render/media/medium_lattice.h"

#include <cstdint>
#include <vector>

namespace gluray::render {

class LightPoints {
 public:
  /// `frame` has the media of the view, `medium` among them, whose cells are the points'. They must outlive
  /// it, as must the occluders.
  LightPoints(const FrameData& frame, const Metric& metric, const Occluders& occluders,
              const PlacedLattice& medium);

  /// How open the surroundings of each point are within `radius` (eye space): the mean share of light that
  /// passes along directions all around it, relative to that along the most open eighth of them, times three,
  /// at most 1. So neither a flat face of a dense volume, which hides one half of the directions and, of what
  /// lies behind it, half of the rest, nor even fog is darkened. Cells around which nothing shows have 1.
  /// Inside an arena.
  std::vector<float> openness(float radius) const;

  /// A light as the points see it, eye space.
  struct Source {
    bool positional = false;
    glm::vec3 position{0}, towards{0, 0, 1};  // `towards`: to a light that is far away, length 1
  };
  /// What of a light arrives at each point. Inside an arena.
  std::vector<float> arriving(const Source& source) const;

 private:
  template <class Work>
  void eachGroup(const Work& work) const;
  void aim(int lane, const glm::vec3& point, const glm::vec3& direction, float end,
           accel::OcclusionRays& rays) const;
  /// The share of light that passes along the rays of `count` lanes.
  void pass(int count, accel::RayKind kind, accel::OcclusionRays& rays, float* through) const;
  std::vector<float> smoothed(const std::vector<float>& values) const;
  glm::ivec3 cellOf(uint32_t cell) const;
  glm::vec3 pointOf(uint32_t cell) const;

  const FrameData& frame_;
  const Metric& metric_;
  const Occluders& occluders_;
  const PlacedLattice& medium_;
  glm::mat4 worldFromLattice_;
  std::vector<uint32_t> cells_;  // those that samples with an opacity read
};

}  // namespace gluray::render
