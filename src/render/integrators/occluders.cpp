#include "render/integrators/occluders.h"

#include <algorithm>
#include <vector>

namespace gluray::render {
namespace {

class ClippedOccluders final : public accel::OccluderFilter {
 public:
  explicit ClippedOccluders(const scene::Snapshot& snapshot) : planes_(snapshot.instances.size()) {
    for (size_t i = 0; i < planes_.size(); ++i) {
      const scene::Instance& instance = snapshot.instances[i];
      // A plane acts on eye coordinates; as a row vector it comes to object space by the modelview on its
      // right.
      for (const glm::dvec4& plane : instance.clipPlanes)
        planes_[i].push_back(plane * instance.eyeFromObject);
    }
  }
  bool blocks(const accel::Occluder& occluder) const noexcept override {
    const glm::dvec4 point(occluder.point, 1);
    const std::vector<glm::dvec4>& planes = planes_[occluder.instance];
    return std::all_of(planes.begin(), planes.end(), [&](const auto& p) { return glm::dot(p, point) >= 0; });
  }

 private:
  std::vector<std::vector<glm::dvec4>> planes_;  // object space, by instance
};

}  // namespace

std::unique_ptr<const accel::OccluderFilter> makeOccluders(const scene::Snapshot& snapshot) {
  const auto isClipped = [](const scene::Instance& i) { return !i.clipPlanes.empty(); };
  if (std::none_of(snapshot.instances.begin(), snapshot.instances.end(), isClipped)) return nullptr;
  return std::make_unique<ClippedOccluders>(snapshot);
}

}  // namespace gluray::render
