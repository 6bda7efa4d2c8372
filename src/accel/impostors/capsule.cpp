#include "accel/impostors/capsule.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::accel {
namespace {

/// Part of a line, as shares of its length.
struct Part {
  double from = 0, to = 1;
  /// Keeps where a linear function, given at both ends, is at least 0.
  void keep(double first, double second) {
    if (first >= 0 && second >= 0) return;
    if (!(first >= 0 || second >= 0)) {
      from = 1, to = 0;
      return;
    }
    const double zero = first / (first - second);
    first < 0 ? from = std::max(from, zero) : to = std::min(to, zero);
  }
  bool empty() const { return !(from <= to); }
};

Part visiblePart(const PlacedImpostors& placed, const glm::vec4 (&end)[2], const float (&w)[2]) {
  Part part;
  for (const glm::vec4& plane : placed.look.centerPlanes)
    part.keep(glm::dot(glm::dvec4(plane), glm::dvec4(end[0])),
              glm::dot(glm::dvec4(plane), glm::dvec4(end[1])));
  if (placed.look.radius > 0) return part;
  if (!(w[0] > 0) || !(w[1] > 0))
    part.keep(glm::dot(placed.objectNear, end[0]), glm::dot(placed.objectNear, end[1]));
  return part;
}

/// Length and direction; in doubles where squares leave the range of floats.
float lengthOf(const glm::vec3& line, glm::vec3& direction) {
  const float squared = glm::dot(line, line);
  if (squared > 1e-30f && squared < 1e30f) {
    const float length = std::sqrt(squared);
    direction = line * (1 / length);
    return length;
  }
  const double length = glm::length(glm::dvec3(line));
  direction = glm::vec3(glm::dvec3(line) / length);
  return static_cast<float>(length);
}

/// The cone between the balls, or the larger ball alone.
void shape(Capsule& c) {
  glm::vec3 direction;
  const float length = lengthOf(c.end[1] - c.end[0], direction), sine = (c.radius[0] - c.radius[1]) / length;
  if (std::abs(sine) < 0.999f) {
    c.axis = direction, c.halfLength = 0.5f * length, c.sine = sine;
    return;
  }
  const int larger = c.radius[0] >= c.radius[1] ? 0 : 1;
  c.end[1 - larger] = c.end[larger], c.radius[1 - larger] = c.radius[larger];
  c.share[1 - larger] = c.share[larger];
}

}  // namespace

bool Capsule::make(const PlacedImpostors& placed, uint32_t primitive, Capsule& c) {
  const scene::Mesh& mesh = *placed.mesh;
  const glm::vec4 end[2] = {{mesh.position(mesh.corner(primitive, 0)), 1},
                            {mesh.position(mesh.corner(primitive, 1)), 1}};
  const bool line = mesh.shape == scene::Shape::capsules;
  if (line && end[0] == end[1]) return false;
  const float w[2] = {glm::dot(placed.objectW, end[0]), glm::dot(placed.objectW, end[1])};
  const auto perW = static_cast<float>(placed.halfWidthPerW);
  const bool pixels = !(placed.look.radius > 0);
  const auto put = [&](int k, float share, const glm::vec4& at, float clipW) {
    c.share[k] = share;
    c.end[k] = scene::impostorCenter(placed.lightingFromObject, at);
    c.radius[k] = pixels ? std::max(clipW, 0.0f) * perW : placed.look.radius;
  };
  c.axis = {0, 0, 1}, c.halfLength = c.sine = 0;
  if (placed.look.centerPlanes.empty() && (!pixels || (w[0] > 0 && w[1] > 0))) {
    for (int k = 0; k < 2; ++k) put(k, static_cast<float>(k), end[k], w[k]);
  } else {
    const Part part = visiblePart(placed, end, w);
    if (part.empty()) return false;
    for (int k = 0; k < 2; ++k) {
      const auto share = static_cast<float>(k == 0 ? part.from : part.to);
      const glm::vec4 at = glm::mix(end[0], end[1], share);
      put(k, share, at, glm::dot(placed.objectW, at));
    }
  }
  shape(c);
  return c.radius[0] > 0 || c.radius[1] > 0;
}

bool Capsule::holds(const glm::vec3& point) const {
  const glm::dvec3 line(axis), from = glm::dvec3(point) - 0.5 * (glm::dvec3(end[0]) + glm::dvec3(end[1]));
  const double half = halfLength, place = std::clamp(glm::dot(line, from), -half, half);
  const double reach =
      glm::mix(double{radius[0]}, double{radius[1]}, half > 0 ? 0.5 + 0.5 * place / half : 0.0);
  return glm::length(from - place * line) <= reach;
}

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// A line of sight, relative to the middle of a capsule and from the point nearest to that.
struct Sight {
  glm::dvec3 from, dir;
};

