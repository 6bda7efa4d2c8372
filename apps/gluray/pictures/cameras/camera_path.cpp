#include "pictures/cameras/camera_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gluray::launcher {
namespace {

/// The number of the interval that has the time: its key before.
size_t intervalAt(const std::vector<double>& times, double time) {
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  const auto number = static_cast<size_t>(std::max<ptrdiff_t>(after - times.begin() - 1, 0));
  return std::min(number, times.size() - 2);
}

double lengthOf(const Vector3& v) { return std::hypot(v[0], v[1], v[2]); }

/// On the great circle, by equal angles.
Vector3 onArc(const Vector3& from, const Vector3& to, double share) {
  const double one = lengthOf(from), other = lengthOf(to);
  double cosine = 0;
  for (size_t i = 0; i < 3; ++i) cosine += from[i] / one * to[i] / other;
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)), sine = std::sin(angle);
  const bool straight = sine < 1e-9;
  const double a = straight ? 1 - share : std::sin((1 - share) * angle) / sine,
               b = straight ? share : std::sin(share * angle) / sine;
  Vector3 result{};
  for (size_t i = 0; i < 3; ++i) result[i] = a * from[i] / one + b * to[i] / other;
  return result;
}

}  // namespace

double splineAt(const std::vector<double>& times, const std::vector<double>& values, double time) {
  if (times.size() < 2 || time <= times.front()) return values.front();
  if (time >= times.back()) return values.back();
  const size_t i = intervalAt(times, time), last = times.size() - 1;
  const double length = times[i + 1] - times[i], t = (time - times[i]) / length;
  // Slopes by the share of the interval.
  const auto slope = [&](size_t key) {
    if (key == 0 || key == last) return 0.0;
    const double chords = (values[key + 1] - values[key - 1]) / 2;
    return chords * 2 * length / (times[key + 1] - times[key - 1]);
  };
  const double from = values[i], to = values[i + 1], out = slope(i), in = slope(i + 1);
  return from + t * (out + t * (3 * (to - from) - 2 * out - in + t * (2 * (from - to) + out + in)));
}

PathCamera CameraPath::at(double time) const {
  for (const KeyCamera& key : keys)  // exactly that of the file
    if (key.time == time) return key.camera;
  if (keys.size() < 2 || time < keys.front().time) return keys.front().camera;
  if (time > keys.back().time) return keys.back().camera;
  std::vector<double> times, values(keys.size());
  for (const KeyCamera& key : keys) times.push_back(key.time);
  const size_t i = intervalAt(times, time);
  const double share = (time - times[i]) / (times[i + 1] - times[i]);
  const auto value = [&](const auto& of) {
    for (size_t k = 0; k < keys.size(); ++k) values[k] = of(keys[k].camera);
    return between == Between::spline ? splineAt(times, values, time)
                                      : values[i] + share * (values[i + 1] - values[i]);
  };
  PathCamera camera;
  for (size_t c = 0; c < 3; ++c) {
    camera.position[c] = value([&](const PathCamera& k) { return k.position[c]; });
    camera.focalPoint[c] = value([&](const PathCamera& k) { return k.focalPoint[c]; });
    camera.up[c] = value([&](const PathCamera& k) { return k.up[c]; });
  }
  if (upward == Upward::arc) camera.up = onArc(keys[i].camera.up, keys[i + 1].camera.up, share);
  camera.viewAngle = value([](const PathCamera& k) { return k.viewAngle; });
  camera.parallelScale = value([](const PathCamera& k) { return k.parallelScale; });
  return camera;
}

std::vector<PathCamera> CameraPath::cameras(int count) const {
  std::vector<PathCamera> result;
  const int wanted = count > 0 ? count : pictures;
  if (wanted == 0)
    for (const KeyCamera& key : keys) result.push_back(key.camera);
  for (int i = 0; i < wanted; ++i) {
    const double share = wanted == 1 ? 0 : static_cast<double>(i) / (wanted - 1);
    result.push_back(at(i + 1 == wanted && wanted > 1 ? end : begin + share * (end - begin)));
  }
  return result;
}

}  // namespace gluray::launcher
