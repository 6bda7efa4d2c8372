// A field of triangles, more than are captured one by one, for buffers whose contents change.
#pragma once
#include "gl/real/real.h"

#include <vector>

namespace gluray::test::triangle_field {

constexpr int kTriangles = 100;
constexpr GLsizei kVertices = 3 * kTriangles;
constexpr GLsizeiptr kBytes = kVertices * 3 * sizeof(float);

/// kBytes of positions; `shape` selects one of two fields.
inline std::vector<float> field(float shape) {
  std::vector<float> all;
  for (int i = 0; i < kTriangles; ++i) {
    const float x = 0.2f * static_cast<float>(i % 10) - 1, y = 0.2f * static_cast<float>(i / 10) - 1;
    const float z = shape * 0.1f * static_cast<float>(i % 3);
    all.insert(all.end(), {x, y, z, x + 0.18f, y + 0.05f * shape, z, x + 0.05f, y + 0.18f, z});
  }
  return all;
}

}  // namespace gluray::test::triangle_field