/// t at which it enters the ball about `center`; kNone: it misses.
double enterBall(const Sight& s, const glm::dvec3& center, double radius) {
  const glm::dvec3 from = s.from - center;
  const double t = -glm::dot(from, s.dir);
  const glm::dvec3 nearest = from + t * s.dir;
  const double d = radius * radius - glm::dot(nearest, nearest);
  return d >= 0 ? t - std::sqrt(d) : kNone;
}

/// A line of sight and the cone of a capsule, in coordinates along and across the axis.
struct Cone {
  double cosine, sine, start, along;
  glm::dvec3 axis, aside, across;

  Cone(const Sight& s, const Capsule& c)
      : cosine(std::sqrt(1 - double{c.sine} * c.sine)), sine(c.sine), axis(c.axis) {
    start = glm::dot(axis, s.from), along = glm::dot(axis, s.dir);
    aside = s.from - start * axis, across = s.dir - along * axis;
  }
  double nearest() const { return -glm::dot(aside, across) / std::max(glm::dot(across, across), 1e-30); }

  /// t at which the line meets the cone between the circles where it touches the balls; kNone: nowhere. The
  /// first root is where the line enters the whole capsule.
  struct Roots {
    double first = kNone, second = kNone;
  };
  Roots meet(const Capsule& c) const {
    const double slope = -sine / cosine, middle = 0.5 * (double{c.radius[0]} + c.radius[1]) / cosine;
    const double lowest = -double{c.halfLength} + c.radius[0] * sine,
                 highest = double{c.halfLength} + c.radius[1] * sine;
    const double a = glm::dot(across, across), s = nearest(), q = slope * along;
    const glm::dvec3 n = aside + s * across;
    const double n2 = glm::dot(n, n), radius = middle + slope * (start + s * along);
    const double discriminant = a * (radius * radius - n2) + q * q * n2;
    if (!(discriminant >= 0)) return {};
    const double root = std::sqrt(discriminant), scale = 1 / (a - q * q);
    const auto within = [&](double t) {
      const double place = start + t * along;
      return place >= lowest && place <= highest ? t : kNone;
    };
    const double one = within(s + (radius * q - root) * scale),
                 other = within(s + (radius * q + root) * scale);
    return scale > 0 ? Roots{one, other} : Roots{kNone, std::min(one, other)};
  }
};

}  // namespace

CapsulePoint see(const Capsule& c, const glm::dvec3& org, const glm::dvec3& dir) {
  const glm::dvec3 end[2] = {c.end[0], c.end[1]}, middle = 0.5 * (end[0] + end[1]);
  const Sight sight{org - middle - glm::dot(org - middle, dir) * dir, dir};
  const glm::dvec3 half = double{c.halfLength} * glm::dvec3(c.axis);
  double t = kNone;
  glm::dvec3 center(0);
  const auto meetBalls = [&] {
    const double first = enterBall(sight, -half, c.radius[0]), second = enterBall(sight, half, c.radius[1]);
    center = first <= second ? -half : half;
    return std::min(first, second);
  };
  if (c.isBall()) {
    t = meetBalls();
    if (t == kNone) t = 0;
  } else {
    const Cone cone(sight, c);
    const Cone::Roots roots = cone.meet(c);
    t = roots.first != kNone ? roots.first : std::min(meetBalls(), roots.second);
    if (t == kNone) t = cone.nearest();
    const double place = cone.start + t * cone.along;
    const double shifted = place - glm::length(cone.aside + t * cone.across) * cone.sine / cone.cosine;
    center = std::clamp(shifted, -double{c.halfLength}, double{c.halfLength}) * cone.axis;
  }
  const glm::dvec3 point = sight.from + t * dir;
  CapsulePoint p;
  p.point = point + middle;
  p.normal = glm::vec3(glm::normalize(point - center));
  p.cosine = static_cast<float>(-glm::dot(glm::dvec3(p.normal), dir));
  const double along = c.isBall() ? 0.0 : glm::dot(center, glm::dvec3(c.axis)) / c.halfLength;
  p.share = glm::mix(c.share[0], c.share[1], static_cast<float>(0.5 + 0.5 * along));
  return p;
}

}  // namespace gluray::accel
