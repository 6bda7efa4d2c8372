// One scene sent through every path of OpenGL (lists, arrays, ...): bit-identical images.
#include "tests/reference/drawn_scene.h"

namespace gluray::test {
namespace {

class VariantTest : public testing::TestWithParam<const scenes::Scene*> {};

DrawnImage drawTraced(const scenes::Scene& scene, uint64_t& draws) {
  TracedContext ours({kSceneWidth, kSceneHeight});
  scene.draw(ours.gl(), kSceneWidth, kSceneHeight);
  DrawnImage image = ours.read();
  draws = ours.context().counts.statistics.drawsTraced;
  return image;
}

TEST_P(VariantTest, EqualsTheFirstToTheBit) {
  const scenes::Scene& first = scenes::variants().front();
  uint64_t draws = 0;
  static const DrawnImage expected = drawTraced(first, draws);
  const DrawnImage got = drawTraced(*GetParam(), draws);
  EXPECT_GT(draws, 0u) << "nothing was traced";
  const Comparison c = compare(expected, got, {0, 0, 0, "none"});
  EXPECT_TRUE(expected == got) << c.text;
  const Comparison real = compare(realImage(first), got, first.tolerance);
  EXPECT_TRUE(real.accepted) << "against the real OpenGL: " << real.text;
  if (!(expected == got)) writeFailure(TEST_OUTPUT, GetParam()->name, expected, got);
}

INSTANTIATE_TEST_SUITE_P(Variants, VariantTest, testing::ValuesIn(pointers(scenes::variants())), sceneNameOf);

}  // namespace
}  // namespace gluray::test
