// Directions of the key light, and where its highlight is on a ball. Any thread, but lightValues(): GUI
// thread.
#pragma once
#include <nlohmann/json.hpp>

#include <QPointF>
#include <QString>

namespace gluray::panel {

class Controls;

/// Values of lights.azimuth and lights.elevation, in degrees.
struct LightDirection {
  double azimuth = 0, elevation = 0;
};

/// The direction towards the light; x to the right, y up, z towards the viewer.
struct LightVector {
  double x = 0, y = 0, z = 1;
};
LightVector vectorOf(const LightDirection& direction);

/// Where a ball of radius 1 around the origin has the light's highlight, as seen from the front: its normal
/// there is half way between the light and the viewer. y up; within the unit circle.
QPointF highlightAt(const LightDirection& direction);

/// The direction whose highlight is there; points outside the circle are moved onto it.
LightDirection directionFor(const QPointF& highlight);

/// What to set for the direction, rounded to a tenth of a degree: also `lights`, to a rig with a key light,
/// if there is none: the program's own lights shine, or those of `sky`.
nlohmann::json lightValues(const Controls& controls, const LightDirection& direction);

/// Says so before it happens; empty: lightValues() does not change the rig.
QString lineAboutRig(const Controls& controls);

/// The rig that lightValues() chooses: it keeps the image's brightness, and is fixed to the scene by
/// lights.attached = auto.
inline constexpr const char* kRigWithKey = "headlight+key";

}  // namespace gluray::panel
