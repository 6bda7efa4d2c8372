#include "saved/shot/path_view.h"

#include "saved/shot/moved_view.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace gluray::saved {
namespace {

using scene::SnapshotPtr;

/// Whether lengths of eye space are those of the world, as far as its projection shows.
bool hasUnit(const glm::dmat4& clipFromEye, const SeenCamera& eye) {
  if (eye.parallel) return true;  // the height of the view says so
  return std::abs(glm::length(glm::dvec3(glm::transpose(clipFromEye)[3])) - 1) <= 1e-3;
}

/// The eye space of a batch whose camera stands in the world as somebody says.
glm::dmat4 eyeFromWorldOf(const SeenCamera& eye, const ViewCamera& camera) {
  // Eye space may be turned and moved against the camera's own.
  const glm::dmat3 axes(eye.right, eye.up, eye.back);
  glm::dmat4 eyeFromCamera(axes);
  eyeFromCamera[3] = glm::dvec4(eye.position, 1);
  if (eye.parallel) {  // the viewer is anywhere on a line
    const double along = glm::dot(eye.position, eye.back);
    eyeFromCamera[3] -= glm::dvec4(along * eye.back, 0);
  }
  return eyeFromCamera * *cameraFromWorld(camera);
}

/// Whether the axes of an object's space are those of the world that the camera stands in.
bool hasWorldAxes(const SeenCamera& eye, const glm::dmat4& eyeFromObject, const ViewCamera& camera) {
  const glm::dmat3 axes(eye.right, eye.up, eye.back), world(*cameraFromWorld(camera)),
      object = glm::transpose(axes) * glm::dmat3(eyeFromObject);
  for (int i = 0; i < 3; ++i)
    if (!(glm::length(glm::normalize(object[i]) - world[i]) <= 1e-3)) return false;
  return true;
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
        seen && isRectangular(*seen) && !areEquallyHigh(*seen, camera))
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
    for (const scene::Instance& instance : batch->instances) {
      const auto seen = seenCamera(batch->camera.clipFromEye * instance.eyeFromObject);
      if (!seen) continue;
      for (const ViewCamera& camera : cameras)
        if (areAlike(*seen, camera)) return {camera, batch, instance.eyeFromObject};
    }
  for (const SnapshotPtr& batch : stated ? batches : std::vector<SnapshotPtr>()) {
    const auto eye = seenCamera(batch->camera.clipFromEye);
    if (!eye || !isRectangular(*eye) || !hasUnit(batch->camera.clipFromEye, *eye) ||
        !areEquallyHigh(*eye, cameras[0]))
      continue;
    for (const scene::Instance& instance : batch->instances)
      if (hasWorldAxes(*eye, instance.eyeFromObject, cameras[0]))
        return {cameras[0], batch, eyeFromWorldOf(*eye, cameras[0])};
  }
  if (stated) refuseStated(batches, cameras[0]);
  throw std::runtime_error(
      "the program's world space is not known: no camera of the path is that of the saved view; give it with "
      "--saved-camera FILE");
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
      const glm::dvec3 viewer(ownFromKnown * known.eyeFromWorld * glm::dvec4(known.camera.position, 1));
      const Box box = boxOfView(*batch, batches, own);
      result.push_back(box.empty() ? batch : moved(*batch, own, box, Planes::tight, {zoom, viewer}));
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
