// Fixed-function surfaces blended in the order of drawing: their framebuffers, and other uses of these.
#include "intercept/present/tracing_presenter.h"
#include "tests/reference/framebuffer.h"
#include "tests/reference/layers/drawn_layers_stage.h"

namespace gluray::test::drawn_layers {
namespace {

TEST(DrawnLayers, MeetFramebuffersOfManyFormats) {
  const struct {
    const char* name;
    GLenum color, depth;
  } formats[] = {
      {"rgba8 d24", GL_RGBA8, GL_DEPTH_COMPONENT24},   {"rgba8 d16", GL_RGBA8, GL_DEPTH_COMPONENT16},
      {"rgba8 d32f", GL_RGBA8, GL_DEPTH_COMPONENT32F}, {"rgba8 d24s8", GL_RGBA8, GL_DEPTH24_STENCIL8},
      {"rgb8 d24", GL_RGB8, GL_DEPTH_COMPONENT24},     {"srgb8 d24", GL_SRGB8_ALPHA8, GL_DEPTH_COMPONENT24}};
  for (const auto& format : formats) {
    for (const Function& f : {kFunctions[1], kFunctions[2], kFunctions[8]}) {
      for (const bool writes : {true, false}) {
        BothStage stage = theStage();
        stage.tolerance.depth = format.depth == GL_DEPTH_COMPONENT16 ? 2.0f / 65535 : 1e-5f;  // a step
        const auto draw = [&](Gl gl) {
          bindNewFramebuffer(gl, {kWidth, kHeight}, format.color, format.depth);
          stage.prepare(gl);
          ball(gl, {0, -0.3f, {0.7f, 0.7f, 0.2f, 1}});
          blendBy(gl, f);
          gl.DepthMask(writes);
          for (const Ball& b : kBalls) ball(gl, {b.x, b.z, {b.color[0], b.color[1], b.color[2], 0.7f}});
        };
        const std::string name = std::string(format.name) + " " + f.name + (writes ? " writing" : "");
        EXPECT_EQ(compareBoth(stage, name, draw).drawsTraced, 4u) << name;
      }
    }
  }
}

TEST(DrawnLayers, AreRasterisedInOtherKindsOfFramebuffers) {
  for (const GLenum format : {GL_RGB10_A2, GL_RGBA16F, GL_RGBA16, GL_RGB565}) {
    const auto draw = [&](Gl gl) {
      bindNewFramebuffer(gl, {kWidth, kHeight}, format, GL_DEPTH_COMPONENT24);
      theStage().prepare(gl);
      blendOver(gl);
      for (const Ball& b : kBalls) ball(gl, {b.x, b.z, {b.color[0], b.color[1], b.color[2], 0.7f}});
    };
    EXPECT_EQ(compareBoth(theStage(), "format " + std::to_string(format), draw).drawsTraced, 0u);
  }
}

TEST(DrawnLayers, AreRasterisedInMultisampledFramebuffers) {
  for (const bool multisample : {true, false}) {
    for (const bool writes : {true, false}) {
      const auto draw = [&](Gl gl) {
        bindNewFramebuffer(gl, {kWidth, kHeight}, GL_RGBA8, GL_DEPTH_COMPONENT24, 4);
        theStage().prepare(gl);
        multisample ? gl.Enable(GL_MULTISAMPLE) : gl.Disable(GL_MULTISAMPLE);
        blendOver(gl);
        gl.DepthMask(writes);
        for (const Ball& b : kBalls) ball(gl, {b.x, b.z, {b.color[0], b.color[1], b.color[2], 0.7f}});
        GLuint from = 0;
        gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, reinterpret_cast<GLint*>(&from));
        bindNewFramebuffer(gl, {kWidth, kHeight}, GL_RGBA8, GL_DEPTH_COMPONENT24);
        gl.BindFramebuffer(GL_READ_FRAMEBUFFER, from);
        gl.BlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight,
                           GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
        GLint to = 0;
        gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &to);
        gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(to));
      };
      const std::string name =
          std::string("samples") + (multisample ? " on" : "") + (writes ? " writing" : "");
      const gl::Statistics counted = compareBoth(theStage(), name, draw);
      EXPECT_EQ(counted.drawsTraced, 0u) << name;
      const gl::Reason reason = writes ? gl::Reason::blend : gl::Reason::depthMask;
      EXPECT_EQ(counted.rasterisedBecause[static_cast<size_t>(reason)], 3u) << name;
    }
  }
}

TEST(DrawnLayers, TakeTheChannelsThatAreWritten) {
  const GLboolean masks[][4] = {{1, 0, 1, 1}, {0, 1, 0, 0}, {1, 1, 1, 0}, {0, 0, 0, 1}};
  for (const auto& mask : masks) {
    const auto draw = [&](Gl gl) {
      blendBy(gl, kFunctions[8]);
      gl.ColorMask(mask[0], mask[1], mask[2], mask[3]);
      for (const Ball& b : kBalls) ball(gl, {b.x, b.z, {b.color[0], b.color[1], b.color[2], 0.7f}});
    };
    expectTraced("mask " + std::to_string(mask[0]) + std::to_string(mask[1]) + std::to_string(mask[3]), draw,
                 3);
  }
}

