#include "saved/shot/turned_view.h"

#include "scene/same_camera.h"
#include "scene/secondary_scene.h"
#include "scene/upward_axis.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace gluray::saved {
namespace {

using scene::Snapshot, scene::SnapshotPtr;

/// A box in eye space; empty at first.
struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
  void add(const glm::dvec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
  bool empty() const { return !(low.x <= high.x); }
  glm::dvec3 middle() const { return (low + high) / 2.0; }
  double radius() const { return glm::length(high - low) / 2; }
};

void add(const Snapshot& s, const glm::dmat4& eyeFromEye, Box& box) {
  for (const scene::Instance& instance : s.instances) {
    const glm::dvec3 low(instance.mesh->lower), high(instance.mesh->upper);
    if (!(low.x <= high.x)) continue;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                         corner & 4 ? high.z : low.z);
      box.add(glm::dvec3(eyeFromEye * instance.eyeFromObject * glm::dvec4(p, 1)));
    }
  }
}

/// Moves the near and far planes of a projection, so that a ball lies between.
void makeRoom(const glm::dvec3& middle, double radius, glm::dmat4& clipFromEye) {
  glm::dmat4 rows = glm::transpose(clipFromEye);
  glm::dvec4 &z = rows[2], &w = rows[3];
  const double length = glm::length(glm::dvec3(w));
  if (length == 0) {  // parallel
    const double at = glm::dot(z, glm::dvec4(middle, 1)), reach = glm::length(glm::dvec3(z)) * radius;
    const double low = std::min(-w.w, at - reach), high = std::max(w.w, at + reach);
    z = (2.0 * z - glm::dvec4(0, 0, 0, high + low)) * (w.w / (high - low));
  } else {
    // Depth z / w is a + b / w in terms of the distance w along the line of sight.
    const double a = glm::dot(glm::dvec3(z), glm::dvec3(w)) / (length * length), b = z.w - a * w.w;
    const double at = glm::dot(w, glm::dvec4(middle, 1)), reach = length * radius;
    const double far = std::max(at + reach, b / (1 - a)),
                 near = std::min(-b / (1 + a), std::max(at - reach, far * 1e-4));
    if (!(near > 0 && near < far && std::isfinite(far))) return;
    z = w * ((far + near) / (far - near)) + glm::dvec4(0, 0, 0, -2 * far * near / (far - near));
  }
  clipFromEye = glm::transpose(rows);
}

/// Turns instances that stand in the eye space of a snapshot. The spaces of their lighting and of their
/// normals may be others: both are reached from object space.
void turn(const glm::dmat4& by, std::vector<scene::Instance>& instances) {
  const glm::dmat4 planes = glm::transpose(glm::inverse(by));
  for (scene::Instance& instance : instances) {
    const glm::dmat4 eyeFromObject = instance.eyeFromObject,
                     inObject = glm::inverse(eyeFromObject) * by * eyeFromObject;
    const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(inObject)));
    instance.eyeFromObject = by * eyeFromObject;
    // The identity says that a program has no such matrix, and lights surfaces by their normals alone.
    const bool byNormals =
        instance.mesh->shape == scene::Shape::triangles && instance.lightingFromObject == glm::mat4(1);
    if (!byNormals)
      instance.lightingFromObject = glm::mat4(glm::dmat4(instance.lightingFromObject) * inObject);
    instance.normalMatrix = glm::mat3(glm::dmat3(instance.normalMatrix) * normals);
    for (glm::dvec4& plane : instance.clipPlanes) plane = planes * plane;
  }
}

SnapshotPtr turnedBy(const Snapshot& given, const glm::dmat4& by, const Box& box) {
  auto s = std::make_shared<Snapshot>(given);
  s->eyeFromWorld = by * s->eyeFromWorld;
  turn(by, s->instances);
  makeRoom(box.middle(), box.radius(), s->camera.clipFromEye);
  if (s->secondaryScene) {
    auto around = std::make_shared<scene::SecondaryScene>(*s->secondaryScene);
    turn(by, around->instances);
    around->captured.clear(), around->captures.clear(), around->framebuffer.reset();
    s->secondaryScene = std::move(around);
  }
  return s;
}

}  // namespace

std::vector<SnapshotPtr> turned(const std::vector<SnapshotPtr>& batches, double degrees) {
  std::vector<SnapshotPtr> result;
  std::optional<glm::dvec3> axis;
  for (const SnapshotPtr& batch : batches) {
    if (!axis) {
      glm::dvec3 up(0);
      up[scene::upwardAxis(batch->settings)] = 1;
      axis = glm::normalize(glm::dmat3(batch->eyeFromWorld) * up);
    }
    Box box;
    for (const SnapshotPtr& other : batches) {
      const bool alike = other->camera.viewport == batch->camera.viewport;
      if (const auto from = alike ? scene::eyeFromEye(*batch, *other) : std::nullopt) add(*other, *from, box);
    }
    if (box.empty()) {
      result.push_back(batch);
      continue;
    }
    // The camera goes to the right where the scene turns to the left.
    const glm::dmat4 there = glm::translate(glm::dmat4(1), box.middle()),
                     back = glm::translate(glm::dmat4(1), -box.middle()),
                     by = there * glm::rotate(glm::dmat4(1), glm::radians(-degrees), *axis) * back;
    result.push_back(turnedBy(*batch, by, box));
  }
  return result;
}

}  // namespace gluray::saved
