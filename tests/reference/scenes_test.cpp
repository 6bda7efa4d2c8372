// Every scene, drawn by the real OpenGL and through GLuRay: the same colours and depths.
#include "intercept/present/tracing_presenter.h"
#include "tests/reference/drawn_scene.h"

namespace gluray::test {
namespace {

std::string reasonsListed(const gl::Statistics& s) {
  std::string text;
  for (int i = 0; i < gl::kReasonCount; ++i)
    if (const uint64_t n = s.rasterisedBecause[static_cast<size_t>(i)])
      text +=
          std::string(", ") + std::to_string(n) + " " + std::string(gl::describe(static_cast<gl::Reason>(i)));
  return text;
}

class SceneTest : public testing::TestWithParam<const scenes::Scene*> {};

TEST_P(SceneTest, LooksLikeTheRealOne) {
  const scenes::Scene& scene = *GetParam();
  const DrawnImage& expected = realImage(scene);
  TracedContext ours({kSceneWidth, kSceneHeight});
  scene.draw(ours.gl(), kSceneWidth, kSceneHeight);
  const DrawnImage got = ours.read();
  EXPECT_EQ(ours.gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
  const Comparison c = compare(expected, got, scene.tolerance);
  const gl::Statistics& s = ours.context().counts.statistics;
  std::printf("%s: %s; %zu draws traced, %zu rasterised%s\n", scene.name, c.text.c_str(),
              static_cast<size_t>(s.drawsTraced), static_cast<size_t>(s.drawsRasterised),
              reasonsListed(s).c_str());
  EXPECT_TRUE(c.accepted) << c.text << "; tolerance: " << scene.tolerance.reason;
  EXPECT_FALSE(ours.context().info().off) << "the context stepped aside";
  EXPECT_TRUE(s.drawsTraced > 0 || !scene.traced) << "nothing was traced" << reasonsListed(s);
  if (!c.accepted) writeFailure(TEST_OUTPUT, scene.name, expected, got);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneTest, testing::ValuesIn(pointers(scenes::scenes())), sceneNameOf);

/// Tracing fails at the first flush: fixed function draws the batch, and the real OpenGL everything after it.
TEST_P(SceneTest, LooksLikeTheRealOneWhenTracingFails) {
  const scenes::Scene& scene = *GetParam();
  const DrawnImage& expected = realImage(scene);
  auto fails = std::make_unique<present::TracingPresenter>(
      frame::Tracer{[](const scene::Snapshot&, Image&, scene::TraceCost&, std::string& error) {
        return error = "this test lets tracing fail", false;
      }});
  TracedContext ours({kSceneWidth, kSceneHeight}, TracedContext::vertexShading(), std::move(fails));
  scene.draw(ours.gl(), kSceneWidth, kSceneHeight);
  const DrawnImage got = ours.read();
  const Comparison c = compare(expected, got, scene.tolerance);
  EXPECT_TRUE(c.accepted) << c.text;
  if (!c.accepted) writeFailure(TEST_OUTPUT, std::string("failing-") + scene.name, expected, got);
}

TEST(Harness, TwoRealContextsAgreeToTheBit) {
  for (const char* name : {"directional-light", "texture-linear", "multisampled", "selection"})
    EXPECT_TRUE(drawReal(*scenes::findScene(name)) == drawReal(*scenes::findScene(name))) << name;
}

TEST(Harness, SeesADifference) {
  const DrawnImage expected = drawReal(*scenes::findScene("directional-light"));
  DrawnImage got = expected;
  for (size_t i = 0; i < 500; ++i) got.colors[100 * kSceneWidth + i] ^= 0x40;
  EXPECT_FALSE(compare(expected, got, {}).accepted);
  got = expected;
  for (uint32_t& c : got.colors) c = (c & 0xffffff00) | std::min((c & 0xff) + 3, 255u);
  EXPECT_FALSE(compare(expected, got, {}).accepted);
  got = expected;
  for (float& d : got.depths) d -= 2e-5f;
  EXPECT_FALSE(compare(expected, got, {}).accepted);
  got = expected;
  for (size_t i = 0; i < 60; ++i) got.colors[i * 7] = 0xffffffff;  // few, but not at edges
  EXPECT_FALSE(compare(expected, got, {}).accepted);
}

}  // namespace
}  // namespace gluray::test
