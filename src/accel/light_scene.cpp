#include "accel/light_scene.h"

#include "scene/secondary_scene.h"

#include <algorithm>
#include <utility>

namespace gluray::accel {
namespace {

bool hasGround(const scene::Snapshot& s) {
  const auto isGround = [](const scene::Instance& i) { return i.ground; };
  return std::any_of(s.instances.begin(), s.instances.end(), isGround) ||
         (s.secondaryScene &&
          std::any_of(s.secondaryScene->instances.begin(), s.secondaryScene->instances.end(), isGround));
}

/// What rays of a kind meet.
std::vector<PlacedBlas> seenBy(RayKind kind, std::vector<PlacedBlas> all, const HiddenFrom& hidden) {
  for (size_t i = 0; i < all.size(); ++i)
    if (isHidden(hidden, i, kind)) all[i].blas = nullptr;
  return all;
}

bool meetTheSame(RayKind a, RayKind b, const HiddenFrom& hidden) {
  return std::all_of(hidden.begin(), hidden.end(),
                     [&](uint8_t bits) { return ((bits & bitOf(a)) != 0) == ((bits & bitOf(b)) != 0); });
}

Bounds sceneBounds(const scene::Snapshot& s, const glm::dmat4& view, std::vector<PlacedBlas> all) {
  for (size_t i = 0; i < all.size(); ++i)
    if (scene::instanceOf(s, i).ground) all[i].blas = nullptr;
  return boundsIn(view, all);
}

}  // namespace

bool LightScene::updateOne(const scene::Snapshot& snapshot, size_t kind, std::vector<PlacedBlas> met) {
  std::optional<Tlas>& tlas = tlas_[kind];
  if (!tlas) tlas.emplace(device_);
  const bool builds = !stayPlaced(snapshot.eyeFromWorld, *tlas, met);
  if (builds) tlas->update(std::move(met), snapshot.eyeFromWorld);
  return builds;
}

bool LightScene::update(const scene::Snapshot& snapshot, const std::vector<PlacedBlas>& drawn,
                        std::vector<PlacedBlas> around, const HiddenFrom& hidden) {
  scenes_ = {};
  std::vector<PlacedBlas> all = drawn;
  all.insert(all.end(), std::make_move_iterator(around.begin()), std::make_move_iterator(around.end()));
  const glm::dmat4 view = snapshot.secondaryScene ? snapshot.secondaryScene->viewFromWorld : glm::dmat4(1);
  const bool apart = !hidden.empty() || hasGround(snapshot);
  if (apart) bounds_ = sceneBounds(snapshot, view, all);
  bool builds = false;
  std::array<RTCSceneTy*, kKinds> scenes{};
  for (size_t k = 0; k < kKinds; ++k) {
    const auto kind = static_cast<RayKind>(k + 1);
    for (size_t j = 0; j < k && !scenes[k]; ++j)
      if (meetTheSame(kind, static_cast<RayKind>(j + 1), hidden)) scenes[k] = scenes[j];
    if (scenes[k]) {
      tlas_[k].reset();
      continue;
    }
    builds |= updateOne(snapshot, k, hidden.empty() ? std::move(all) : seenBy(kind, all, hidden));
    scenes[k] = tlas_[k]->scene();
  }
  if (!apart) bounds_ = view == glm::dmat4(1) ? boundsOf(scenes[0]) : boundsIn(view, tlas_[0]->held());
  scenes_ = scenes;
  return builds;
}

void LightScene::clear(const scene::Snapshot& snapshot) {
  scenes_ = {};
  if (!scene::needsSecondaryScene(snapshot.settings)) release();
}

bool LightScene::release() {
  scenes_ = {};
  bool any = false;
  for (std::optional<Tlas>& tlas : tlas_) any |= tlas.has_value(), tlas.reset();
  return any;
}

}  // namespace gluray::accel
