#include "gl/views/view_changes.h"

#include "gl/batch/clears.h"
#include "gl/views/secondary_scene_builder.h"
#include "scene/box_corner.h"
#include "scene/mesh.h"
#include "scene/same_camera.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace gluray::gl {
namespace {

bool lookAlike(const scene::Shading& a, const scene::Shading& b) {
  if (a == b) return true;
  const auto unlit = [](scene::Shading shading) {
    shading.lights.clear(), shading.fragment.lights.clear();
    return shading;
  };
  return unlit(a) == unlit(b);
}

bool areAlike(const scene::Instance& a, const scene::Instance& b) {
  return a.mesh->geometryId == b.mesh->geometryId && areNear(a.eyeFromObject, b.eyeFromObject) &&
         a.clipPlanes.size() == b.clipPlanes.size() && a.color == b.color && a.materials == b.materials &&
         a.triangleColors == b.triangleColors && a.triangleOffset == b.triangleOffset && a.cull == b.cull &&
         a.frontFaceCcw == b.frontFaceCcw && a.impostors == b.impostors;
}

bool areAlike(const scene::PlacedVolume& a, const scene::PlacedVolume& b) {
  return (a.medium == b.medium || scene::blockAlike(*a.medium, *b.medium)) &&
         areNear(a.eyeFromData, b.eyeFromData);
}

/// Whether all that an instance shows lies in the box; false where that is not known.
bool isInside(const scene::Region& box, const scene::Camera& camera, const scene::Instance& instance) {
  const scene::Mesh& mesh = *instance.mesh;
  if (mesh.shape != scene::Shape::triangles) return false;  // larger than their points
  const glm::dmat4 clipFromObject = camera.clipFromEye * instance.eyeFromObject;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 clip = clipFromObject * glm::dvec4(scene::boxCorner(mesh.lower, mesh.upper, corner), 1);
    if (!(clip.w > 0)) return false;
    const glm::dvec2 window =
        glm::dvec2(camera.viewport) +
        (glm::dvec2(clip) / clip.w + 1.0) / 2.0 * glm::dvec2(camera.viewport.z, camera.viewport.w);
    const bool inside = window.x >= box.x && window.y >= box.y && window.x <= box.x + box.width &&
                        window.y <= box.y + box.height;
    if (!inside) return false;
  }
  return true;
}

}  // namespace

bool lightAlike(const scene::SecondaryScene* a, const scene::SecondaryScene* b) {
  if (!a || !b) return !a && !b;
  const auto sameVolume = [](const auto& x, const auto& y) { return areAlike(x, y); };
  if (!std::equal(a->volumes.begin(), a->volumes.end(), b->volumes.begin(), b->volumes.end(), sameVolume))
    return false;
  if (a->instances.size() != b->instances.size() || a->blended != b->blended || !haveSameCaptures(*a, *b))
    return false;
  for (size_t i = 0; i < a->instances.size(); ++i)
    if (!areAlike(a->instances[i], b->instances[i]) ||
        !lookAlike(a->shadings[a->instances[i].shading], b->shadings[b->instances[i].shading]))
      return false;
  return true;
}

scene::SnapshotPtr relitOf(const ViewEpoch& epoch, size_t batch, const SceneExtents& extents) {
  const ViewEpoch::Drawn& drawn = epoch.batches[batch];
  const scene::SnapshotPtr& before = drawn.snapshot;
  const bool loses = std::any_of(drawn.erased.begin(), drawn.erased.end(), [](uint8_t e) { return e != 0; });
  if (epoch.batches.size() == 1 && !before->secondaryScene && !loses) return before;
  std::shared_ptr<scene::Snapshot> relit;
  if (loses) {
    relit = std::make_shared<scene::Snapshot>(*before);
    size_t next = 0;
    std::erase_if(relit->instances, [&](const scene::Instance&) { return drawn.erased[next++] != 0; });
    if (relit->instances.empty()) return before;
  }
  SecondarySceneBuilder maker(relit ? *relit : *before);
  for (size_t i = 0; i < epoch.batches.size(); ++i) {
    const ViewEpoch::Drawn& other = epoch.batches[i];
    const auto eyeFromPart = i == batch ? std::nullopt : eyeFromEye(*before, *other.snapshot);
    if (eyeFromPart) maker.add(*other.snapshot, *eyeFromPart, other.capture, other.erased);
  }
  const scene::SecondaryScene* const known = before->secondaryScene.get();
  auto secondary = maker.takeSecondaryScene(known ? known->viewFromWorld : glm::dmat4(1));
  if (!loses && lightAlike(known, secondary.get())) return before;
  if (!relit) relit = std::make_shared<scene::Snapshot>(*before);
  relit->secondaryScene = std::move(secondary);
  relit->extent = extents.extentOf(*relit);
  return relit;
}

void eraseSurfaces(ViewEpoch& epoch, const scene::Region& box) {
  for (ViewEpoch::Drawn& drawn : epoch.batches) {
    const scene::Snapshot& s = *drawn.snapshot;
    if (!s.volumes.empty() && contains(box, s.region)) {
      auto erased = std::make_shared<scene::Snapshot>(s);
      erased->volumes.clear();
      drawn.snapshot = std::move(erased), epoch.isChecked = false;
      continue;
    }
    for (size_t i = 0; i < s.instances.size(); ++i) {
      if (!isInside(box, s.camera, s.instances[i])) continue;
      drawn.erased.resize(s.instances.size());
      epoch.isChecked = epoch.isChecked && drawn.erased[i];
      drawn.erased[i] = 1;
    }
  }
}

}  // namespace gluray::gl
