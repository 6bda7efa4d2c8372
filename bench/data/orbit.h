// The camera of the frame benchmark: an orbit around the origin at the height and distance ParaView chooses
// for the Wavelet (view angle 30 degrees, elevation 35.26, distance 669.2). The GL client and the bare loop
// share it.
#pragma once
#include <array>

namespace gluray::bench {

inline constexpr int kImageSize = 1024;           // pixels, both ways
inline constexpr double kViewAngle = 30;          // degrees, both ways: the image is square
inline constexpr double kDistance = 669.2;        // world units
inline constexpr double kNear = 480, kFar = 860;  // world units; the data lies within 173.3 of the origin
inline constexpr double kDataReach = 173.3;
inline constexpr std::array<float, 3> kBackground{0.32f, 0.34f, 0.43f};
inline constexpr std::array<float, 3> kDiffuse{0.80f, 0.62f, 0.36f};

/// Position of the camera and its unit axes in world space; it looks along -backward.
struct CameraPose {
  std::array<double, 3> eye, right, up, backward;
};

/// Pose of one of `frames` frames that go once around, beginning at azimuth 45 degrees; +y is up.
CameraPose orbitPose(int frame, int frames, double distance = kDistance);

/// Nearest and farthest depth of the data from a camera so far from the origin; kNear and kFar at kDistance.
struct DepthRange {
  double nearest, farthest;
};
DepthRange depthRange(double distance);

/// eyeFromWorld of a pose, column by column as OpenGL takes it.
std::array<double, 16> eyeFromWorld(const CameraPose& pose);

}  // namespace gluray::bench
