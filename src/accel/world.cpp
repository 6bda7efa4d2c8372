#include "accel/world.h"

#include "accel/embree.h"
#include "accel/error.h"
#include "accel/impostors/pixel_impostor.h"
#include "base/log.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace gluray::accel {
namespace {

// Whether a transform is affine and invertible: rays are transformed into an instance by its inverse.
bool placeable(const glm::mat4& m) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      if (!std::isfinite(m[c][r])) return false;
    }
  }
  if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1) return false;
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
  const double volume = std::abs(glm::dot(glm::cross(x, y), z));
  return volume > 1e-6 * glm::length(x) * glm::length(y) * glm::length(z) && volume > 1e-36;
}

/// Largest absolute value of an element.
double largest(const glm::dvec3& v) {
  const glm::dvec3 size = glm::abs(v);
  return std::max({size.x, size.y, size.z});
}
double largest(const glm::dmat3& m) { return std::max({largest(m[0]), largest(m[1]), largest(m[2])}); }

/// Whether two affine transforms differ by at most `linear` per element, `along` in translations.
bool isNear(const glm::mat4& a, const glm::mat4& b, double linear, double along) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 3; ++r)
      if (!(std::abs(double{a[c][r]} - double{b[c][r]}) <= (c < 3 ? linear : along))) return false;
  return true;
}

}  // namespace

World::World(size_t idleBudgetBytes, FreeMemory freeMemory)
    : cache_(device_, idleBudgetBytes, freeMemory), tlas_(device_) {}

UpdateStatistics World::update(const scene::Snapshot& snapshot, Arena& arena) {
  return arena.execute([&] {
    UpdateStatistics statistics;
    const uint64_t before = cache_.builds();
    const uint64_t refits = cache_.refits(), refined = cache_.refinements();
    scene_ = nullptr;
    cache_.beginBatch(snapshot.frame);
    std::vector<PlacedBlas> placed = place(snapshot);
    statistics.blasBuilds = cache_.builds() - before;
    statistics.blasRefits = cache_.refits() - refits;
    statistics.blasRefinements = cache_.refinements() - refined;

    const auto filled = [](const PlacedBlas& p) { return p.blas != nullptr; };
    const auto first = std::find_if(placed.begin(), placed.end(), filled);
    const bool empty = first == placed.end();
    const bool lone = !empty && std::none_of(first + 1, placed.end(), filled);
    alone_ = nullptr;
    if (lone && first->worldFromObject == glm::mat4(1)) {
      alone_ = first->blas;
      aloneIndex_ = static_cast<uint32_t>(first - placed.begin());
      scene_ = alone_->scene();
    } else if (!empty) {
      const bool stay = stayPlaced(snapshot, placed);
      if (!stay && tlas_.update(std::move(placed))) statistics.tlasBuilds = 1, apart_ = false;
      scene_ = tlas_.scene();
    }
    cache_.evict();
    if (scene_) readBounds();
    readOrder(snapshot);
    readImpostors(snapshot);
    return statistics;
  });
}

std::vector<PlacedBlas> World::place(const scene::Snapshot& snapshot) {
  std::vector<Geometry> meshes;
  meshes.reserve(snapshot.instances.size());
  for (const scene::Instance& instance : snapshot.instances) {
    meshes.push_back({instance.mesh.get(), {}});
    if (instance.mesh->shape != scene::Shape::triangles)
      meshes.back().reach = ImpostorReach::of(instance, snapshot.camera);
  }

  std::vector<BlasPtr> blases = structures(meshes, snapshot.settings.bvh);
  std::vector<PlacedBlas> placed(blases.size());
  for (size_t i = 0; i < blases.size(); ++i) {
    placed[i] = {std::move(blases[i]), snapshot.instances[i].worldFromObject};
    if (placed[i].blas && !placeable(placed[i].worldFromObject)) {
      throw Error("instance " + std::to_string(i) + " has a transform that cannot be inverted");
    }
  }
  return placed;
}

