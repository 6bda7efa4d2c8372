#include "accel/world.h"

#include "accel/device/embree.h"
#include "accel/device/error.h"
#include "accel/impostors/pixel_impostor.h"
#include "base/log.h"
#include "scene/secondary_scene.h"
#include "scene/world_space.h"

#include <algorithm>
#include <string>

namespace gluray::accel {
namespace {

const std::vector<scene::Instance> kNoInstances;

bool isImpostors(const scene::Instance& i) { return i.mesh->shape != scene::Shape::triangles; }

bool isPage(const scene::Instance& i) { return i.mesh->residence != nullptr; }

Geometry geometryOf(const scene::Instance& instance, const scene::Camera& camera) {
  Geometry geometry{instance.mesh.get(), {}, &instance.mesh};
  if (isImpostors(instance)) geometry.reach = reachOf(instance, camera);
  return geometry;
}

/// Removes what rays from the viewer do not meet in a structure. True if there was any.
bool removeUnseen(const scene::Snapshot& snapshot, const HiddenFrom& hidden,
                  std::vector<PlacedBlas>& placed) {
  bool any = false;
  for (size_t i = 0; i < placed.size(); ++i) {
    if (!snapshot.instances[i].ground && !isHidden(hidden, i, RayKind::camera)) continue;
    placed[i].blas = nullptr;
    any = true;
  }
  return any;
}

}  // namespace

World::World(size_t idleBudgetBytes, FreeMemory freeMemory)
    : pages_(device_),
      cache_(device_, pages_, idleBudgetBytes, freeMemory),
      tlas_(device_),
      light_(device_) {}

UpdateStatistics World::update(const scene::Snapshot& snapshot, Arena& arena, const HiddenFrom& hidden) {
  return arena.execute([&] {
    UpdateStatistics statistics;
    const uint64_t before = cache_.builds();
    const uint64_t refits = cache_.refits(), refined = cache_.refinements();
    scene_ = nullptr;
    cache_.beginBatch(snapshot.frame);
    std::vector<PlacedBlas> placed = placeInstances(snapshot);
    if (placeAround(snapshot, placed, hidden)) ++statistics.tlasBuilds;
    const bool unseen = removeUnseen(snapshot, hidden, placed);
    ground_ = Ground(snapshot);
    statistics.blasBuilds = cache_.builds() - before;
    statistics.blasRefits = cache_.refits() - refits;
    statistics.blasRefinements = cache_.refinements() - refined;

    const bool fromTopLevel = chooseScene(snapshot, std::move(placed), statistics);
    if (fromTopLevel) tlasUsed_ = cache_.frames();
    if (light_.exists()) lightUsed_ = cache_.frames();
    releaseUnused();
    cache_.evict();
    if (scene_) readBounds();
    if (!scene_ && unseen && light_.exists()) lower_ = light_.bounds().lower, upper_ = light_.bounds().upper;
    readOrder(snapshot, fromTopLevel);
    readImpostors(snapshot);
    return statistics;
  });
}

/// Chooses what the viewer's rays are traced in. True: the TLAS.
bool World::chooseScene(const scene::Snapshot& snapshot, std::vector<PlacedBlas> placed,
                        UpdateStatistics& statistics) {
  const auto filled = [](const PlacedBlas& p) { return p.blas != nullptr; };
  const auto first = std::find_if(placed.begin(), placed.end(), filled);
  alone_ = nullptr;
  if (first == placed.end()) return false;
  const bool lone = std::none_of(first + 1, placed.end(), filled);
  if (lone && first->worldFromObject == glm::mat4(1)) {
    alone_ = first->blas;
    aloneIndex_ = static_cast<uint32_t>(first - placed.begin());
    scene_ = alone_->scene();
    return false;
  }
  const bool stay = stayPlaced(snapshot.eyeFromWorld, tlas_, placed);
  if (!stay && tlas_.update(std::move(placed), snapshot.eyeFromWorld))
    ++statistics.tlasBuilds, apart_ = false;
  scene_ = tlas_.scene();
  return true;
}

/// Lets all structures go that the last update was traced in. Nothing may be traced until one succeeds.
void World::release() {
  scene_ = nullptr, alone_ = nullptr;
  tlas_.clear();
  light_.release();
}

/// Lets structures over instances go that no batch of this frame or of the one before was traced in: they
/// keep those of meshes alive. Batches of one frame may take turns.
void World::releaseUnused() {
  const uint64_t now = cache_.frames();
  if (now - tlasUsed_ > 1) tlas_.clear();
  if (now - lightUsed_ > 1) light_.release();
}

std::vector<PlacedBlas> World::placeInstances(const scene::Snapshot& snapshot) {
  std::vector<Geometry> meshes;
  meshes.reserve(snapshot.instances.size());
  for (const scene::Instance& instance : snapshot.instances)
    meshes.push_back(geometryOf(instance, snapshot.camera));

  std::vector<BlasPtr> blases = structures(meshes, snapshot.settings.bvh);
  std::vector<PlacedBlas> placed(blases.size());
  for (size_t i = 0; i < blases.size(); ++i) {
    placed[i] = {std::move(blases[i]), snapshot.instances[i].worldFromObject};
    if (placed[i].blas && !scene::isPlaceable(placed[i].worldFromObject)) {
      throw Error("instance " + std::to_string(i) + " has a transform that cannot be inverted",
                  scene::Loss::draws);
    }
  }
  return placed;
}

std::vector<BlasPtr> World::structures(const std::vector<Geometry>& meshes, BvhQuality quality) {
  try {
    return cache_.get(meshes, quality);
  } catch (const std::exception&) {
    // Free idle structures, also where the last update keeps them alive, and retry, before building coarser
    // structures or failing.
    const size_t before = Device::bytes();
    release();
    if (cache_.evictAllIdle() || Device::bytes() < before) try {
        return cache_.get(meshes, quality);
      } catch (const std::exception&) {}
    if (!cache_.thriftHelps(meshes, quality)) throw;
  }
  log::once(log::Level::warning, "thrift",
            "out of memory: large meshes get smaller acceleration structures (see --bvh), which are somewhat "
            "slower to trace");
  return cache_.get(meshes, quality, true);
}

/// Places the snapshot's secondary scene. True if a structure over the instances was built.
bool World::placeAround(const scene::Snapshot& snapshot, const std::vector<PlacedBlas>& drawn,
                        const HiddenFrom& hidden) {
  light_.clear(snapshot);
  const bool surrounded = snapshot.secondaryScene && !snapshot.secondaryScene->instances.empty();
  if (!surrounded && hidden.empty() && snapshot.ground == scene::GroundUse::none) return false;
  try {
    const auto& others = surrounded ? snapshot.secondaryScene->instances : kNoInstances;
    std::vector<Geometry> meshes;
    for (const scene::Instance& instance : others) meshes.push_back(geometryOf(instance, snapshot.camera));
    std::vector<BlasPtr> blases = cache_.aside(meshes, snapshot.settings.bvh);
    std::vector<PlacedBlas> around(blases.size());
    for (size_t i = 0; i < blases.size(); ++i) {
      const glm::mat4& place = others[i].worldFromObject;
      if (scene::isPlaceable(place)) around[i] = {std::move(blases[i]), place};
    }
    return light_.update(snapshot, drawn, std::move(around), hidden);
  } catch (const std::exception& e) {
    log::once(log::Level::warning, "secondary scene",
              std::string("light effects act only between surfaces that are drawn together (") + e.what() +
                  "): free memory, or switch the light effects off");
    return false;
  }
}

void World::readBounds() {
  const Bounds bounds = boundsOf(scene_);
  lower_ = bounds.lower, upper_ = bounds.upper;
  // A mesh whose triangles were all left out has no bounds: nothing to hit.
  if (bounds.empty()) scene_ = nullptr;
}

/// `fromTopLevel`: the rays' scene is the TLAS.
void World::readOrder(const scene::Snapshot& snapshot, bool fromTopLevel) {
  // Programs draw points and lines that cells share once per cell, each in its own colour; sticks share the
  // round ends at their joints; splats are flat
  // and overlap at equal distance.
  const auto repeated = [](const scene::Instance& i) {
    return scene::isInWindow(i.mesh->shape) || scene::isSolid(i.mesh->shape) ||
           i.mesh->shape == scene::Shape::sticks;
  };
  const bool known = fromTopLevel && apart_;
  const bool paged = std::any_of(snapshot.instances.begin(), snapshot.instances.end(), isPage);
  mayCoincide_ =
      paged || (!known && (coincidence_.possible(snapshot.instances) ||
                           std::any_of(snapshot.instances.begin(), snapshot.instances.end(), repeated)));
  if (fromTopLevel) apart_ = !mayCoincide_;
  order_.laterWins = snapshot.laterWins;
  order_.ranks.clear(), order_.numbers.clear();
  if (!mayCoincide_) return;
  for (const scene::Instance& instance : snapshot.instances) order_.ranks.push_back(instance.order);
  if (!paged) return;
  for (const scene::Instance& instance : snapshot.instances)
    order_.numbers.push_back(reinterpret_cast<const uint32_t*>(instance.mesh->triangleNumbers.data));
}

void World::readImpostors(const scene::Snapshot& snapshot) {
  impostors_.clear();
  hasPixelImpostors_ = false;
  const auto& drawn = snapshot.instances;
  hasImpostors_ = std::any_of(drawn.begin(), drawn.end(), isImpostors);
  const size_t count = light_.exists() ? scene::countAll(snapshot) : drawn.size();
  for (size_t i = 0; i < count; ++i) {
    const scene::Instance& instance = scene::instanceOf(snapshot, i);
    if (!isImpostors(instance)) continue;
    impostors_.resize(count);
    PlacedImpostors& placed = impostors_[i] = PlacedImpostors(instance, snapshot.camera);
    if (!scene::isInWindow(placed.mesh->shape)) continue;
    placed.window = windowVertices(placed);
    hasPixelImpostors_ |= i < drawn.size();
  }
}

}  // namespace gluray::accel
