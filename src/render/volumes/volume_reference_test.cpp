// Traced volumes of one channel equal a plain loop over all samples, with every instruction set.
#include "render/testing/random_volumes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace gluray::render {
namespace {

using namespace test;
using scene::VolumeBlend;

TEST(VolumeReference, CompositesAsAPlainLoop) {
  expectReferences(1, 0.02, [](Random&, RandomCast&) {});
}

TEST(VolumeReference, LightsAsAPlainLoop) {
  expectReferences(2, 0.1, [](Random& random, RandomCast& made) { addLight(random, made.cast.volume); });
}

TEST(VolumeReference, WeighsByGradientsAsAPlainLoop) {
  expectReferences(3, 0.15, [](Random& random, RandomCast& made) {
    made.cast.volume.channels[0].gradientOpacity =
        std::make_shared<scene::VolumeTable>(randomTable(random, 1, true));
    if (random.integer(0, 1) == 1) addLight(random, made.cast.volume);
  });
}

TEST(VolumeReference, EndsAtDepthsAsAPlainLoop) {
  expectReferences(4, 0.1, [](Random& random, RandomCast& made) {
    setBlend(random, made.cast.volume), addDepths(random, made.cast.view);
  });
}

TEST(VolumeReference, BlendsAsAPlainLoop) {
  expectReferences(5, 0.1, [](Random& random, RandomCast& made) {
    setBlend(random, made.cast.volume);
    made.cast.volume.averaged = {random.real(-3, 0), random.real(0.5, 3)};
    made.cast.volume.colorScale = static_cast<float>(random.real(0.5, 1.5));
    made.cast.volume.colorBias = static_cast<float>(random.real(-0.2, 0.2));
  });
}

TEST(VolumeReference, LightsExtremesAsAPlainLoop) {
  expectReferences(6, 0.1, [](Random& random, RandomCast& made) {
    made.cast.volume.blend = random.integer(0, 1) == 1 ? VolumeBlend::maximum : VolumeBlend::minimum;
    addLight(random, made.cast.volume);
    if (random.integer(0, 1) == 1)
      made.cast.volume.channels[0].gradientOpacity =
          std::make_shared<scene::VolumeTable>(randomTable(random, 1, true));
  });
}

TEST(VolumeReference, TakesNearestValuesAsAPlainLoop) {
  expectReferences(
      7, 0.2,
      [](Random& random, RandomCast& made) {
        setBlend(random, made.cast.volume);
        made.cast.volume.linear = random.integer(0, 2) == 0;
        made.cast.volume.channels[0].opacity.linear = random.integer(0, 1) == 1;
        made.cast.volume.channels[0].color.linear = random.integer(0, 1) == 1;
      },
      12);
}

}  // namespace
}  // namespace gluray::render
