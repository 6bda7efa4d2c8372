#include "tests/reference/hostile/habits.h"

#include <algorithm>

namespace gluray::test::twenty_points {
namespace {

struct Run {
  DrawnImage image;
  Seen seen;
  GLenum error = GL_NO_ERROR;
};

Run runWith(Gl gl, const Program& program) {
  Run run;
  program(gl, run.seen);
  run.image = readImage(gl, kWidth, kHeight);
  run.error = gl.GetError();
  return run;
}

}  // namespace

gl::Statistics expectSame(const Program& program, const Expected& wanted) {
  const auto real = OsmesaContext::create({kWidth, kHeight});
  const Run expected = runWith(real->real(), program);
  TracedContext ours({kWidth, kHeight});
  const Run got = runWith(ours.gl(), program);
  const Comparison c = compare(expected.image, got.image, wanted.tolerance);
  EXPECT_TRUE(c.accepted) << c.text;
  if (!c.accepted)
    writeFailure(TEST_OUTPUT, testing::UnitTest::GetInstance()->current_test_info()->name(), expected.image,
                 got.image);
  EXPECT_EQ(expected.error, got.error);
  EXPECT_EQ(expected.seen.size(), got.seen.size());
  for (size_t i = 0; i < std::min(expected.seen.size(), got.seen.size()); ++i)
    EXPECT_NEAR(expected.seen[i], got.seen[i], wanted.seenTolerance) << "answer " << i;
  EXPECT_FALSE(ours.context().info().off) << "the context stepped aside";
  EXPECT_GE(ours.context().counts.statistics.drawsTraced, wanted.traced);
  return ours.context().counts.statistics;
}

void stage(Gl gl) {
  scenes::begin(gl, kWidth, kHeight);
  camera(gl, kWidth, kHeight);
  keyLight(gl);
  paint(gl, 0.8f, 0.5f, 0.3f);
}

}  // namespace gluray::test::twenty_points
