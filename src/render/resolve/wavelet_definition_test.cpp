// The wavelet filter against its definition, for each instruction set.
#include "base/image.h"
#include "render/testing/noisy_wall.h"
#include "render/testing/reference_wavelet.h"
#include "render/testing/test_targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace gluray::render {
namespace {

TEST(Wavelet, IsWhatItsDefinitionSays) {
  test::NoisyWall wall(100, 72);
  test::addNoise(wall);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(0, 1);
  wall.target = 0.05f;
  wall.each([&](int x, int y, size_t i) {
    const float bend = 0.004f * static_cast<float>(x), light = wall.color[4 * i];
    const float geometry[] = {bend, 0.2f, -1000,
                              1 + 1e-5f * static_cast<float>(x * x) + 2e-4f * static_cast<float>(y)};
    std::copy_n(geometry, 4, &wall.geometry[4 * i]);
    for (size_t c = 0; c < 3; ++c)
      wall.reflectance[4 * i + c] = 0.5f + (x > 50 ? 0.3f : 0) + 0.05f * any(random);
    wall.light(i, light);
    wall.noise[i] = static_cast<uint16_t>(any(random) * 0.2f * kNoiseOne);
    if ((x - 30) * (x - 30) + (y - 30) * (y - 30) < 50) wall.depth[i] = Image::kMiss;
  });
  const NoisyImage in = wall.image(true);
  const std::vector<float> expected = test::ReferenceWavelet(in).smooth();
  test::withEachTarget([&](int64_t target) {
    const std::vector<float> out = wall.smooth();
    for (size_t i = 0; i < out.size(); ++i) ASSERT_NEAR(out[i], expected[i], 5e-4f) << i << " of " << target;
  });
}

}  // namespace
}  // namespace gluray::render
