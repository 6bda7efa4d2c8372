// A quadrilateral in immediate mode, for tests.
#pragma once
#include "gl/real/real.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <initializer_list>

namespace gluray::test {

inline void quad(const gl::RealGl& gl, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                 const glm::vec3& d) {
  gl.Begin(GL_QUADS);
  for (const glm::vec3* p : {&a, &b, &c, &d}) gl.Vertex3f(p->x, p->y, p->z);
  gl.End();
}

}  // namespace gluray::test
