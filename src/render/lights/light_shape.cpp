#include "render/lights/light_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gluray::render {
namespace {

using Kind = scene::LightSource::Kind;

using std::numbers::pi;
// Sine of half the angle of the smallest light that rays meet: directions are rounded to floats.
constexpr double kSmallest = 1e-4;

/// Perpendicular to a unit vector, and to each other.
struct Basis {
  glm::dvec3 x, y;
  explicit Basis(const glm::dvec3& n) {
    const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
    x = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    y = {b, sign + n.y * n.y * a, -n.y};
  }
};

/// 1 - cosine of the angle with this sine.
double rimOf(double sine) { return sine * sine / (1 + std::sqrt(std::max(1 - sine * sine, 0.0))); }

/// The largest cosine to an axis of the directions around one whose cosine is `cosine`, in a cone of this
/// sine; 0: none is on the axis's side.
double largestCosine(double cosine, double sine) {
  if (sine >= 1) return 1;
  const double inner = std::sqrt(1 - sine * sine);
  if (cosine >= inner) return 1;
  return std::max(cosine * inner + std::sqrt(std::max(1 - cosine * cosine, 0.0)) * sine, 0.0);
}

/// Finite, and not negative.
glm::vec3 usable(const glm::dvec3& v) {
  glm::vec3 result(0);
  for (int c = 0; c < 3; ++c)
    if (v[c] > 0) result[c] = static_cast<float>(std::min(v[c], 1e30));
  return result;
}

}  // namespace

/// The directions from a point that a light fills evenly.
struct LightShape::Cone {
  glm::dvec3 axis{0, 0, 1};  // unit length
  double distance = 0;       // to the middle
  double rim = 0;            // 1 - cosine of the angle from axis to rim; 2: all directions; 0: the axis alone
  double radius = 0;         // of the ball
  glm::dvec3 color{0};       // irradiance / pi of a surface that faces it
  bool met = false;
  glm::dvec3 radiance() const { return rim > 1 ? color : color / (rim * (2 - rim)); }
  double pdf() const { return 1 / (2 * pi * rim); }
};

LightShape::LightShape(const scene::LightSource& light, float size)
    : light_(light),
      sineOfSize_(std::sin(glm::radians(0.5 * size))),
      color_(glm::dvec3(light.color) * double{light.strength}),
      middle_(light.position),
      direction_(light.direction) {
  if (light.kind == Kind::rectangle) {
    const glm::dvec3 a(light.halfEdge[0]), b(light.halfEdge[1]);
    area_ = 4 * glm::length(glm::cross(a, b));
    reach_ = std::max(glm::length(a + b), glm::length(a - b));
  } else if (light.kind == Kind::disc) {
    reach_ = light.radius;
    area_ = pi * reach_ * reach_;
  }
}

bool LightShape::isArea() const { return light_.kind == Kind::rectangle || light_.kind == Kind::disc; }

LightShape::Cone LightShape::coneFrom(const glm::dvec3& point) const {
  Cone cone;
  cone.color = color_;
  if (light_.kind == Kind::distant) {
    const double sine = light_.angle > 0 ? std::sin(glm::radians(0.5 * light_.angle)) : sineOfSize_;
    cone.axis = -direction_, cone.distance = std::numeric_limits<double>::infinity();
    cone.rim = rimOf(sine), cone.met = sine > kSmallest;
    return cone;
  }
  const glm::dvec3 way = middle_ - point;
  cone.distance = glm::length(way);
  if (cone.distance > 0) cone.axis = way / cone.distance;
  const bool sized = light_.radius > 0;
  cone.radius = sized ? light_.radius : cone.distance * sineOfSize_;
  const double sine = cone.radius < cone.distance ? cone.radius / cone.distance : 1;
  cone.rim = cone.radius > cone.distance ? 2 : rimOf(sine);
  cone.met = sized && sine > kSmallest;
  if (light_.kind == Kind::sphere) {
    cone.color *= sine * sine;
    return cone;
  }
  const glm::dvec3 factors(light_.attenuation);
  cone.color /= factors.x + cone.distance * (factors.y + cone.distance * factors.z);
  if (light_.kind != Kind::spot) return cone;
  const double cosine = -glm::dot(cone.axis, direction_);
  if (!(cosine >= light_.coneCosine)) cone.color = glm::dvec3(0);
  if (light_.coneExponent > 0) cone.color *= std::pow(std::max(cosine, 0.0), double{light_.coneExponent});
  return cone;
}

LightShape::Arriving LightShape::sampleCone(const glm::dvec3& point, const glm::vec2& u) const {
  const Cone cone = coneFrom(point);
  Arriving a;
  if (cone.rim == 0) {
    a.direction = glm::vec3(cone.axis), a.distance = static_cast<float>(cone.distance);
    a.irradiance = usable(pi * cone.color);
    return a;
  }
  const double k = u.x * cone.rim, across = std::sqrt(std::max(k * (2 - k), 0.0)), angle = 2 * pi * u.y;
  const Basis basis(cone.axis);
  const glm::dvec3 way =
      across * (std::cos(angle) * basis.x + std::sin(angle) * basis.y) + (1 - k) * cone.axis;
  a.direction = glm::vec3(glm::normalize(way));
  a.distance = std::numeric_limits<float>::infinity();
  if (std::isfinite(cone.distance)) {
    const double aside = cone.distance * across,
                 within = std::sqrt(std::max(cone.radius * cone.radius - aside * aside, 0.0));
    a.distance = static_cast<float>(
        std::max(cone.distance * (1 - k) + (cone.radius > cone.distance ? within : -within), 0.0));
  }
  a.irradiance = usable(cone.radiance() / cone.pdf());
  a.pdf = cone.met ? static_cast<float>(cone.pdf()) : 0;
  return a;
}

