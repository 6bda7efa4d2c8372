#include "cluster/gather/merged.h"

#include "cluster/stream/byte_stream.h"
#include "scene/same_camera.h"
#include "scene/secondary_scene.h"
#include "scene/world_space.h"

#include <algorithm>

namespace gluray::cluster {
namespace {

/// Adds shadings and instances of a part to those of the whole, as drawn after them.
class Adding {
 public:
  Adding(const scene::Snapshot& part, const scene::Snapshot& whole)
      : eyeFromWorld_(whole.eyeFromWorld),
        worldFromEye_(glm::inverse(whole.eyeFromWorld)),
        isSameWorld_(part.eyeFromWorld == whole.eyeFromWorld) {}

  void add(const auto& part, auto& whole) const {
    const auto before = static_cast<uint32_t>(whole.shadings.size());
    uint32_t order = 0;
    for (const scene::Instance& instance : whole.instances) order = std::max(order, instance.order + 1);
    whole.shadings.insert(whole.shadings.end(), part.shadings.begin(), part.shadings.end());
    for (const scene::Instance& instance : part.instances) {
      scene::Instance& added = whole.instances.emplace_back(instance);
      added.shading += before;
      added.order += order;
      if (!isSameWorld_) added.worldFromObject = scene::worldFromObject(added, eyeFromWorld_, worldFromEye_);
    }
  }

 private:
  const glm::dmat4 eyeFromWorld_, worldFromEye_;
  const bool isSameWorld_;
};

}  // namespace

void merge(const std::vector<std::shared_ptr<scene::Snapshot>>& parts, scene::Snapshot& whole) {
  std::shared_ptr<scene::SecondaryScene> around;
  if (whole.secondaryScene) around = std::make_shared<scene::SecondaryScene>(*whole.secondaryScene);
  for (const std::shared_ptr<scene::Snapshot>& part : parts) {
    if (scene::eyeFromEye(whole, *part) != glm::dmat4(1)) throw Malformed("a part of another view");
    const Adding adding(*part, whole);
    adding.add(*part, whole);
    if (!part->secondaryScene) continue;
    if (!around) {
      around = std::make_shared<scene::SecondaryScene>();
      if (part->eyeFromWorld == whole.eyeFromWorld)
        around->viewFromWorld = part->secondaryScene->viewFromWorld;
    }
    adding.add(*part->secondaryScene, *around);
    around->blended.insert(around->blended.end(), part->secondaryScene->blended.begin(),
                           part->secondaryScene->blended.end());
  }
  whole.secondaryScene = std::move(around);
}

}  // namespace gluray::cluster
