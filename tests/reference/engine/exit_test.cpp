// Programs whose contexts are left by destructors of static objects: at exit nothing is drawn any more,
// because the real OpenGL's libraries may have destroyed their own.
#include "tests/support/snapshot_taker.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>

namespace gluray::test {
namespace {

int g_presented = 0;

void drawTriangle(const gl::RealGl& gl) {
  gl.Begin(GL_TRIANGLES);
  gl.Vertex3f(-1, -1, 0), gl.Vertex3f(1, -1, 0.1f), gl.Vertex3f(0, 1, 0.2f);
  gl.End();
}

/// What the static window of a program does, destroyed after handlers that were registered later.
void leaveAtExit() {
  const int before = g_presented;
  gl::t_thread.context->loseCurrent();
  _exit(g_presented == before ? 3 : 4);
}

[[noreturn]] void exitWithAPendingDraw() {
  std::atexit(leaveAtExit);
  auto* context =
      new TracedContext({}, TracedContext::tracing(),
                        std::make_unique<SnapshotTaker>([](const scene::Snapshot&) { ++g_presented; }));
  const gl::RealGl& gl = context->gl();
  gl.Enable(GL_DEPTH_TEST);
  drawTriangle(gl);
  gl.Finish();
  if (g_presented != 1) _exit(5);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  drawTriangle(gl);
  std::exit(6);
}

TEST(ExitDeathTest, DrawsNothingWhenStaticObjectsLeaveTheirContext) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(exitWithAPendingDraw(), testing::ExitedWithCode(3), "");
}

TEST(ExitDeathTest, DrawsWhatIsPendingBefore) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto leaveAndExit = [] {
    TracedContext context({}, TracedContext::tracing(),
                          std::make_unique<SnapshotTaker>([](const scene::Snapshot&) { ++g_presented; }));
    context.gl().Enable(GL_DEPTH_TEST);
    drawTriangle(context.gl());
    gl::t_thread.context->loseCurrent();
    _exit(g_presented == 1 ? 3 : 4);
  };
  EXPECT_EXIT(leaveAndExit(), testing::ExitedWithCode(3), "");
}

}  // namespace
}  // namespace gluray::test
