#include "saved/shot/path_view.h"

#include "saved/shot/moved_view.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>

namespace gluray::saved {
namespace {

using scene::SnapshotPtr;

constexpr double kComputed = 1e-4;  // of matrices that programs compute in floats
constexpr double kWritten = 1e-3;   // of cameras that people write down

bool areNear(const glm::dvec3& a, const glm::dvec3& b, double within) { return glm::length(a - b) <= within; }

/// Whether the matrix comes from the camera's own space, with the world's lengths.
bool isOfCamera(const glm::dmat4& clipFromSpace, const ViewCamera& camera) {
  const auto seen = seenCamera(clipFromSpace);
  if (!seen || !areEquallyHigh(*seen, camera, kWritten) || !areNear(seen->right, {1, 0, 0}, kComputed) ||
      !areNear(seen->up, {0, 1, 0}, kComputed) || !areNear(seen->back, {0, 0, 1}, kComputed))
    return false;
  if (seen->parallel) return areEquallyHigh(*seen, camera, kComputed);
  const double unit = glm::length(glm::dvec3(glm::transpose(clipFromSpace)[3]));
  return std::abs(unit - 1) <= kComputed &&
         glm::length(seen->position) <= kComputed * glm::length(camera.position - camera.focalPoint);
}

/// A batch's eye space from the camera's own, where the program has that: it is eye space itself, or that of
/// its lighting.
std::optional<glm::dmat4> eyeFromCameraOf(const scene::Snapshot& batch, const ViewCamera& camera) {
  const glm::dmat4& clipFromEye = batch.camera.clipFromEye;
  if (isOfCamera(clipFromEye, camera)) return glm::dmat4(1);
  for (const scene::Instance& instance : batch.instances) {
    if (instance.lightingFromObject == glm::mat4(1)) continue;
    const glm::dmat4 own = instance.eyeFromObject * glm::inverse(glm::dmat4(instance.lightingFromObject));
    if (isOfCamera(clipFromEye * own, camera)) return own;
  }
  return std::nullopt;
}

/// Whether the axes of an object's space are those of the world that the camera stands in.
bool hasWorldAxes(const glm::dmat4& cameraFromObject, const ViewCamera& camera) {
  const glm::dmat3 world(*cameraFromWorld(camera)), object(cameraFromObject);
  for (int i = 0; i < 3; ++i)
    if (!areNear(glm::normalize(object[i]), world[i], kWritten)) return false;
  return true;
}

/// Whether both matrices put the camera's surroundings at the same place, in the same size.
bool areSame(const glm::dmat4& a, const glm::dmat4& b, const ViewCamera& camera) {
  const double size = glm::length(glm::dvec3(b[0])),
               distance = glm::length(camera.position - camera.focalPoint);
  for (int i = 0; i < 3; ++i)
    if (!areNear(a[i], b[i], kWritten * size)) return false;
  const glm::dvec4 focalPoint(camera.focalPoint, 1);
  return areNear(a * focalPoint, b * focalPoint, kWritten * size * distance);
}

/// Whether some surface's object space is the world in which the camera is that of the saved view.
std::optional<KnownView> foundIn(const SnapshotPtr& batch, const ViewCamera& camera) {
  const std::optional<glm::dmat4> own = eyeFromCameraOf(*batch, camera);
  for (const scene::Instance& instance : batch->instances) {
    const auto seen = seenCamera(batch->camera.clipFromEye * instance.eyeFromObject);
    if (!seen || !areAlike(*seen, camera, own ? kWritten : kComputed)) continue;
    const glm::dmat4 exact = own ? *own * *cameraFromWorld(camera) : instance.eyeFromObject;
    const bool isExact = areSame(exact, instance.eyeFromObject, camera);
    return KnownView{camera, batch, isExact ? exact : instance.eyeFromObject};
  }
  return std::nullopt;
}

std::string heightOf(bool parallel, double halfHeight) {
  char text[64];
  if (parallel)
    std::snprintf(text, sizeof text, "parallel scale %.6g", halfHeight);
  else
    std::snprintf(text, sizeof text, "view angle %.6g", glm::degrees(2 * std::atan(halfHeight)));
  return text;
}

[[noreturn]] void refuseStated(const std::vector<SnapshotPtr>& batches, const ViewCamera& camera) {
  for (const SnapshotPtr& batch : batches)
    if (const auto seen = seenCamera(batch->camera.clipFromEye);
        seen && isRectangular(*seen) && !areEquallyHigh(*seen, camera, kWritten))
      throw std::runtime_error("--saved-camera is not the camera of the saved view: it has " +
                               heightOf(camera.isParallel(), halfHeightOf(camera)) + ", the scene " +
                               heightOf(seen->parallel, seen->halfHeight));
  throw std::runtime_error(
      "--saved-camera is not the camera of the saved view: no surface of the scene is seen so");
}

}  // namespace

KnownView knownView(const std::vector<SnapshotPtr>& batches, std::span<const ViewCamera> cameras,
                    bool stated) {
  for (const ViewCamera& camera : cameras)
    if (!cameraFromWorld(camera))
      throw std::runtime_error("a camera of the path looks nowhere, or upwards along its line of sight");
  for (const SnapshotPtr& batch : batches)
    for (const ViewCamera& camera : cameras)
      if (const auto found = foundIn(batch, camera)) return *found;
  for (const SnapshotPtr& batch : stated ? batches : std::vector<SnapshotPtr>()) {
    const auto own = eyeFromCameraOf(*batch, cameras[0]);
    for (const scene::Instance& instance : batch->instances)
      if (own && hasWorldAxes(glm::inverse(*own) * instance.eyeFromObject, cameras[0]))
        return {cameras[0], batch, *own * *cameraFromWorld(cameras[0])};
  }
  if (stated) refuseStated(batches, cameras[0]);
  throw std::runtime_error(
      "the program's world space is not known: no camera of the path is that of the saved view; give it with "
      "--saved-camera FILE");
}

glm::dmat4 eyeFromWorld(const KnownView& known, const ViewCamera& camera) {
  const auto there = cameraFromWorld(camera), here = cameraFromWorld(known.camera);
  if (!there || !here)
    throw std::runtime_error("a camera of the path looks nowhere, or upwards along its line of sight");
  return known.eyeFromWorld * (glm::inverse(*here) * *there);
}

std::vector<SnapshotPtr> seenFrom(const std::vector<SnapshotPtr>& batches, const KnownView& known,
                                  const ViewCamera& camera) {
  const auto there = cameraFromWorld(camera), here = cameraFromWorld(known.camera);
  if (!there || !here)
    throw std::runtime_error("a camera of the path looks nowhere, or upwards along its line of sight");
  if (camera.isParallel() != known.camera.isParallel())
    throw std::runtime_error(camera.isParallel()
                                 ? "the path has a parallel projection, the saved view a perspective"
                                 : "the path has a perspective, the saved view a parallel projection");
  const double zoom = halfHeightOf(known.camera) / halfHeightOf(camera);
  if (!(zoom > 0 && std::isfinite(zoom))) throw std::runtime_error("a camera of the path sees nothing");
  const glm::dmat4 inWorld = glm::inverse(*here) * *there,
                   by = known.eyeFromWorld * inWorld * glm::inverse(known.eyeFromWorld);
  const glm::dmat3 turn = glm::dmat3(*there) * glm::transpose(glm::dmat3(*here));
  std::vector<SnapshotPtr> result;
  for (const SnapshotPtr& batch : batches) {
    glm::dmat4 ownFromKnown(1);
    if (sharesView(*batch, *known.batch, ownFromKnown)) {
      const glm::dmat4 own = ownFromKnown * by * glm::inverse(ownFromKnown);
      const glm::dvec3 ahead(ownFromKnown * known.eyeFromWorld * glm::dvec4(known.camera.focalPoint, 1));
      const Box box = boxOfView(*batch, batches, own);
      result.push_back(box.empty() ? batch : moved(*batch, own, box, Planes::tight, {zoom, ahead}));
      continue;
    }
    const auto eye = seenCamera(batch->camera.clipFromEye);
    const Box box = boxOfView(*batch, batches);
    if (!eye || !isRectangular(*eye))
      throw std::runtime_error("a part of the window has another camera that cannot follow the path");
    if (box.empty()) {
      result.push_back(batch);
      continue;
    }
    const glm::dmat3 axes(eye->right, eye->up, eye->back);
    const glm::dmat4 own = glm::translate(glm::dmat4(1), box.middle()) *
                           glm::dmat4(axes * turn * glm::transpose(axes)) *
                           glm::translate(glm::dmat4(1), -box.middle());
    result.push_back(moved(*batch, own, box, Planes::roomy));
  }
  return result;
}

}  // namespace gluray::saved
