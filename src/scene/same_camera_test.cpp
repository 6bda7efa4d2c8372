#include "scene/same_camera.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::scene {
namespace {

const glm::dmat4 kPerspective = glm::perspective(0.6, 1.5, 0.1, 1000.0);
const glm::dmat4 kView = glm::rotate(glm::translate(glm::dmat4(1), {0.5, -1, -8}), 0.7, {1, 2, 3});

/// As a program with matrices of floats would give it.
glm::dmat4 rounded(const glm::dmat4& m) { return glm::dmat4(glm::mat4(m)); }

TEST(SameCamera, EqualOnesHaveOneEyeSpaceToTheBit) {
  EXPECT_EQ(eyeFromEye(kPerspective, kPerspective, 8), glm::dmat4(1));
  const glm::dmat4 factored = rounded(kPerspective * kView) * glm::inverse(rounded(kView));
  ASSERT_NE(factored, kPerspective);
  EXPECT_EQ(eyeFromEye(kPerspective, factored, 8), glm::dmat4(1));
}

TEST(SameCamera, AnEyeSpaceThatIsAnObjectsLeadsToTheCameras) {
  const auto found = eyeFromEye(kPerspective, rounded(kPerspective * kView), 8);
  ASSERT_TRUE(found);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) EXPECT_NEAR((*found)[c][r], kView[c][r], 1e-3);
}

TEST(SameCamera, OthersAreNone) {
  const glm::dmat4 parallel = glm::ortho(-1.0, 1.0, -1.0, 1.0, 0.1, 1000.0);
  EXPECT_FALSE(eyeFromEye(kPerspective, glm::perspective(0.61, 1.5, 0.1, 1000.0), 8)) << "another angle";
  EXPECT_FALSE(eyeFromEye(kPerspective, glm::perspective(0.6, 1.6, 0.1, 1000.0), 8)) << "another shape";
  EXPECT_FALSE(eyeFromEye(kPerspective, glm::perspective(0.6, 1.5, 0.2, 1000.0), 8)) << "other depths";
  EXPECT_FALSE(eyeFromEye(kPerspective, parallel, 8));
  EXPECT_FALSE(eyeFromEye(parallel, kPerspective, 8));
  EXPECT_FALSE(eyeFromEye(parallel, glm::ortho(-2.0, 2.0, -2.0, 2.0, 0.1, 1000.0), 8)) << "zoomed";
  EXPECT_FALSE(eyeFromEye(kPerspective, glm::dmat4(0), 8)) << "no camera at all";
}

TEST(SameCamera, HoldsInScenesOfAnySize) {
  for (const double size : {1e-15, 1e-6, 1e6, 1e15}) {
    const glm::dmat4 camera = glm::perspective(0.6, 1.5, 0.1 * size, 1000 * size),
                     view = glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(0.5, -1, -8) * size), 0.7,
                                        {1, 2, 3});
    EXPECT_EQ(eyeFromEye(camera, rounded(camera * view) * glm::inverse(rounded(view)), 8 * size),
              glm::dmat4(1));
    EXPECT_FALSE(eyeFromEye(camera, glm::perspective(0.61, 1.5, 0.1 * size, 1000 * size), 8 * size));
  }
}

}  // namespace
}  // namespace gluray::scene
