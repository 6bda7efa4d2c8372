// Cameras that are moved by mouse and keys: known answers.
#include "view/camera_moves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::panel {
namespace {

// Looks along -z at the origin, from a distance of 10.
constexpr GlurayCamera kDeep{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 60, 1},
    kFlat{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 0, 3};
constexpr ViewShape kShape{400, 200, 800, 800};  // the window's view is 400 pixels high
constexpr double kOrigin[3] = {0, 0, 0};

void expectAt(const double (&got)[3], double x, double y, double z) {
  EXPECT_NEAR(got[0], x, 1e-9);
  EXPECT_NEAR(got[1], y, 1e-9);
  EXPECT_NEAR(got[2], z, 1e-9);
}

TEST(CameraMoves, TurnAboutAPoint) {
  const GlurayCamera left = turned(kDeep, kOrigin, 90, 0);
  expectAt(left.position, -10, 0, 0), expectAt(left.focalPoint, 0, 0, 0), expectAt(left.up, 0, 1, 0);
  const GlurayCamera below = turned(kDeep, kOrigin, 0, 90);
  expectAt(below.position, 0, -10, 0), expectAt(below.up, 0, 0, 1);
  const double beside[3] = {5, 0, 0};
  const GlurayCamera around = turned(kFlat, beside, 180, 0);
  expectAt(around.position, 10, 0, -10), expectAt(around.focalPoint, 10, 0, 0);
  GlurayCamera once = kDeep;
  for (int i = 0; i < 36; ++i) once = turned(once, kOrigin, 10, 0);
  expectAt(once.position, 0, 0, 10);
}

TEST(CameraMoves, ShiftByPixels) {
  // Half the height of the view is 10 tan 30 degrees, on 200 pixels.
  const double unit = 10 * std::tan(std::acos(-1.0) / 6) / 200;
  const GlurayCamera deep = shifted(kDeep, kShape, 100, 0);
  expectAt(deep.position, -100 * unit, 0, 10), expectAt(deep.focalPoint, -100 * unit, 0, 0);
  expectAt(shifted(kFlat, kShape, 0, 200).position, 0, 3, 10);
}

TEST(CameraMoves, Zoom) {
  expectAt(zoomed(kDeep, 2).position, 0, 0, 5);
  EXPECT_EQ(zoomed(kDeep, 2).viewAngle, 60);
  expectAt(zoomed(kFlat, 2).position, 0, 0, 10);
  EXPECT_EQ(zoomed(kFlat, 2).parallelScale, 1.5);
}

TEST(CameraMoves, FitABall) {
  const double middle[3] = {1, 2, 3};
  const GlurayCamera deep = fitted(kDeep, kShape, middle, 2);
  expectAt(deep.focalPoint, 1, 2, 3), expectAt(deep.position, 1, 2, 3 + 2 / std::sin(std::acos(-1.0) / 6));
  EXPECT_EQ(fitted(kFlat, kShape, middle, 2).parallelScale, 2);
  const ViewShape tall{100, 200, 100, 200};
  EXPECT_EQ(fitted(kFlat, tall, middle, 2).parallelScale, 4);
}

TEST(CameraMoves, LookAtAPoint) {
  const double point[3] = {1, 1, -4};
  const GlurayCamera centred = centredOn(kDeep, point);
  expectAt(centred.focalPoint, 1, 1, -4), expectAt(centred.position, 1, 1, 6);
  EXPECT_FALSE(areEqual(centred, kDeep));
  EXPECT_TRUE(areEqual(centredOn(centred, kOrigin), kDeep));
}

}  // namespace
}  // namespace gluray::panel
