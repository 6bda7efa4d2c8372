#include "accel/impostors/stick.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::accel {
namespace {

Stick::End endKind(uint32_t bits, const scene::Impostors& look) {
  if (!(bits & scene::kClosedEnd)) return Stick::End::open;
  return bits & scene::kRoundEnd && look.roundEnds ? Stick::End::round : Stick::End::flat;
}

/// A line relative to the middle of a stick, from the point nearest to that, in coordinates along and across
/// the axis.
struct StickLine {
  glm::dvec3 axis, from, dir, aside, across;
  double nearest;  // t of `from` on the whole line, for a direction of unit length
  double start, along;

  StickLine(const Stick& s, const glm::dvec3& org, const glm::dvec3& unit) : axis(s.axis), dir(unit) {
    const glm::dvec3 relative = org - 0.5 * (glm::dvec3(s.end[0]) + glm::dvec3(s.end[1]));
    nearest = -glm::dot(relative, dir);
    from = relative + nearest * dir;
    start = glm::dot(axis, from), along = glm::dot(axis, dir);
    aside = from - start * axis, across = dir - along * axis;
  }
  glm::dvec3 at(double t) const { return from + t * dir; }
  double placeAt(double t) const { return start + t * along; }
};

/// A part of a line; enter > leave: nothing.
struct Span {
  double enter = std::numeric_limits<double>::infinity(), leave = -enter;
  bool empty() const { return !(enter <= leave); }
};

/// Within the endless cylinder. A line that misses it gets its point nearest to the axis if `always`.
Span spanInCylinder(const StickLine& l, double radius, bool always) {
  const double a = std::max(glm::dot(l.across, l.across), 1e-30);
  const double middle = -glm::dot(l.aside, l.across) / a;
  const glm::dvec3 closest = l.aside + middle * l.across;
  const double d = radius * radius - glm::dot(closest, closest);
  if (!(d >= 0) && !always) return {};
  const double half = std::sqrt(std::max(d, 0.0) / a);
  return {middle - half, middle + half};
}

Span spanInBall(const StickLine& l, const glm::dvec3& center, double radius, bool always) {
  const glm::dvec3 to = l.from - center;
  const double middle = -glm::dot(to, l.dir);
  const glm::dvec3 closest = to + middle * l.dir;
  const double d = radius * radius - glm::dot(closest, closest);
  if (!(d >= 0) && !always) return {};
  const double half = std::sqrt(std::max(d, 0.0));
  return {middle - half, middle + half};
}

}  // namespace

bool Stick::make(const PlacedImpostors& placed, uint32_t primitive, Stick& s) {
  const scene::Mesh& mesh = *placed.mesh;
  uint32_t bits[2];
  glm::vec3 object[2];
  for (uint32_t k = 0; k < 2; ++k) {
    const uint32_t vertex = mesh.corner(primitive, k);
    object[k] = mesh.position(vertex);
    s.end[k] = scene::impostorCenter(placed.lightingFromObject, object[k]);
    bits[k] = mesh.endAt(vertex);
    s.ends[k] = endKind(bits[k], placed.look);
  }
  s.halves = (bits[0] & scene::kTwoHalves) != 0;
  const uint32_t first = mesh.corner(primitive, 0);
  s.radius = (mesh.radii ? scene::fetch(mesh.radii, first).x : mesh.radius) / placed.look.radiusDivisor;
  const glm::dvec3 line =
      glm::dmat3(glm::mat3(placed.lightingFromObject)) * (glm::dvec3(object[1]) - glm::dvec3(object[0]));
  const double length = glm::length(line);
  s.axis = glm::vec3(line / length);
  s.halfLength = static_cast<float>(0.5 * length);
  return s.halfLength > 0 && std::isfinite(s.halfLength) && s.radius > 0;
}

StickPoint see(const Stick& s, const glm::dvec3& org, const glm::dvec3& dir) {
  const StickLine line(s, org, dir);
  const double half = s.halfLength, radius = s.radius;
  double t = spanInCylinder(line, radius, true).enter;
  const double place = line.placeAt(t);
  const glm::dvec3 middle = 0.5 * (glm::dvec3(s.end[0]) + glm::dvec3(s.end[1]));
  StickPoint p;
  p.share = std::clamp(0.5 + 0.5 * place / half, 0.0, 1.0);
  p.enterZ = (middle + line.at(t)).z;
  p.normal = glm::vec3(glm::normalize(line.aside + t * line.across));
  if (std::abs(place) > half) {
    const int k = place < 0 ? 0 : 1;
    const double side = k == 0 ? -1 : 1;
    if (s.ends[k] == Stick::End::round) {
      const glm::dvec3 center = side * half * line.axis;
      t = spanInBall(line, center, radius, true).enter;
      p.normal = glm::vec3(glm::normalize(line.at(t) - center));
    } else if (s.ends[k] == Stick::End::flat && line.along != 0) {
      t = (side * half - line.start) / line.along;
      p.normal = glm::vec3(side * line.axis);
    }
  }
  p.point = middle + line.at(t);
  return p;
}

std::optional<StickHit> meetSolid(const Stick& s, const glm::dvec3& org, const glm::dvec3& dir, double tNear,
                                  double tFar) {
  const double length = glm::length(dir), half = s.halfLength, radius = s.radius;
  const StickLine line(s, org, dir / length);
  // The stick is convex: of all points on its parts, the first and the last are on its surface.
  Span body = spanInCylinder(line, radius, false);
  if (body.empty()) return std::nullopt;
  if (line.along != 0) {
    const double one = (-half - line.start) / line.along, other = (half - line.start) / line.along;
    body = {std::max(body.enter, std::min(one, other)), std::min(body.leave, std::max(one, other))};
  } else if (std::abs(line.start) > half) {
    body = {};
  }
  Span whole = body.empty() ? Span{} : body;
  for (int k = 0; k < 2; ++k) {
    if (s.ends[k] != Stick::End::round) continue;
    const glm::dvec3 center = (k == 0 ? -half : half) * line.axis;
    const Span ball = spanInBall(line, center, radius, false);
    if (ball.empty()) continue;
    whole = {std::min(whole.enter, ball.enter), std::max(whole.leave, ball.leave)};
  }
  if (whole.empty()) return std::nullopt;
  for (const double t : {whole.enter, whole.leave}) {
    const double there = (t + line.nearest) / length;
    if (!(there >= tNear && there <= tFar)) continue;
    const double place = line.placeAt(t), side = place < 0 ? -1 : 1;
    const glm::dvec3 out = line.aside + t * line.across;
    if (s.ends[place < 0 ? 0 : 1] == Stick::End::round)
      return StickHit{there, std::abs(place) > half ? line.at(t) - side * half * line.axis : out};
    const bool onEnd =
        std::abs(std::abs(place) - half) < 1e-6 * half && glm::dot(out, out) < radius * radius * (1 - 1e-6);
    return StickHit{there, onEnd ? side * line.axis : out};
  }
  return std::nullopt;
}

}  // namespace gluray::accel
