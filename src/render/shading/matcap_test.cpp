// Colours by images that the normal looks up, against values by hand.
#include "render/shading/matcap.h"

#include <gtest/gtest.h>

#include <memory>

namespace gluray {
namespace {

/// An image of 2 x 2 texels, unfiltered; bottom row first.
scene::Texture quarters(const std::vector<glm::vec4>& texels) {
  auto image = std::make_shared<scene::TextureImage>();
  image->width = image->height = 2, image->floats = texels;
  scene::Texture t;
  t.image = image, t.magFilter = t.minFilter = scene::Filter::nearest;
  return t;
}

scene::FragmentShading fourImages() {
  scene::FragmentShading f;
  f.matcap = {quarters({{1, 0, 0, 1}, {2, 0, 0, 1}, {3, 0, 0, 1}, {4, 0, 0, 1}}),
              quarters(std::vector<glm::vec4>(4, {0, 1, 0, 1})),
              quarters(std::vector<glm::vec4>(4, {0, 0, 1, 1})),
              quarters(std::vector<glm::vec4>(4, {0.5f, 0.5f, 0.5f, 1}))};
  return f;
}

TEST(Matcap, SumsTheImagesByColour) {
  const glm::vec3 got = render::throughMatcap(fourImages(), {0.1f, 0.2f, 0.3f}, {-0.5f, 0.5f, 0.7f});
  EXPECT_NEAR(got.r, 0.1f * 1 + 0.4f * 0.5f, 1e-6f);
  EXPECT_NEAR(got.g, 0.2f + 0.4f * 0.5f, 1e-6f);
  EXPECT_NEAR(got.b, 0.3f + 0.4f * 0.5f, 1e-6f);
}

TEST(Matcap, LooksUpByTheNormalWithYReversed) {
  const auto redAt = [](float x, float y) {
    return render::throughMatcap(fourImages(), {1, 0, 0}, {x, y, 0}).r;
  };
  EXPECT_NEAR(redAt(-1, 0.5f), 1, 1e-6f);
  EXPECT_NEAR(redAt(1, 0.5f), 2, 1e-6f) << "the image's edge is not passed";
  EXPECT_NEAR(redAt(-0.5f, -1), 3, 1e-6f);
  EXPECT_NEAR(redAt(0.5f, -0.5f), 4, 1e-6f);
}

TEST(Matcap, ClampsColours) {
  EXPECT_NEAR(render::throughMatcap(fourImages(), {5, -2, 0}, {-1, 1, 0}).r, 1, 1e-6f);
}

}  // namespace
}  // namespace gluray
