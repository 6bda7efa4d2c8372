// Cameras of a film: key cameras, and what lies between them. Pure functions; any thread.
#pragma once
#include <array>
#include <string>
#include <vector>

namespace gluray::launcher {

using Vector3 = std::array<double, 3>;

/// A camera in a program's world space.
struct PathCamera {
  Vector3 position{0, 0, 1}, focalPoint{0, 0, 0}, up{0, 1, 0};
  double viewAngle = 30;     // of the whole height, degrees; 0: a parallel projection
  double parallelScale = 1;  // half the height of the view, of parallel projections
  bool operator==(const PathCamera&) const = default;
};

struct KeyCamera {
  double time = 0;
  PathCamera camera;
};

struct CameraPath {
  enum class Between { spline, linear };
  /// Of upward directions: on the arc between two keys, or as ParaView does it, by coordinates.
  enum class Upward { arc, coordinates };
  std::vector<KeyCamera> keys;  // times increase
  Between between = Between::spline;
  Upward upward = Upward::arc;
  double begin = 0, end = 0;      // times of the first and last picture
  int pictures = 0;               // that the file asks for; 0: one at each key
  std::vector<PathCamera> saved;  // the saved view's, as the file says; empty or one

  /// The camera at a time: of the first or last key beyond them.
  PathCamera at(double time) const;
  /// The cameras of so many pictures in equal steps from begin to end; 0: as many as the file asks for.
  std::vector<PathCamera> cameras(int count) const;
};

/// Value at `time` of a spline through values at increasing times: cubic polynomials whose slopes at inner
/// keys are those of the chords beside them, weighted for their lengths, and 0 at both ends. Source: D.
/// Kochanek and R. Bartels, "Interpolating Splines with Local Tension, Continuity, and Bias Control",
/// SIGGRAPH 1984, all three of which are 0 here: a Catmull-Rom spline for times in unequal steps.
double splineAt(const std::vector<double>& times, const std::vector<double>& values, double time);

}  // namespace gluray::launcher
