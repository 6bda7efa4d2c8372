// A ball of facets, for the tests of render/.
#pragma once
#include "accel/testing/test_scene.h"

#include <cmath>

namespace gluray::test {

/// Of `around` x `around`/2 facets; if `smooth`, with the normals of the sphere.
inline scene::MeshPtr ballMesh(int around, float radius = 1, const glm::vec3& center = glm::vec3(0),
                               bool smooth = true) {
  MeshData data;
  const auto at = [&](int i, int j) {
    const double a = 2 * M_PI * i / around, b = M_PI * j / (around / 2);
    return glm::vec3(std::sin(b) * std::cos(a), std::cos(b), std::sin(b) * std::sin(a));
  };
  for (int j = 0; j < around / 2; ++j)
    for (int i = 0; i < around; ++i)
      for (const glm::vec3& p :
           {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)}) {
        data.positions.push_back(center + radius * p);
        if (smooth) data.normals.push_back(p);
      }
  return makeMesh(data);
}

}  // namespace gluray::test
