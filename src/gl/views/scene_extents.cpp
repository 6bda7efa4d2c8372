#include "gl/views/scene_extents.h"

#include "scene/box_corner.h"
#include "scene/mesh.h"
#include "scene/same_camera.h"
#include "scene/secondary_scene.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace gluray::gl {
namespace {

constexpr size_t kMaxScenes = 4;       // of layers, insets and other views
constexpr size_t kMaxSurfaces = 4096;  // of larger scenes nothing is remembered

}  // namespace

void SceneExtents::add(const scene::Instance& instance, const glm::dmat4& eyeFromPart, Surfaces& to) {
  const scene::Mesh& mesh = *instance.mesh;
  if (!instance.ground)
    to.push_back({mesh.geometryId, eyeFromPart * instance.eyeFromObject, glm::dvec3(mesh.lower),
                  glm::dvec3(mesh.upper)});
}

bool SceneExtents::isOutside(const Surface& surface, const glm::dmat4& clipFromEye) {
  const glm::dmat4 clipFromObject = clipFromEye * surface.eyeFromObject;
  unsigned outside = 0x3f;  // a bit for each plane that all corners so far lie beyond
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 clip =
        clipFromObject * glm::dvec4(scene::boxCorner(surface.lower, surface.upper, corner), 1);
    for (int axis = 0; axis < 3; ++axis) {
      if (!(clip[axis] < -clip.w)) outside &= ~(1u << (2 * axis));
      if (!(clip[axis] > clip.w)) outside &= ~(2u << (2 * axis));
    }
  }
  return outside != 0;
}

double SceneExtents::diagonalOf(const Scene& scene) {
  const glm::dmat4 worldFromEye = glm::inverse(scene.eyeFromWorld);
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  glm::dvec3 lower(kInfinite), upper(-kInfinite);
  for (const Surface& surface : scene.surfaces) {
    const glm::dmat4 worldFromObject = worldFromEye * surface.eyeFromObject;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 at(worldFromObject *
                          glm::dvec4(scene::boxCorner(surface.lower, surface.upper, corner), 1));
      lower = glm::min(lower, at), upper = glm::max(upper, at);
    }
  }
  glm::dvec3 sides;
  for (int axis = 0; axis < 3; ++axis) sides[axis] = glm::length(glm::dvec3(scene.eyeFromWorld[axis]));
  return glm::length(sides * (upper - lower));
}

std::optional<size_t> SceneExtents::sceneOf(const Surfaces& now) const {
  if (scenes_.empty()) return std::nullopt;
  std::unordered_set<Hash128> drawn;
  for (const Surface& surface : now) drawn.insert(surface.geometry);
  std::optional<size_t> best;
  std::ptrdiff_t most = 0;
  for (size_t i = 0; i < scenes_.size(); ++i) {
    const Surfaces& known = scenes_[i].surfaces;
    const auto shared = std::count_if(known.begin(), known.end(),
                                      [&](const Surface& s) { return drawn.contains(s.geometry); });
    if (shared > 0 && shared >= most) most = shared, best = i;
  }
  return best;
}

SceneExtents::Scene SceneExtents::outOfView(const Scene& known, const Surfaces& now,
                                            const glm::dmat4& clipFromEye) {
  // Equal geometry is drawn in equal order.
  std::unordered_multimap<Hash128, const Surface*> drawn;
  for (auto surface = now.rbegin(); surface != now.rend(); ++surface)
    drawn.emplace(surface->geometry, &*surface);
  Movement movement;
  Surfaces left;
  for (const Surface& surface : known.surfaces) {
    const auto found = drawn.find(surface.geometry);
    if (found == drawn.end()) {
      left.push_back(surface);
      continue;
    }
    movement.compare(surface.eyeFromObject, found->second->eyeFromObject);
    drawn.erase(found);
  }
  const glm::dmat4 moved = movement.shared().value_or(glm::dmat4(1));
  for (Surface& surface : left) surface.eyeFromObject = moved * surface.eyeFromObject;
  const auto isOut = [&](const Surface& surface) { return isOutside(surface, clipFromEye); };
  std::erase_if(left, [&](const Surface& surface) { return !isOut(surface); });
  // A program that draws what lies out of view does not leave it out: what it does not draw is gone.
  if (static_cast<size_t>(std::count_if(now.begin(), now.end(), isOut)) >= left.size()) left.clear();
  return {moved * known.eyeFromWorld, std::move(left)};
}

float SceneExtents::extentOf(const scene::Snapshot& s) const {
  if (scenes_.empty() || scene::countAll(s) > kMaxSurfaces) return 0;
  Surfaces now;
  for (size_t i = 0; i < scene::countAll(s); ++i) add(scene::instanceOf(s, i), glm::dmat4(1), now);
  const auto known = sceneOf(now);
  if (!known) return 0;
  Scene all = outOfView(scenes_[*known], now, s.camera.clipFromEye);
  if (all.surfaces.empty()) return 0;
  std::move(now.begin(), now.end(), std::back_inserter(all.surfaces));
  return static_cast<float>(diagonalOf(all));
}

void SceneExtents::remember(const ViewEpoch& epoch) {
  Scene next{epoch.first().eyeFromWorld, {}};
  for (const ViewEpoch::Drawn& drawn : epoch.batches) {
    const auto eyeFromPart = eyeFromEye(epoch.first(), *drawn.snapshot);
    if (!eyeFromPart) continue;
    for (size_t i = 0; i < drawn.snapshot->instances.size(); ++i)
      if (drawn.erased.empty() || !drawn.erased[i])
        add(drawn.snapshot->instances[i], *eyeFromPart, next.surfaces);
    if (next.surfaces.size() > kMaxSurfaces) return;
  }
  if (const auto known = sceneOf(next.surfaces)) {
    Scene kept = outOfView(scenes_[*known], next.surfaces, epoch.first().camera.clipFromEye);
    next.eyeFromWorld = kept.eyeFromWorld;
    std::move(kept.surfaces.begin(), kept.surfaces.end(), std::back_inserter(next.surfaces));
    scenes_.erase(scenes_.begin() + static_cast<std::ptrdiff_t>(*known));
  }
  if (next.surfaces.empty() || next.surfaces.size() > kMaxSurfaces) return;
  if (scenes_.size() == kMaxScenes) scenes_.erase(scenes_.begin());
  scenes_.push_back(std::move(next));
}

}  // namespace gluray::gl
