#include "accel/impostors/solid.h"

#include "accel/impostors/capsule.h"
#include "accel/impostors/solid_guess.h"
#include "accel/impostors/stick.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::accel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A ray in the space of a solid, and the part of it that is asked about.
struct Ray {
  glm::dvec3 org, dir;
  double tNear, tFar;
  bool leaves = true;  // whether it meets a solid that it starts in where it leaves it
  glm::dvec3 at(double t) const { return org + t * dir; }
  bool holds(double t) const { return t >= tNear && t <= tFar; }
};

/// Where a ray enters a convex solid and where it leaves it; enter > leave: nowhere.
struct Interval {
  double enter = -kInfinity, leave = kInfinity;
  bool empty() const { return !(enter <= leave); }
  void cut(const Interval& other) {
    enter = std::max(enter, other.enter), leave = std::min(leave, other.leave);
  }
};
constexpr Interval kNowhere{kInfinity, -kInfinity};

/// a t^2 + 2 b t + c <= 0, a > 0.
Interval solved(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0) || !(a > 0)) return kNowhere;
  const double root = std::sqrt(discriminant);
  return {(-b - root) / a, (-b + root) / a};
}

/// The ray within a ball. Measured from the point nearest to the centre, so that far origins lose no digits.
Interval inBall(const Ray& ray, const glm::dvec3& center, double radius) {
  const glm::dvec3 from = ray.org - center;
  const double a = glm::dot(ray.dir, ray.dir), nearest = -glm::dot(from, ray.dir) / a;
  const glm::dvec3 aside = from + nearest * ray.dir;
  Interval in = solved(a, 0, glm::dot(aside, aside) - radius * radius);
  in.enter += nearest, in.leave += nearest;
  return in;
}

std::optional<double> first(const Ray& ray, const Interval& in) {
  if (in.empty()) return std::nullopt;
  if (ray.holds(in.enter)) return in.enter;
  return ray.leaves && ray.holds(in.leave) ? std::optional(in.leave) : std::nullopt;
}

struct Hit {
  double t;
  glm::dvec3 normal;
};

std::optional<Hit> meetBall(const Ray& ray, const glm::dvec3& center, double radius) {
  const std::optional<double> t = first(ray, inBall(ray, center, radius));
  if (!t) return std::nullopt;
  return Hit{*t, ray.at(*t) - center};
}

std::optional<Hit> meetDisc(const Ray& ray, const Impostor& disc) {
  const glm::dvec3 normal(disc.toViewer), center(disc.center);
  const double t = glm::dot(center - ray.org, normal) / glm::dot(ray.dir, normal);
  const glm::dvec3 from = ray.at(t) - center;
  if (!ray.holds(t) || !(glm::dot(from, from) <= double{disc.radius} * disc.radius)) return std::nullopt;
  return Hit{t, normal};
}

std::optional<Hit> meetCylinder(const Ray& ray, const Impostor& cylinder) {
  const glm::dvec3 axis(cylinder.axis), from = ray.org - glm::dvec3(cylinder.center);
  const double half = cylinder.halfLength, radius = cylinder.radius;
  const double along = glm::dot(axis, ray.dir), start = glm::dot(axis, from);
  const glm::dvec3 aside = from - start * axis, across = ray.dir - along * axis;
  const double a = glm::dot(across, across), c = glm::dot(aside, aside) - radius * radius;
  Interval in;
  if (a > 1e-24 * glm::dot(ray.dir, ray.dir))
    in = solved(a, glm::dot(aside, across), c);
  else if (c > 0)
    return std::nullopt;
  if (along != 0) {
    const double one = (-half - start) / along, other = (half - start) / along;
    in.cut({std::min(one, other), std::max(one, other)});
  } else if (std::abs(start) > half) {
    return std::nullopt;
  }
  const std::optional<double> t = first(ray, in);
  if (!t) return std::nullopt;
  const double at = start + *t * along;
  const glm::dvec3 out = aside + *t * across;
  const bool onEnd =
      std::abs(std::abs(at) - half) < 1e-6 * half && glm::dot(out, out) < radius * radius * (1 - 1e-6);
  return Hit{*t, onEnd ? axis * (at > 0 ? 1.0 : -1.0) : out};
}

/// The convex hull of two balls: the balls, and the cone that touches both along circles.
struct RoundCone {
  glm::dvec3 end[2];
  double radius[2];

