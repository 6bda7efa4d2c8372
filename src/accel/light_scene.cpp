#include "accel/light_scene.h"

#include "scene/surroundings.h"

#include <utility>

namespace gluray::accel {

bool LightScene::update(const scene::Snapshot& snapshot, const std::vector<PlacedBlas>& drawn,
                        std::vector<PlacedBlas> around) {
  scene_ = nullptr;
  std::vector<PlacedBlas> all = drawn;
  all.insert(all.end(), std::make_move_iterator(around.begin()), std::make_move_iterator(around.end()));
  if (!tlas_) tlas_.emplace(device_);
  const bool builds = !stayPlaced(snapshot, tlas_->held(), all);
  if (builds) tlas_->update(std::move(all));
  const glm::dmat4& view = snapshot.surroundings->viewFromWorld;
  bounds_ = view == glm::dmat4(1) ? boundsOf(tlas_->scene()) : boundsIn(view, tlas_->held());
  scene_ = tlas_->scene();
  return builds;
}

void LightScene::clear(const scene::Snapshot& snapshot) {
  scene_ = nullptr;
  if (!scene::needsSurroundings(snapshot.settings)) tlas_.reset();
}

}  // namespace gluray::accel
