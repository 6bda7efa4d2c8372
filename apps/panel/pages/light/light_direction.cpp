#include "pages/light/light_direction.h"

#include "model/controls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gluray::panel {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kRim = 0.999;  // the farthest from the middle: beyond it is a light straight behind the ball

double tenths(double degrees) { return std::round(degrees * 10) / 10; }

}  // namespace

LightVector vectorOf(const LightDirection& direction) {
  const double azimuth = direction.azimuth * kDegree, elevation = direction.elevation * kDegree;
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
          std::cos(elevation) * std::cos(azimuth)};
}

QPointF highlightAt(const LightDirection& direction) {
  const LightVector light = vectorOf(direction);
  const double length = std::sqrt(light.x * light.x + light.y * light.y + (light.z + 1) * (light.z + 1));
  if (length < 1e-6) return {0, kRim};  // straight behind it: any point of the rim
  return {light.x / length, light.y / length};
}

LightDirection directionFor(const QPointF& highlight) {
  const double radius = std::hypot(highlight.x(), highlight.y());
  const double scale = radius > kRim ? kRim / radius : 1;
  const double x = highlight.x() * scale, y = highlight.y() * scale;
  const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
  // The viewer's direction (0, 0, 1) mirrored at the normal.
  const LightVector light{2 * z * x, 2 * z * y, 2 * z * z - 1};
  return {std::atan2(light.x, light.z) / kDegree, std::asin(std::clamp(light.y, -1.0, 1.0)) / kDegree};
}

nlohmann::json lightValues(const Controls& controls, const LightDirection& direction) {
  nlohmann::json values{{"lights.azimuth", tenths(direction.azimuth)},
                        {"lights.elevation", tenths(direction.elevation)}};
  if (!lineAboutRig(controls).isEmpty()) values["lights"] = kRigWithKey;
  return values;
}

QString lineAboutRig(const Controls& controls) {
  const nlohmann::json rig = controls.value("lights").value;
  if (rig == "program") return QObject::tr("lights = %1 in place of the program's lights").arg(kRigWithKey);
  if (rig == "sky")
    return QObject::tr("lights = %1 in place of sky, which has no key light").arg(kRigWithKey);
  return {};
}

}  // namespace gluray::panel