  std::optional<Hit> meet(const Ray& ray) const {
    const glm::dvec3 line = end[1] - end[0];
    const double length = glm::length(line), sine = (radius[0] - radius[1]) / length;
    if (!(std::abs(sine) < 1)) {  // one ball holds the other
      const int larger = radius[0] >= radius[1] ? 0 : 1;
      return meetBall(ray, end[larger], radius[larger]);
    }
    // The hull is convex: of all points on its parts, the first and the last along the ray are on its
    // surface.
    Interval hull = kNowhere;
    const auto add = [&](double t) {
      hull.enter = std::min(hull.enter, t), hull.leave = std::max(hull.leave, t);
    };
    for (int k = 0; k < 2; ++k) {
      const Interval in = inBall(ray, end[k], radius[k]);
      if (!in.empty()) add(in.enter), add(in.leave);
    }
    const glm::dvec3 axis = line / length, from = ray.org - end[0];
    const double cosine = std::sqrt(1 - sine * sine), lowest = radius[0] * sine,
                 highest = length + radius[1] * sine;
    const double along = glm::dot(axis, ray.dir), start = glm::dot(axis, from);
    const glm::dvec3 aside = from - start * axis, across = ray.dir - along * axis;
    // The cone is as wide as atStart + slope * (place along the axis).
    const double slope = -sine / cosine, atStart = radius[0] / cosine + slope * start;
    const double a = glm::dot(across, across) - slope * slope * along * along,
                 b = glm::dot(aside, across) - slope * along * atStart,
                 c = glm::dot(aside, aside) - atStart * atStart;
    const double discriminant = b * b - a * c;
    const double root = std::sqrt(std::max(discriminant, 0.0));
    for (const double t : {a != 0 ? (-b - root) / a : -c / (2 * b), (-b + root) / a}) {
      const double place = start + t * along;
      if (discriminant >= 0 && std::isfinite(t) && place >= lowest && place <= highest) add(t);
    }
    const std::optional<double> t = first(ray, hull);
    if (!t) return std::nullopt;
    const double place = start + *t * along;
    if (place <= lowest) return Hit{*t, ray.at(*t) - end[0]};
    if (place >= highest) return Hit{*t, ray.at(*t) - end[1]};
    return Hit{*t, glm::normalize(aside + *t * across) * cosine + axis * sine};
  }
};

/// Half the width of a point or line in the window, in lighting space, about a vertex.
double halfWidth(const PlacedImpostors& placed, uint32_t vertex) {
  return std::max(0.0, double{placed.window[vertex].w}) * placed.halfWidthPerW;
}

bool isCutAway(const PlacedImpostors& placed, const glm::dvec3& object) {
  for (const glm::vec4& plane : placed.look.centerPlanes)
    if (glm::dot(glm::dvec4(plane), glm::dvec4(object, 1)) < 0) return true;
  return false;
}

/// A row of a matrix times (p, 1).
template <class Matrix>
double rowTimes(const Matrix& m, int row, const glm::vec3& p) {
  return (double{m[0][row]} * double{p.x} + double{m[1][row]} * double{p.y}) +
         (double{m[2][row]} * double{p.z} + double{m[3][row]});
}

/// The ray in lighting space.
Ray inLighting(const PlacedImpostors& placed, const ObjectRay& r) {
  const glm::mat4& m = placed.lightingFromObject;
  const glm::dmat3 linear(glm::mat3{m});
  return {{rowTimes(m, 0, r.org), rowTimes(m, 1, r.org), rowTimes(m, 2, r.org)},
          linear * glm::dvec3(r.dir),
          r.tNear,
          r.tFar,
          !scene::isSizedInPixels(placed.mesh->shape)};
}

/// Whether the program shows the sphere. Its billboard has a constant z, so that near and far plane clip it
/// as a whole, by the sphere's centre.
bool isShown(const PlacedImpostors& placed, uint32_t primitive) {
  const scene::Mesh& mesh = *placed.mesh;
  if (mesh.shape != scene::Shape::spheres || placed.look.billboards != scene::Impostors::Billboards::square)
    return true;
  const glm::vec3 center = mesh.position(mesh.corner(primitive, 0));
  // make() looks at the near plane of half spheres.
  return std::abs(rowTimes(placed.clipFromObject, 2, center)) <= rowTimes(placed.clipFromObject, 3, center);
}

std::optional<Hit> meetTube(const PlacedImpostors& placed, uint32_t primitive, const Ray& ray) {
  const scene::Mesh& mesh = *placed.mesh;
  const uint32_t vertex[] = {mesh.corner(primitive, 0), mesh.corner(primitive, 1)};
  RoundCone cone;
  for (int k = 0; k < 2; ++k) {
    cone.end[k] = scene::impostorCenter(placed.lightingFromObject, mesh.position(vertex[k]));
    cone.radius[k] = halfWidth(placed, vertex[k]);
  }
  const std::optional<Hit> hit = cone.meet(ray);
  if (!hit || placed.look.centerPlanes.empty()) return hit;
  // The planes cut the line, and with each of its points all that is across it.
  const glm::dvec3 line = cone.end[1] - cone.end[0];
  const double share = glm::dot(ray.at(hit->t) - cone.end[0], line) / glm::dot(line, line);
  const glm::dvec3 ends[] = {mesh.position(vertex[0]), mesh.position(vertex[1])};
  if (isCutAway(placed, glm::mix(ends[0], ends[1], std::clamp(share, 0.0, 1.0)))) return std::nullopt;
  return hit;
}

std::optional<Hit> meetSplat(const PlacedImpostors& placed, uint32_t vertex, const Ray& ray) {
  const scene::Mesh& mesh = *placed.mesh;
  const double radius = mesh.radii ? scene::fetch(mesh.radii, vertex).x : mesh.radius;
  return meetBall(ray, mesh.position(vertex), radius / placed.look.radiusDivisor);
}

