#include "bench/data/orbit.h"

#include <algorithm>
#include <cmath>

namespace gluray::bench {

CameraPose orbitPose(int frame, int frames, double distance) {
  const double azimuth = M_PI / 4 + (frames > 0 ? 2 * M_PI * frame / frames : 0.0);
  const double elevation = 35.26 * M_PI / 180;
  const double ca = std::cos(azimuth), sa = std::sin(azimuth), ce = std::cos(elevation),
               se = std::sin(elevation);
  CameraPose pose;
  pose.backward = {ce * sa, se, ce * ca};
  pose.right = {ca, 0, -sa};
  pose.up = {-se * sa, ce, -se * ca};
  pose.eye = {distance * pose.backward[0], distance * pose.backward[1], distance * pose.backward[2]};
  return pose;
}

DepthRange depthRange(double distance) {
  if (distance == kDistance) return {kNear, kFar};
  return {std::max(distance - kDataReach, 0.01 * distance), distance + kDataReach};
}

std::array<double, 16> eyeFromWorld(const CameraPose& pose) {
  std::array<double, 16> out{};
  const std::array<double, 3>* rows[3] = {&pose.right, &pose.up, &pose.backward};
  for (size_t row = 0; row < 3; ++row) {
    for (size_t column = 0; column < 3; ++column) {
      out[4 * column + row] = (*rows[row])[column];
      out[12 + row] -= (*rows[row])[column] * pose.eye[column];
    }
  }
  out[15] = 1;
  return out;
}

}  // namespace gluray::bench