LightShape::Arriving LightShape::sampleArea(const glm::dvec3& point, const glm::vec2& u) const {
  glm::dvec3 at = middle_;
  if (light_.kind == Kind::rectangle) {
    at += (2.0 * u.x - 1) * glm::dvec3(light_.halfEdge[0]) + (2.0 * u.y - 1) * glm::dvec3(light_.halfEdge[1]);
  } else {
    const Basis basis(direction_);
    const double radius = light_.radius * std::sqrt(double{u.x}), angle = 2 * pi * u.y;
    at += radius * (std::cos(angle) * basis.x + std::sin(angle) * basis.y);
  }
  const glm::dvec3 way = at - point;
  const double distance = glm::length(way), cosine = -glm::dot(way, direction_) / distance;
  Arriving a;
  if (!(cosine > 0) || !(area_ > 0)) return a;
  const double pdf = distance * distance / (cosine * area_);
  a.direction = glm::vec3(way / distance), a.distance = static_cast<float>(distance);
  a.irradiance = usable(color_ / pdf);
  a.pdf = reach_ > kSmallest * distance ? static_cast<float>(std::min(pdf, 1e30)) : 0;
  return a;
}

LightShape::Arriving LightShape::sample(const glm::vec3& point, const glm::vec2& u) const {
  return isArea() ? sampleArea(glm::dvec3(point), u) : sampleCone(glm::dvec3(point), u);
}

std::optional<LightShape::Met> LightShape::meetCone(const glm::dvec3& point,
                                                    const glm::dvec3& direction) const {
  const Cone cone = coneFrom(point);
  if (!cone.met) return {};
  double distance = cone.distance;
  if (light_.kind == Kind::distant) {
    const glm::dvec3 chord = direction - cone.axis;
    if (glm::dot(chord, chord) > 2 * cone.rim) return {};
  } else {
    const glm::dvec3 way = cone.distance * cone.axis;
    const double along = glm::dot(way, direction);
    const glm::dvec3 aside = way - along * direction;
    const double within = cone.radius * cone.radius - glm::dot(aside, aside);
    const bool inside = cone.radius > cone.distance;
    if (!(within >= 0) || (!inside && along < 0)) return {};
    distance = std::max(along + (inside ? std::sqrt(within) : -std::sqrt(within)), 0.0);
  }
  return Met{static_cast<float>(distance), static_cast<float>(cone.pdf()), usable(cone.radiance())};
}

std::optional<LightShape::Met> LightShape::meetArea(const glm::dvec3& point,
                                                    const glm::dvec3& direction) const {
  const glm::dvec3 toMiddle = middle_ - point;
  const double towards = -glm::dot(direction, direction_), height = -glm::dot(toMiddle, direction_);
  if (!(towards > 0) || !(height > 0) || !(area_ > 0)) return {};
  const double distance = height / towards;
  const glm::dvec3 at = distance * direction - toMiddle;
  if (light_.kind == Kind::rectangle) {
    const glm::dvec3 a(light_.halfEdge[0]), b(light_.halfEdge[1]), normal = glm::cross(a, b);
    const double square = glm::dot(normal, normal);
    if (std::abs(glm::dot(glm::cross(at, b), normal)) > square) return {};
    if (std::abs(glm::dot(glm::cross(a, at), normal)) > square) return {};
  } else if (glm::dot(at, at) > double{light_.radius} * light_.radius) {
    return {};
  }
  if (!(reach_ > kSmallest * distance)) return {};
  const double pdf = distance * distance / (towards * area_);
  return Met{static_cast<float>(distance), static_cast<float>(std::min(pdf, 1e30)), usable(color_)};
}

std::optional<LightShape::Met> LightShape::meet(const glm::dvec3& point, const glm::dvec3& direction) const {
  return isArea() ? meetArea(point, direction) : meetCone(point, direction);
}

glm::vec3 LightShape::estimate(const glm::vec3& point, const glm::vec3* normal) const {
  const glm::dvec3 n = normal ? glm::dvec3(*normal) : glm::dvec3(0);
  const auto facing = [&](const glm::dvec3& way, double sine) {
    return normal ? largestCosine(glm::dot(n, way), sine) : 1;
  };
  if (!isArea()) {
    const Cone cone = coneFrom(glm::dvec3(point));
    const double sine = cone.rim >= 1 ? 1 : std::sqrt(cone.rim * (2 - cone.rim));
    return usable(pi * cone.color * facing(cone.axis, sine));
  }
  const glm::dvec3 way = middle_ - glm::dvec3(point);
  if (!(glm::dot(way, direction_) < 0)) return glm::vec3(0);
  const double distance = glm::length(way), sine = reach_ / distance;
  const double shown = area_ * largestCosine(-glm::dot(way, direction_) / distance, sine);
  const double share = std::min(shown / (pi * distance * distance), 1.0);
  return usable(pi * color_ * share * facing(way / distance, sine));
}

}  // namespace gluray::render
