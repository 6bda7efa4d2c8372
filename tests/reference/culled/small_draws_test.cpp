// Small draws that are left out as a whole: images are those of all draws to the bit, whatever happens
// between a look at the depths and a draw.
#include "tests/reference/culled/small_scene.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::test {
namespace {

using namespace culled;

TEST(SmallDraws, AreLeftOutBehindAWallAndOutsideOfTheView) {
  const gl::Statistics hidden = compareScene("hidden", [](Gl gl, const SmallScene& s) {
    s.wallSeen(gl);
    s.balls(gl, 6), s.balls(gl, 3.2f);
  });
  // In three frames: the ball after the wall, and those of the row that lie behind it.
  EXPECT_EQ(hidden.drawsCulled, 3 * 8u);
  EXPECT_EQ(hidden.trianglesLeftOut, hidden.drawsCulled * ball(10).triangles());
  const gl::Statistics outside = compareScene("outside", [](Gl gl, const SmallScene& s) {
    s.balls(gl, 3, 12), s.balls(gl, 3), s.ballAt(gl, {0, 0, 3}), s.ballAt(gl, {0, 0, -30});
  });
  EXPECT_GE(outside.drawsCulled, 3 * 9u);
}

TEST(SmallDraws, AreWholeBeforeTheWall) {
  const gl::Statistics back =
      compareScene("back_to_front", [](Gl gl, const SmallScene& s) { s.balls(gl, 6), s.wallSeen(gl); });
  EXPECT_EQ(back.drawsCulled, 3u);
}

/// What happens between the look and the balls, which the wall would hide.
struct Between {
  std::string name;
  Step step;
  Step prepare = [](Gl, const SmallScene&) {};
};

void farWall(Gl gl, const SmallScene& s, GLenum func) {
  gl.DepthFunc(func), s.board(gl, 9, 4), gl.DepthFunc(GL_LESS);
}

std::vector<Between> changesOfDepths() {
  const auto pixels = [](Gl gl, const SmallScene&) {
    const std::vector<GLfloat> far(size_t{kSide} * kSide, 1.0f);
    gl.UseProgram(0), gl.DepthFunc(GL_ALWAYS), gl.WindowPos2i(0, 0);
    gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl.DrawPixels(kSide, kSide, GL_DEPTH_COMPONENT, GL_FLOAT, far.data());
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE), gl.DepthFunc(GL_LESS);
  };
  const auto copied = [](Gl gl, const SmallScene&) {
    gl.UseProgram(0), gl.DepthFunc(GL_ALWAYS), gl.WindowPos2i(0, 40);
    gl.CopyPixels(0, 0, kSide, 40, GL_DEPTH), gl.DepthFunc(GL_LESS);
  };
  const auto immediate = [](Gl gl, const SmallScene&) {
    gl.UseProgram(0), gl.DepthFunc(GL_ALWAYS);
    gl.Begin(GL_QUADS);
    gl.Vertex3f(-1, -1, 0.99f), gl.Vertex3f(1, -1, 0.99f), gl.Vertex3f(1, 1, 0.99f),
        gl.Vertex3f(-1, 1, 0.99f);
    gl.End();
    gl.DepthFunc(GL_LESS);
  };
  return {
      {"clear", [](Gl gl, const SmallScene&) { gl.Clear(GL_DEPTH_BUFFER_BIT); }},
      {"clear_part",
       [](Gl gl, const SmallScene&) {
         gl.Enable(GL_SCISSOR_TEST), gl.Scissor(60, 60, 50, 70);
         gl.Clear(GL_DEPTH_BUFFER_BIT), gl.Disable(GL_SCISSOR_TEST);
       }},
      {"clear_buffer",
       [](Gl gl, const SmallScene&) {
         const GLfloat far = 1;
         gl.ClearBufferfv(GL_DEPTH, 0, &far);
       }},
      {"always", [](Gl gl, const SmallScene& s) { farWall(gl, s, GL_ALWAYS); }},
      {"not_equal", [](Gl gl, const SmallScene& s) { farWall(gl, s, GL_NOTEQUAL); }},
      {"greater", [](Gl gl, const SmallScene& s) { farWall(gl, s, GL_GREATER); }},
      {"draw_pixels", pixels},
      {"copy_pixels", copied},
      {"immediate", immediate},
      {"list", [](Gl gl, const SmallScene&) { gl.CallList(77); },
       [](Gl gl, const SmallScene&) {
         gl.NewList(77, GL_COMPILE), gl.Clear(GL_DEPTH_BUFFER_BIT), gl.EndList();
       }},
  };
}

TEST(SmallDraws, SeeThatDepthsWerePushedBack) {
  for (const Between& of : changesOfDepths()) {
    const gl::Statistics counts = compareScene(
        of.name,
        [&](Gl gl, const SmallScene& s) {
          s.wallSeen(gl), of.step(gl, s);
          gl.UseProgram(s.program), s.balls(gl, 6);
        },
        of.prepare);
    EXPECT_GE(counts.drawsCulled, 3u) << of.name << ": the ball before the change";
  }
}