TEST(DrawnLayers, AreCutByPlanesScissorAndViewport) {
  const auto draw = [](Gl gl) {
    blendOver(gl);
    const GLdouble plane[] = {1, 0.5, 0.2, 0.1};
    gl.ClipPlane(GL_CLIP_PLANE0, plane);
    gl.Enable(GL_CLIP_PLANE0);
    ball(gl, kBalls[0]);
    gl.Disable(GL_CLIP_PLANE0);
    gl.Enable(GL_SCISSOR_TEST), gl.Scissor(30, 10, 50, 60);
    ball(gl, kBalls[1]);
    gl.Viewport(-20, 5, 130, 70);
    ball(gl, {0.4f, 0.2f, {0.3f, 0.3f, 0.9f, 0.6f}});
    gl.Disable(GL_SCISSOR_TEST);
    gl.Viewport(0, 0, kWidth, kHeight);
  };
  expectTraced("cut", draw, 3);
}

TEST(DrawnLayers, OfDepthRangesOneOfThemTurnedRound) {
  for (const auto& range : {std::pair(0.2, 0.7), std::pair(1.0, 0.0), std::pair(0.5, 0.5)}) {
    const auto draw = [&](Gl gl) {
      blendOver(gl);
      gl.DepthRange(range.first, range.second);
      for (const Ball& b : kBalls) ball(gl, {b.x, b.z, {b.color[0], b.color[1], b.color[2], 0.7f}});
    };
    expectTraced("range " + std::to_string(range.first), draw, 3);
  }
}

TEST(DrawnLayers, OfSurfacesThatAreMovedInDepth) {
  const auto draw = [](Gl gl) {
    ball(gl, {0, 0, {0.9f, 0.9f, 0.8f, 1}});
    blendOver(gl);
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.PolygonOffset(-2, -40);
    gl.DepthMask(GL_FALSE);
    ball(gl, {0.02f, -0.02f, {0.9f, 0.2f, 0.1f, 0.5f}});
    gl.PolygonOffset(3, 60);
    ball(gl, {-0.05f, 0.05f, {0.1f, 0.2f, 0.9f, 0.5f}});
  };
  expectTraced("moved", draw, 3);
}

TEST(DrawnLayers, MeetLinesBetweenThem) {
  const auto draw = [](Gl gl) {
    blendOver(gl);
    gl.DepthMask(GL_FALSE);
    ball(gl, kBalls[1]);
    gl.LineWidth(3);
    gl.Begin(GL_LINES);
    gl.Vertex3f(-1, -0.5f, 0.9f), gl.Vertex3f(1, 0.5f, 0.9f);
    gl.End();
    ball(gl, kBalls[0]);
  };
  EXPECT_EQ(compareBoth(theStage(), "lines", draw).drawsTraced, 2u);
}

TEST(DrawnLayers, AreThereAfterSwapsAndReads) {
  const auto draw = [](Gl gl) {
    for (int frame = 0; frame < 3; ++frame) {
      theStage().prepare(gl);
      gl.Disable(GL_BLEND), gl.DepthMask(GL_TRUE);
      ball(gl, {0, 0, {0.7f, 0.7f, 0.2f, 1}});
      blendOver(gl);
      gl.DepthMask(GL_FALSE);
      ball(gl, kBalls[0]);
      uint32_t pixel = 0;
      gl.ReadPixels(60, 45, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
      ball(gl, kBalls[1]);
      gl.DepthMask(GL_TRUE);
      gl.Finish();
    }
  };
  expectTraced("frames", draw, 9);
}

TEST(DrawnLayers, AreDrawnByTheRealOneWhereTracingFails) {
  const Function& f = kFunctions[10];
  for (const bool writes : {true, false}) {
    const auto draw = [&](Gl gl) {
      ball(gl, {0, 0.1f, {0.7f, 0.7f, 0.2f, 1}});
      blendBy(gl, f);
      gl.DepthMask(writes);
      for (const Ball& b : kBalls) ball(gl, b);
      gl.BlendEquation(GL_FUNC_ADD), gl.BlendFunc(GL_ZERO, GL_ONE), gl.DepthMask(GL_TRUE);
    };
    int images = 0;
    auto fails = std::make_unique<present::TracingPresenter>(
        frame::Tracer{[&](const scene::Snapshot&, Image&, scene::TraceCost&, std::string& why) {
          ++images;
          return why = "this test lets tracing fail", false;
        }});
    compareBoth(theStage(), writes ? "failing, writing" : "failing", draw, std::move(fails));
    EXPECT_GT(images, 0);
  }
}

}  // namespace
}  // namespace gluray::test::drawn_layers