std::vector<BlasPtr> World::structures(const std::vector<Geometry>& meshes, BvhQuality quality) {
  try {
    return cache_.get(meshes, quality);
  } catch (const std::exception&) {
    // Free idle structures and retry, before building coarser structures or failing.
    if (cache_.evictAllIdle()) try {
        return cache_.get(meshes, quality);
      } catch (const std::exception&) {}
    if (!cache_.thriftHelps(meshes, quality)) throw;
  }
  log::once(log::Level::warning, "thrift",
            "memory has run out: large meshes are traced in coarser structures (see --bvh), somewhat slower");
  return cache_.get(meshes, quality, true);
}

/// OpenGL stores the product of camera and instance transform as floats. The instance transforms recovered
/// from it vary from frame to frame by rounding, about a thousandth of a pixel. Without this check, a moving
/// camera would rebuild the TLAS. All instances stay or none: coincident surfaces must not separate.
bool World::stayPlaced(const scene::Snapshot& snapshot, const std::vector<PlacedBlas>& placed) const {
  constexpr double kRounded = 0x1p-22;  // of the largest element: twice the spacing of floats
  const std::vector<PlacedBlas>& held = tlas_.held();
  if (held.size() != placed.size()) return false;
  const double camera = largest(glm::dvec3(snapshot.eyeFromWorld[3]));
  const double back = 3 * largest(glm::inverse(glm::dmat3(snapshot.eyeFromWorld)));
  for (size_t i = 0; i < placed.size(); ++i) {
    if (placed[i] == held[i]) continue;
    if (placed[i].blas != held[i].blas) return false;
    const glm::dmat4& inEye = snapshot.instances[i].eyeFromObject;
    const double linear = kRounded * back * largest(glm::dmat3(inEye));
    const double along = kRounded * back * (camera + largest(glm::dvec3(inEye[3])));
    if (!isNear(placed[i].worldFromObject, held[i].worldFromObject, linear, along)) return false;
  }
  return true;
}

void World::readBounds() {
  RTCBounds bounds;
  rtcGetSceneBounds(scene_, &bounds);
  lower_ = {bounds.lower_x, bounds.lower_y, bounds.lower_z};
  upper_ = {bounds.upper_x, bounds.upper_y, bounds.upper_z};
  // A mesh whose triangles were all left out has no bounds: nothing to hit.
  if (!(lower_.x <= upper_.x && lower_.y <= upper_.y && lower_.z <= upper_.z)) scene_ = nullptr;
}

void World::readOrder(const scene::Snapshot& snapshot) {
  // Programs draw points and lines that cells share once per cell, each in its own colour; splats are flat
  // and overlap at equal distance.
  const auto repeated = [](const scene::Instance& i) {
    return scene::isInWindow(i.mesh->shape) || scene::isSolid(i.mesh->shape);
  };
  const bool known = !alone_ && apart_;
  mayCoincide_ = !known && (coincidence_.possible(snapshot.instances) ||
                            std::any_of(snapshot.instances.begin(), snapshot.instances.end(), repeated));
  if (!alone_) apart_ = !mayCoincide_;
  order_.laterWins = snapshot.laterWins;
  order_.ranks.clear();
  if (!mayCoincide_) return;
  for (const scene::Instance& instance : snapshot.instances) order_.ranks.push_back(instance.order);
}

void World::readImpostors(const scene::Snapshot& snapshot) {
  impostors_.clear();
  hasPixelImpostors_ = false;
  const auto isImpostors = [](const scene::Instance& i) { return i.mesh->shape != scene::Shape::triangles; };
  if (std::none_of(snapshot.instances.begin(), snapshot.instances.end(), isImpostors)) return;
  impostors_.resize(snapshot.instances.size());
  for (size_t i = 0; i < impostors_.size(); ++i)
    if (isImpostors(snapshot.instances[i]))
      impostors_[i] = PlacedImpostors(snapshot.instances[i], snapshot.camera);
  for (PlacedImpostors& placed : impostors_) {
    if (!placed.mesh || !scene::isInWindow(placed.mesh->shape)) continue;
    placed.window = windowVertices(placed);
    hasPixelImpostors_ = true;
  }
}

}  // namespace gluray::accel