TEST(SmallDraws, AreStillLeftOutAfterDrawsThatOnlyComeNearer) {
  const gl::Statistics counts = compareScene("nearer", [](Gl gl, const SmallScene& s) {
    s.wallSeen(gl);
    gl.DepthFunc(GL_LEQUAL), s.wall(gl, 4.5f);
    gl.DepthFunc(GL_EQUAL), s.wall(gl, 4);
    gl.DepthFunc(GL_ALWAYS), gl.DepthMask(GL_FALSE), s.wall(gl, 4, 0.5f), gl.DepthMask(GL_TRUE);
    gl.DepthFunc(GL_LESS), s.balls(gl, 6);
  });
  EXPECT_GT(counts.drawsCulled, 3 * 5u);
}

/// State of the balls, which lie behind the wall.
std::vector<Between> states() {
  const auto range = [](double near, double far) {
    return [=](Gl gl, const SmallScene& s) { gl.DepthRange(near, far), s.balls(gl, 6), gl.DepthRange(0, 1); };
  };
  return {
      {"depth_range", range(0, 0.5)},
      {"depth_range_turned", range(1, 0)},
      {"always",
       [](Gl gl, const SmallScene& s) { gl.DepthFunc(GL_ALWAYS), s.balls(gl, 6), gl.DepthFunc(GL_LESS); }},
      {"greater",
       [](Gl gl, const SmallScene& s) { gl.DepthFunc(GL_GREATER), s.balls(gl, 6), gl.DepthFunc(GL_LESS); }},
      {"no_test",
       [](Gl gl, const SmallScene& s) {
         gl.Disable(GL_DEPTH_TEST), s.balls(gl, 6), gl.Enable(GL_DEPTH_TEST);
       }},
      {"viewport",
       [](Gl gl, const SmallScene& s) {
         gl.Viewport(-90, -40, 3 * kSide, 2 * kSide), s.balls(gl, 6), gl.Viewport(0, 0, kSide, kSide);
         gl.Viewport(100, 20, 90, 120), s.balls(gl, 6), gl.Viewport(0, 0, kSide, kSide);
       }},
      {"scissor",
       [](Gl gl, const SmallScene& s) {
         gl.Enable(GL_SCISSOR_TEST), gl.Scissor(0, 70, kSide, 60), s.balls(gl, 6);
         gl.Disable(GL_SCISSOR_TEST);
       }},
      {"offset",
       [](Gl gl, const SmallScene& s) {
         gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(-200, -2e6f), s.balls(gl, 6);
         gl.Disable(GL_POLYGON_OFFSET_FILL);
       }},
      {"lines",
       [](Gl gl, const SmallScene& s) {
         gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), gl.LineWidth(9), s.balls(gl, 6, 1.4f);
         gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL), gl.LineWidth(1);
       }},
      {"clamp",
       [](Gl gl, const SmallScene& s) {
         gl.Enable(GL_DEPTH_CLAMP), s.ballAt(gl, {0.2f, 0, -0.3f}), s.ballAt(gl, {0.2f, 2, -21}, 3);
         gl.Disable(GL_DEPTH_CLAMP);
       }},
      {"stencil",
       [](Gl gl, const SmallScene& s) {
         gl.Clear(GL_STENCIL_BUFFER_BIT), gl.Enable(GL_STENCIL_TEST);
         gl.StencilFunc(GL_ALWAYS, 1, 255), gl.StencilOp(GL_KEEP, GL_INCR, GL_KEEP), s.balls(gl, 6);
         gl.StencilFunc(GL_LESS, 0, 255), gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
         gl.DepthFunc(GL_ALWAYS), s.wall(gl, 5, 3), gl.DepthFunc(GL_LESS), gl.Disable(GL_STENCIL_TEST);
       }},
      {"near_plane",
       [](Gl gl, const SmallScene& s) {
         s.ballAt(gl, {0.3f, 0.2f, -6}, 6.2f), s.ballAt(gl, {0, 0, -1}, 1.2f), s.ballAt(gl, {0, 0, 4}, 0.5f);
       }},
  };
}

TEST(SmallDraws, FollowTheStateOfEachDraw) {
  for (const Between& of : states()) {
    const gl::Statistics counts =
        compareScene("state_" + of.name, [&](Gl gl, const SmallScene& s) { s.wallSeen(gl), of.step(gl, s); });
    EXPECT_GE(counts.drawsCulled, 3u) << of.name;
  }
}

TEST(SmallDraws, AreLeftOutWhateverTheyWouldWrite) {
  const gl::Statistics counts = compareScene("blended", [](Gl gl, const SmallScene& s) {
    s.wallSeen(gl);
    gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE), gl.DepthMask(GL_FALSE);
    s.balls(gl, 6), s.balls(gl, 3.2f);
    gl.DepthMask(GL_TRUE), gl.Disable(GL_BLEND);
  });
  EXPECT_EQ(counts.drawsCulled, 3 * 8u);
}

}  // namespace
}  // namespace gluray::test
