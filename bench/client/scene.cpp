#include "bench/client/scene.h"

#include "bench/data/orbit.h"

#include <GL/gl.h>

#include <cmath>

namespace gluray::bench {

void setScene(double distance) {
  glClearColor(kBackground[0], kBackground[1], kBackground[2], 1);
  for (const GLenum switched : {GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0}) glEnable(switched);
  const float towardsViewer[] = {0, 0, 1, 0};
  glLightfv(GL_LIGHT0, GL_POSITION, towardsViewer);
  glMatrixMode(GL_PROJECTION);
  const auto [nearest, farthest] = depthRange(distance);
  const double half = nearest * std::tan(kViewAngle / 2 * M_PI / 180);
  glFrustum(-half, half, -half, half, nearest, farthest);
  glMatrixMode(GL_MODELVIEW);
}

}  // namespace gluray::bench
