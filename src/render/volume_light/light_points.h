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
  /// The points are the middles of the first medium's cells. `frame` has no media. All must outlive it.
  LightPoints(const FrameData& frame, const Metric& metric, const Occluders& occluders,
              const std::vector<PlacedLattice>& media);

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
  /// What of a light arrives at each point. Of media, what has passed an optical depth of 1 counts as all:
  /// samples that show lie about as far behind the faces of their volume, which would be dark otherwise.
  /// Inside an arena.
  std::vector<float> arriving(const Source& source) const;

 private:
  template <class Work>
  void eachGroup(const Work& work) const;
  void aim(int lane, const glm::vec3& point, const glm::vec3& direction, float end,
           accel::OcclusionRays& rays) const;
  /// Shares of light that pass along the rays of some lanes.
  struct Shares {
    float bySurfaces[kLanes], byMedia[kLanes];
  };
  void pass(int count, accel::RayKind kind, accel::OcclusionRays& rays, Shares& shares) const;
  std::vector<float> smoothed(const std::vector<float>& values) const;
  glm::ivec3 cellOf(uint32_t cell) const;
  glm::vec3 pointOf(uint32_t cell) const;

  const FrameData& frame_;
  const Metric& metric_;
  const Occluders& occluders_;
  const std::vector<PlacedLattice>& media_;
  const Lattice& lattice_;  // of the points
  glm::mat4 worldFromLattice_;
  std::vector<uint32_t> cells_;  // those that samples with an opacity read
};

}  // namespace gluray::render
