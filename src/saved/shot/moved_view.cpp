#include "saved/shot/moved_view.h"

#include "scene/same_camera.h"
#include "scene/secondary_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace gluray::saved {
namespace {

using scene::Snapshot, scene::SnapshotPtr;

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

constexpr double kNearest = 1e-4;  // of the near plane, by the distance of the far one

/// Moves the near and far planes of a projection to where a ball lies between.
void makeRoom(const glm::dvec3& middle, double radius, Planes planes, glm::dmat4& clipFromEye) {
  const bool roomy = planes == Planes::roomy;
  glm::dmat4 rows = glm::transpose(clipFromEye);
  glm::dvec4 &z = rows[2], &w = rows[3];
  const double length = glm::length(glm::dvec3(w));
  if (length == 0) {  // parallel
    const double at = glm::dot(z, glm::dvec4(middle, 1)), reach = glm::length(glm::dvec3(z)) * radius;
    const double low = roomy ? std::min(-w.w, at - reach) : at - reach,
                 high = roomy ? std::max(w.w, at + reach) : at + reach;
    if (!(low < high)) return;
    z = (2.0 * z - glm::dvec4(0, 0, 0, high + low)) * (w.w / (high - low));
  } else {
    // Depth z / w is a + b / w in terms of the distance w along the line of sight.
    const double a = glm::dot(glm::dvec3(z), glm::dvec3(w)) / (length * length), b = z.w - a * w.w;
    const double at = glm::dot(w, glm::dvec4(middle, 1)), reach = length * radius;
    const double far = roomy ? std::max(at + reach, b / (1 - a)) : at + reach,
                 close = std::max(at - reach, far * kNearest),
                 near = roomy ? std::min(-b / (1 + a), close) : close;
    if (!(near > 0 && near < far && std::isfinite(far))) return;
    z = w * ((far + near) / (far - near)) + glm::dvec4(0, 0, 0, -2 * far * near / (far - near));
  }
  clipFromEye = glm::transpose(rows);
}

/// Enlarges what a projection shows about the line of sight of its middle.
void enlarge(const Zoom& zoom, glm::dmat4& clipFromEye) {
  if (zoom.factor == 1) return;
  glm::dmat4 rows = glm::transpose(clipFromEye);
  const glm::dvec4 ahead(zoom.ahead, 1);
  for (int i = 0; i < 2; ++i) {
    const glm::dvec4 middle = glm::dot(rows[i], ahead) / glm::dot(rows[3], ahead) * rows[3];
    rows[i] = middle + zoom.factor * (rows[i] - middle);
  }
  clipFromEye = glm::transpose(rows);
}

/// What impostors have of the projection follows it.
void follow(const glm::dmat4& before, const glm::dmat4& now, double zoom,
            std::vector<scene::Instance>& instances) {
  const glm::dmat4 rows = glm::transpose(now);
  const glm::dvec3 z(rows[2]), w(rows[3]);
  const double longer = glm::length(z) / glm::length(glm::dvec3(glm::transpose(before)[2]));
  for (scene::Instance& instance : instances) {
    scene::Impostors& i = instance.impostors;
    const bool sized = scene::isSizedInPixels(instance.mesh->shape);
    if (instance.mesh->shape == scene::Shape::splats) i.size *= static_cast<float>(zoom);
    if (!sized || i.bulge == 0) continue;
    i.bulge = static_cast<float>(i.bulge / zoom);
    i.bulgeDepth = static_cast<float>(i.parallelView ? i.bulgeDepth * longer
                                                     : 0.5 * (glm::dot(z, w) / glm::dot(w, w)) + 0.5);
  }
}

/// Moves instances that stand in the eye space of a snapshot. The spaces of their lighting and of their
/// normals may be others: both are reached from object space.
void move(const glm::dmat4& by, std::vector<scene::Instance>& instances) {
  const glm::dmat4 planes = glm::transpose(glm::inverse(by));
  for (scene::Instance& instance : instances) {
    const glm::dmat4 eyeFromObject = instance.eyeFromObject,
                     inObject = glm::inverse(eyeFromObject) * by * eyeFromObject;
    instance.eyeFromObject = by * eyeFromObject;
    // The identity says that a program has no such matrix, and lights surfaces by their normals alone.
    const bool byNormals =
        instance.mesh->shape == scene::Shape::triangles && instance.lightingFromObject == glm::mat4(1);
    const glm::dmat4 lighting(instance.lightingFromObject);
    glm::dmat3 normals(instance.normalMatrix);
    if (byNormals) {
      normals = normals * glm::transpose(glm::inverse(glm::dmat3(inObject)));
    } else {
      // Positions may be scaled against normals: these turn where lights are.
      const glm::dmat3 turn(lighting * inObject * glm::inverse(lighting));
      normals = glm::transpose(glm::inverse(turn)) * normals;
      instance.impostors.axisMatrix = glm::mat3(turn * glm::dmat3(instance.impostors.axisMatrix));
      instance.lightingFromObject = glm::mat4(lighting * inObject);
    }
    instance.normalMatrix = glm::mat3(normals);
    for (glm::dvec4& plane : instance.clipPlanes) plane = planes * plane;
  }
}

}  // namespace

bool sharesView(const Snapshot& own, const Snapshot& other, glm::dmat4& eyeFromEye) {
  if (other.camera.viewport != own.camera.viewport) return false;
  const std::optional<glm::dmat4> from = scene::eyeFromEye(own, other);
  if (from) eyeFromEye = *from;
  return from.has_value();
}

Box boxOfView(const Snapshot& own, const std::vector<SnapshotPtr>& batches, const glm::dmat4& by) {
  Box box;
  for (const SnapshotPtr& other : batches)
    if (glm::dmat4 from(1); sharesView(own, *other, from)) add(*other, by * from, box);
  return box;
}

SnapshotPtr moved(const Snapshot& batch, const glm::dmat4& by, const Box& box, Planes planes,
                  const Zoom& zoom) {
  auto s = std::make_shared<Snapshot>(batch);
  s->eyeFromWorld = by * s->eyeFromWorld;
  move(by, s->instances);
  enlarge(zoom, s->camera.clipFromEye);
  makeRoom(box.middle(), box.radius(), planes, s->camera.clipFromEye);
  const bool follows = s->camera.clipFromEye != batch.camera.clipFromEye;
  if (follows) follow(batch.camera.clipFromEye, s->camera.clipFromEye, zoom.factor, s->instances);
  if (s->secondaryScene) {
    auto around = std::make_shared<scene::SecondaryScene>(*s->secondaryScene);
    move(by, around->instances);
    if (follows) follow(batch.camera.clipFromEye, s->camera.clipFromEye, zoom.factor, around->instances);
    around->captured.clear(), around->captures.clear(), around->framebuffer.reset();
    s->secondaryScene = std::move(around);
  }
  return s;
}

}  // namespace gluray::saved
