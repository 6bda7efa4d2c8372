#include "saved/shot/derived_camera.h"

#include "saved/shot/moved_view.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gluray::saved {
namespace {

constexpr double kEven = 1e-3;  // of lengths and angles that programs compute in floats

/// Whether the matrix turns, moves and scales, the same in all directions.
bool isSimilarity(const glm::dmat3& m) {
  const double scale = glm::length(m[0]);
  if (!(scale > 0 && std::isfinite(scale))) return false;
  const glm::dmat3 product = glm::transpose(m) * m / (scale * scale);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (std::abs(product[i][j] - (i == j ? 1 : 0)) > kEven) return false;
  return true;
}

/// Whether pixels are square, in a space that the camera is seen from.
bool isEven(const scene::Snapshot& batch, const glm::dmat4& clipFromSpace, const SeenCamera& seen) {
  const glm::dmat4 rows = glm::transpose(clipFromSpace);
  const auto across = [&](int row) {
    return std::abs(glm::dot(glm::dvec3(rows[row]), row ? seen.up : seen.right));
  };
  const double aspect = static_cast<double>(batch.camera.viewport.z) / std::max(batch.camera.viewport.w, 1);
  return isRectangular(seen) && std::abs(across(1) / across(0) / aspect - 1) < 2e-2;
}

/// A camera that sees so, with its focal point as deep as the middle of a ball.
ViewCamera cameraOf(const SeenCamera& seen, const glm::dvec3& middle, double radius) {
  ViewCamera camera;
  camera.up = seen.up;
  const double ahead = glm::dot(seen.position - middle, seen.back);
  if (seen.parallel) {
    camera.viewAngle = 0, camera.parallelScale = seen.halfHeight;
    camera.focalPoint = seen.position - ahead * seen.back;
    camera.position = camera.focalPoint + std::max(2 * radius, seen.halfHeight) * seen.back;
  } else {
    camera.viewAngle = glm::degrees(2 * std::atan(seen.halfHeight));
    camera.position = seen.position;
    camera.focalPoint = seen.position - std::max(ahead, 1e-3 * radius) * seen.back;
  }
  return camera;
}

/// In the object space of an instance.
std::optional<ViewCamera> cameraIn(const scene::Snapshot& batch, const scene::Instance& instance,
                                   const Box& box) {
  const glm::dmat4 clipFromObject = batch.camera.clipFromEye * instance.eyeFromObject;
  if (!isSimilarity(glm::dmat3(instance.eyeFromObject))) return std::nullopt;
  if (instance.lightingFromObject != glm::mat4(1) &&
      !isSimilarity(glm::dmat3(glm::dmat4(instance.lightingFromObject))))
    return std::nullopt;
  const auto seen = seenCamera(clipFromObject);
  if (!seen || !isEven(batch, clipFromObject, *seen)) return std::nullopt;
  const glm::dmat4 objectFromEye = glm::inverse(instance.eyeFromObject);
  const glm::dvec3 middle(objectFromEye * glm::dvec4(box.middle(), 1));
  const double radius = box.radius() / glm::length(glm::dvec3(instance.eyeFromObject[0]));
  return cameraOf(*seen, middle, radius);
}

/// In a space with the axes of an instance's, and the lengths of `own`, the space of the camera itself: where
/// objects are stretched along their axes, as VTK stretches the coordinates of buffers. `eyeFromOwn`: it.
std::optional<ViewCamera> cameraBeside(const scene::Snapshot& batch, const scene::Instance& instance,
                                       const glm::dmat4& eyeFromOwn, const Box& box) {
  const glm::dmat4 clipFromOwn = batch.camera.clipFromEye * eyeFromOwn, ownFromEye = glm::inverse(eyeFromOwn),
                   ownFromObject = ownFromEye * instance.eyeFromObject;
  glm::dmat3 axes(ownFromObject);
  for (int i = 0; i < 3; ++i) axes[i] = glm::normalize(axes[i]);
  const auto seen = seenCamera(clipFromOwn);
  if (!isSimilarity(axes) || glm::determinant(axes) < 0 || !seen || !isEven(batch, clipFromOwn, *seen))
    return std::nullopt;
  const glm::dmat3 turn = glm::transpose(axes);
  const glm::dvec3 origin(ownFromObject[3]);
  const SeenCamera there{seen->parallel,     turn * (seen->position - origin),
                         turn * seen->right, turn * seen->up,
                         turn * seen->back,  seen->halfHeight};
  const glm::dvec3 middle = turn * (glm::dvec3(ownFromEye * glm::dvec4(box.middle(), 1)) - origin);
  ViewCamera camera = cameraOf(there, middle, box.radius() * glm::length(glm::dvec3(ownFromEye[0])));
  if (!seen->parallel) return camera;
  // Its place along the line of sight is that of the space's origin.
  const glm::dvec3 place = turn * -origin;
  camera.position += glm::dot(place - camera.position, there.back) * there.back;
  camera.focalPoint = camera.position - std::max(glm::dot(place - middle, there.back), 1e-3) * there.back;
  return camera;
}

/// The instance's candidates, in the order in which they are tried.
std::vector<ViewCamera> camerasFor(const scene::Snapshot& batch, const scene::Instance& instance,
                                   const Box& box) {
  std::vector<ViewCamera> cameras;
  const auto add = [&](const std::optional<ViewCamera>& camera) {
    if (camera && cameraFromWorld(*camera)) cameras.push_back(*camera);
  };
  add(cameraIn(batch, instance, box));
  add(cameraBeside(batch, instance, glm::dmat4(1), box));
  if (instance.lightingFromObject != glm::mat4(1))
    add(cameraBeside(batch, instance,
                     instance.eyeFromObject * glm::inverse(glm::dmat4(instance.lightingFromObject)), box));
  return cameras;
}

std::optional<DerivedCamera> derivedFrom(const std::vector<scene::SnapshotPtr>& batches,
                                         const scene::Snapshot& batch) {
  const Box box = boxOfView(batch, batches);
  if (box.empty() || !(box.radius() > 0)) return std::nullopt;
  for (const scene::Instance& instance : batch.instances)
    for (const ViewCamera& camera : camerasFor(batch, instance, box)) try {
        DerivedCamera derived{camera, knownView(batches, {&camera, 1}, true)};
        const Box around = boxOfView(*derived.known.batch, batches);
        derived.middle =
            glm::dvec3(glm::inverse(derived.known.eyeFromWorld) * glm::dvec4(around.middle(), 1));
        derived.radius = around.radius() / glm::length(glm::dvec3(derived.known.eyeFromWorld[0]));
        return derived;
      } catch (const std::runtime_error&) {}  // another space may do
  return std::nullopt;
}

}  // namespace

