#include "render/effects/occlusion_answers.h"

#include "render/effects/shadow_lights.h"

#include <algorithm>

namespace gluray::render {

OcclusionAnswers::OcclusionAnswers(const FrameData& frame)
    : frame_(frame), metric_(frame), occluders_(*frame.snapshot, frame.surfaces) {}

const std::vector<uint32_t>& OcclusionAnswers::lampsAround(const glm::vec3& light) const {
  const std::lock_guard lock(mutex_);
  const auto known = std::ranges::find(lamps_, light, &Lamps::light);
  if (known != lamps_.end()) return known->instances;
  return lamps_.emplace_back(Lamps{light, lampsOf(frame_, metric_, light)}).instances;
}

uint32_t OcclusionAnswers::occluded(const int32_t* valid, accel::OcclusionRays& rays, accel::RayKind kind,
                                    const glm::vec3* lamp, glm::vec3 (&through)[accel::kLanes]) const {
  static const std::vector<uint32_t> none;
  const std::vector<uint32_t>& lamps = lamp ? lampsAround(*lamp) : none;
  std::ranges::fill(through, glm::vec3(1));
  if (occluders_.areSolid() && lamps.empty()) return frame_.world->occluded(valid, rays, nullptr, kind);
  if (kind == accel::RayKind::occlusion) {
    const Transmittance light(occluders_);
    const uint32_t blocked = frame_.world->occluded(valid, rays, &light, kind);
    for (int i = 0; i < accel::kLanes; ++i) through[i] = glm::vec3(light.through[i]);
    return blocked;
  }
  const ColoredTransmittance light(occluders_, lamps);
  const uint32_t blocked = frame_.world->occluded(valid, rays, &light, kind);
  std::copy_n(light.through, accel::kLanes, through);
  return blocked;
}

}  // namespace gluray::render
