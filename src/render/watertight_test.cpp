// A closed surface covers every pixel.
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gluray {
namespace {

// A bumpy sheet of 80,000 triangles that fills the window. Without robust intersection tests a few rays of a
// million pass between two triangles; these cameras have such rays.
TEST(Watertight, NoRayPassesBetweenTriangles) {
  constexpr uint32_t kCells = 200;
  test::MeshData data;
  for (uint32_t j = 0; j <= kCells; ++j) {
    for (uint32_t i = 0; i <= kCells; ++i) {
      const double x = 6.0 * i / kCells - 3, y = 6.0 * j / kCells - 3;
      data.positions.push_back(glm::vec3(x, y, 0.2 * std::sin(7 * x + 1) * std::cos(5 * y)));
    }
  }
  for (uint32_t j = 0; j < kCells; ++j) {
    for (uint32_t i = 0; i < kCells; ++i) {
      const uint32_t a = j * (kCells + 1) + i, b = a + kCells + 1;
      data.indices.insert(data.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  }
  auto s = test::makeSnapshot({test::makeMesh(data)}, 1024);
  s.camera.clipFromEye = glm::perspective(0.7, 1.0, 1.0, 100.0);
  const glm::dmat4 pushed = glm::translate(glm::dmat4(1), {0, 0, -4});
  for (const int step : {4, 8, 9}) {
    s.eyeFromWorld = s.instances[0].eyeFromObject = glm::rotate(pushed, 0.03 * step, glm::dvec3(0.3, 1, 0.7));
    const Image image = test::trace(s).image;
    EXPECT_EQ(std::count(image.depth.begin(), image.depth.end(), Image::kMiss), 0) << step;
  }
}

}  // namespace
}  // namespace gluray