std::optional<Hit> meetCapsule(const PlacedImpostors& placed, uint32_t primitive, const Ray& ray) {
  Capsule capsule;
  if (!Capsule::make(placed, primitive, capsule)) return std::nullopt;
  const RoundCone cone{{capsule.end[0], capsule.end[1]}, {capsule.radius[0], capsule.radius[1]}};
  return cone.meet(ray);
}

std::optional<Hit> meetStick(const PlacedImpostors& placed, uint32_t primitive, const Ray& ray) {
  Stick stick;
  if (!Stick::make(placed, primitive, stick)) return std::nullopt;
  const std::optional<StickHit> hit = meetSolid(stick, ray.org, ray.dir, ray.tNear, ray.tFar);
  if (!hit) return std::nullopt;
  return Hit{hit->t, hit->normal};
}

std::optional<Hit> meetInLighting(const PlacedImpostors& placed, uint32_t primitive, const Ray& ray) {
  const scene::Mesh& mesh = *placed.mesh;
  if (scene::isSolid(mesh.shape)) return meetCapsule(placed, primitive, ray);
  if (mesh.shape == scene::Shape::sticks) return meetStick(placed, primitive, ray);
  if (mesh.shape == scene::Shape::tubes) return meetTube(placed, primitive, ray);
  if (mesh.shape == scene::Shape::beads) {
    const uint32_t vertex = mesh.corner(primitive, 0);
    if (isCutAway(placed, mesh.position(vertex))) return std::nullopt;
    return meetBall(ray, scene::impostorCenter(placed.lightingFromObject, mesh.position(vertex)),
                    halfWidth(placed, vertex));
  }
  if (!isShown(placed, primitive)) return std::nullopt;
  if (mesh.shape == scene::Shape::spheres) {
    Ball ball;
    return Ball::make(placed, primitive, ball) ? meetBall(ray, ball.center, ball.radius) : std::nullopt;
  }
  Impostor impostor;
  if (!Impostor::make(placed, primitive, impostor)) return std::nullopt;
  if (mesh.shape == scene::Shape::discs) return meetDisc(ray, impostor);
  return meetCylinder(ray, impostor);
}

}  // namespace

std::optional<RoundHull> hullOf(const PlacedImpostors& placed, uint32_t primitive) {
  const scene::Mesh& mesh = *placed.mesh;
  if (scene::isSolid(mesh.shape)) {
    Capsule c;
    if (!Capsule::make(placed, primitive, c)) return std::nullopt;
    return RoundHull{{c.end[0], c.end[1]}, {c.radius[0], c.radius[1]}};
  }
  if (mesh.shape == scene::Shape::sticks) {
    Stick s;
    if (!Stick::make(placed, primitive, s)) return std::nullopt;
    const bool round = s.ends[0] == Stick::End::round && s.ends[1] == Stick::End::round;
    return RoundHull{{s.end[0], s.end[1]}, {s.radius, s.radius}, round};
  }
  if (mesh.shape == scene::Shape::tubes || mesh.shape == scene::Shape::beads) {
    const int last = mesh.shape == scene::Shape::tubes ? 1 : 0;
    RoundHull hull;
    for (int k = 0; k < 2; ++k) {
      const uint32_t vertex = mesh.corner(primitive, std::min(k, last));
      hull.end[k] = scene::impostorCenter(placed.lightingFromObject, mesh.position(vertex));
      hull.radius[k] = static_cast<float>(halfWidth(placed, vertex));
    }
    hull.leaves = false;
    hull.whole = placed.look.centerPlanes.empty();
    return hull;
  }
  Ball ball;
  if (mesh.shape != scene::Shape::spheres || !isShown(placed, primitive)) return std::nullopt;
  if (!Ball::make(placed, primitive, ball)) return std::nullopt;
  return RoundHull{{ball.center, ball.center}, {ball.radius, ball.radius}};
}

std::optional<SolidHit> meetSolid(const PlacedImpostors& placed, uint32_t primitive, const ObjectRay& r) {
  const Ray ray{r.org, r.dir, r.tNear, r.tFar};
  if (placed.mesh->shape == scene::Shape::splats) {
    const uint32_t vertex = placed.mesh->corner(primitive, 0);
    if (isCutAway(placed, placed.mesh->position(vertex))) return std::nullopt;
    const std::optional<Hit> hit = meetSplat(placed, vertex, ray);
    if (!hit) return std::nullopt;
    return SolidHit{static_cast<float>(hit->t), glm::vec3(hit->normal)};
  }
  const std::optional<Hit> hit = meetInLighting(placed, primitive, inLighting(placed, r));
  if (!hit) return std::nullopt;
  return SolidHit{static_cast<float>(hit->t),
                  glm::vec3(glm::transpose(glm::dmat3(glm::mat3(placed.lightingFromObject))) * hit->normal)};
}

}  // namespace gluray::accel