std::optional<glm::dmat4> eyeFromEven(const scene::Snapshot& batch) {
  const auto isEvenIn = [&](const glm::dmat4& eyeFromSpace) {
    const glm::dmat4 clipFromSpace = batch.camera.clipFromEye * eyeFromSpace;
    const auto seen = seenCamera(clipFromSpace);
    return seen && isEven(batch, clipFromSpace, *seen);
  };
  for (const scene::Instance& instance : batch.instances) {
    if (instance.lightingFromObject == glm::mat4(1)) continue;
    const glm::dmat4 own = instance.eyeFromObject * glm::inverse(glm::dmat4(instance.lightingFromObject));
    if (!isSimilarity(glm::dmat3(own)) && isEvenIn(own)) return own;
  }
  return isEvenIn(glm::dmat4(1)) ? std::optional(glm::dmat4(1)) : std::nullopt;
}

std::optional<DerivedCamera> derivedCamera(const std::vector<scene::SnapshotPtr>& batches) {
  std::vector<scene::SnapshotPtr> largest = batches;
  const auto pixels = [](const scene::SnapshotPtr& s) {
    return int64_t{s->camera.viewport.z} * s->camera.viewport.w;
  };
  std::stable_sort(largest.begin(), largest.end(),
                   [&](const auto& a, const auto& b) { return pixels(a) > pixels(b); });
  for (const scene::SnapshotPtr& batch : largest)
    if (auto derived = derivedFrom(batches, *batch)) return derived;
  return std::nullopt;
}

}  // namespace gluray::saved
