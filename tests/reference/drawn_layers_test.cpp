// Fixed-function surfaces that are blended in the order of drawing, with and without depth writes.
#include "intercept/present/tracing_presenter.h"
#include "scenes/stage.h"
#include "tests/reference/both.h"
#include "tests/reference/framebuffer.h"

#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace gluray::test {
namespace {

using namespace scenes;

constexpr int kWidth = 120, kHeight = 90;

BothStage theStage() {
  return {kWidth, kHeight, "drawn_layers", [](Gl gl) {
            begin(gl, kWidth, kHeight, {0.4f, 0.6f, 0.2f, 0.5f});
            camera(gl, kWidth, kHeight);
            keyLight(gl);
          }};
}

/// All that it draws is traced.
void expectTraced(const std::string& name, const Draw& draw, uint64_t traced) {
  const gl::Statistics counted = compareBoth(theStage(), name, draw);
  EXPECT_EQ(counted.drawsTraced, traced) << name;
  EXPECT_EQ(counted.drawsRasterised, 0u) << name;
}

struct Ball {
  float x, z;
  Color color;
  float size = 0.8f;
};

void ball(Gl gl, const Ball& b) {
  paint(gl, b.color[0], b.color[1], b.color[2]);
  material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, b.color);
  sendAt(gl, sphere(16, 24), b.x, 0, b.z, b.size);
}

/// Left and near, in the middle, right and far; the last is opaque.
const std::array<Ball, 3> kBalls = {Ball{-0.5f, 0.6f, {0.9f, 0.2f, 0.1f, 0.3f}},
                                    Ball{0, 0, {0.2f, 0.8f, 0.3f, 0.6f}},
                                    Ball{0.5f, -0.6f, {0.2f, 0.3f, 0.9f, 1}}};

void blendOver(Gl gl) {
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

TEST(DrawnLayers, AreBlendedInEveryOrder) {
  std::array<size_t, 3> order{};
  std::iota(order.begin(), order.end(), size_t{0});
  do {
    for (const bool writes : {true, false}) {
      const auto draw = [&](Gl gl) {
        blendOver(gl);
        gl.DepthMask(writes);
        for (const size_t i : order) ball(gl, kBalls[i]);
      };
      const std::string name = "order " + std::to_string(order[0]) + std::to_string(order[1]) +
                               std::to_string(order[2]) + (writes ? " writing" : "");
      expectTraced(name, draw, 3);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(DrawnLayers, AreHiddenByWhatIsOpaque) {
  for (const GLenum function : {GL_LESS, GL_LEQUAL}) {
    const auto draw = [&](Gl gl) {
      gl.DepthFunc(function);
      ball(gl, {0, 0, {0.7f, 0.7f, 0.2f, 1}});
      blendOver(gl);
      gl.DepthMask(GL_FALSE);
      for (const Ball& b : kBalls) ball(gl, {b.x, b.z * 1.5f, {b.color[0], b.color[1], b.color[2], 0.4f}});
    };
    expectTraced(function == GL_LESS ? "less" : "lequal", draw, 4);
  }
}

TEST(DrawnLayers, AndOpaqueOnesTakeTurns) {
  const auto draw = [](Gl gl) {
    blendOver(gl);
    for (int i = 0; i < 4; ++i) {
      const auto at = static_cast<float>(i);
      gl.DepthMask(i % 2 == 0);
      ball(gl, {-0.6f + 0.4f * at, 0.3f * at, {0.9f, 0.2f * at, 0.1f, i % 2 ? 0.5f : 1.0f}, 0.5f});
    }
  };
  expectTraced("turns", draw, 4);
}

struct Function {
  const char* name;
  GLenum source, destination, sourceAlpha, destinationAlpha;
  GLenum equation = GL_FUNC_ADD, equationAlpha = GL_FUNC_ADD;
};

const Function kFunctions[] = {
    {"add", GL_ONE, GL_ONE, GL_ONE, GL_ONE},
    {"weighted add", GL_SRC_ALPHA, GL_ONE, GL_SRC_ALPHA, GL_ONE},
    {"premultiplied", GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA},
    {"alpha apart", GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA},
    {"alpha kept", GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE},
    {"filter", GL_DST_COLOR, GL_ZERO, GL_ZERO, GL_ONE},
    {"filter from here", GL_ZERO, GL_SRC_COLOR, GL_ONE, GL_ZERO},
    {"screen", GL_ONE_MINUS_DST_COLOR, GL_ONE, GL_ONE, GL_ONE_MINUS_SRC_COLOR},
    {"by what is there", GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_DST_ALPHA, GL_ONE},
    {"saturate", GL_SRC_ALPHA_SATURATE, GL_ONE, GL_SRC_ALPHA_SATURATE, GL_ONE},
    {"constant", GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR, GL_CONSTANT_ALPHA,
     GL_ONE_MINUS_CONSTANT_ALPHA},
    {"constant alpha", GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, GL_ONE, GL_ZERO},
    {"smallest", GL_ONE, GL_ONE, GL_ONE, GL_ONE, GL_MIN, GL_MAX},
    {"difference", GL_SRC_ALPHA, GL_ONE, GL_ONE, GL_ONE, GL_FUNC_SUBTRACT, GL_FUNC_ADD},
    {"other difference", GL_SRC_ALPHA, GL_ONE, GL_ZERO, GL_ONE, GL_FUNC_REVERSE_SUBTRACT, GL_FUNC_ADD},
};

void blendBy(Gl gl, const Function& f) {
  gl.Enable(GL_BLEND);
  gl.BlendColor(0.3f, 0.6f, 0.8f, 0.4f);
  gl.BlendEquationSeparate(f.equation, f.equationAlpha);
  gl.BlendFuncSeparate(f.source, f.destination, f.sourceAlpha, f.destinationAlpha);
}

TEST(DrawnLayers, AreBlendedByEveryFunction) {
  for (const Function& f : kFunctions) {
    const auto draw = [&](Gl gl) {
      blendBy(gl, f);
      for (const Ball& b : kBalls) ball(gl, {b.x, b.z, {b.color[0], b.color[1], b.color[2], 0.7f}});
    };
    expectTraced(f.name, draw, 3);
  }
}

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

TEST(DrawnLayers, AreLeftAloneWhereTheFramebufferIsOfAnotherKind) {
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

TEST(DrawnLayers, OfUnlitColorsAndFlatOnes) {
  for (const GLenum model : {GL_SMOOTH, GL_FLAT}) {
    const auto draw = [&](Gl gl) {
      blendOver(gl);
      gl.Disable(GL_LIGHTING);
      gl.ShadeModel(model);
      for (const float z : {-0.4f, 0.4f, 0.0f}) {
        gl.Begin(GL_TRIANGLES);
        gl.Color4f(1, 0, 0, 0.2f), gl.Vertex3f(-1, -1, z - 0.3f);
        gl.Color4f(0, 1, 0, 0.9f), gl.Vertex3f(1, -1, z);
        gl.Color4f(0, 0, 1, 0.5f), gl.Vertex3f(0.3f, 1, z + 0.3f);
        gl.End();
        gl.Rotatef(40, 0, 0, 1);
      }
    };
    expectTraced(model == GL_FLAT ? "flat" : "smooth", draw, 3);
  }
}

TEST(DrawnLayers, OfFacesFarAndNear) {
  const auto draw = [](Gl gl) {
    blendOver(gl);
    gl.DepthMask(GL_FALSE);
    gl.Enable(GL_CULL_FACE);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    for (const GLenum culled : {GL_FRONT, GL_BACK}) {
      gl.CullFace(culled);
      ball(gl, {0, 0, {0.9f, 0.4f, 0.2f, 0.5f}});
    }
  };
  expectTraced("faces", draw, 2);
}

/// A surface whose triangles overlap themselves, unsorted: which ones hide others depends on their order.
TEST(DrawnLayers, OfOneDrawKeepTheOrderOfTheirTriangles) {
  for (const bool writes : {true, false}) {
    for (const bool backwards : {true, false}) {
      const auto draw = [&](Gl gl) {
        blendOver(gl);
        gl.DepthMask(writes);
        gl.Rotatef(35, 1, 0, 0);
        paint(gl, 0.8f, 0.5f, 0.2f);
        material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.8f, 0.5f, 0.2f, 0.45f});
        Model model = torus(0.9f, 0.35f, 30, 16);
        if (backwards) std::reverse(model.indices.begin(), model.indices.end());
        send(gl, model);
      };
      expectTraced(std::string("triangles") + (writes ? " writing" : "") + (backwards ? " backwards" : ""),
                   draw, 1);
    }
  }
}

TEST(DrawnLayers, OfListsAndArrays) {
  const Model model = torus(0.9f, 0.35f, 30, 16);
  for (const bool list : {true, false}) {
    const auto draw = [&](Gl gl) {
      blendOver(gl);
      material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.8f, 0.5f, 0.2f, 0.45f});
      gl.EnableClientState(GL_VERTEX_ARRAY), gl.EnableClientState(GL_NORMAL_ARRAY);
      gl.VertexPointer(3, GL_FLOAT, 0, model.positions.data());
      gl.NormalPointer(GL_FLOAT, 0, model.normals.data());
      if (list) gl.NewList(1, GL_COMPILE);
      gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(model.indices.size()), GL_UNSIGNED_INT,
                      model.indices.data());
      if (list) gl.EndList(), gl.CallList(1);
    };
    expectTraced(list ? "list" : "array", draw, 1);
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
  for (const auto& [zNear, zFar] : {std::pair(0.2, 0.7), std::pair(1.0, 0.0), std::pair(0.5, 0.5)}) {
    const auto draw = [&](Gl gl) {
      blendOver(gl);
      gl.DepthRange(zNear, zFar);
      for (const Ball& b : kBalls) ball(gl, {b.x, b.z, {b.color[0], b.color[1], b.color[2], 0.7f}});
    };
    expectTraced("range " + std::to_string(zNear), draw, 3);
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

TEST(DrawnLayers, OverTheSameSurface) {
  for (const GLenum function : {GL_LESS, GL_LEQUAL}) {
    for (const bool first : {true, false}) {
      const auto draw = [&](Gl gl) {
        gl.DepthFunc(function);
        if (first) blendOver(gl);
        ball(gl, {0, 0, {0.2f, 0.6f, 0.9f, 0.6f}});
        blendOver(gl);
        ball(gl, {0, 0, {0.9f, 0.2f, 0.1f, 0.5f}});
        gl.BlendFunc(GL_ONE, GL_ONE), gl.DepthMask(GL_FALSE);
        ball(gl, {0, 0, {0.1f, 0.2f, 0.1f, 1}});
      };
      compareBoth(theStage(), std::string("same") + (first ? " blended" : "") + std::to_string(function),
                  draw);
    }
  }
}

TEST(DrawnLayers, FadeIntoFogAndFailAlphaTests) {
  const auto draw = [](Gl gl) {
    blendOver(gl);
    gl.Enable(GL_FOG);
    gl.Fogi(GL_FOG_MODE, GL_LINEAR), gl.Fogf(GL_FOG_START, 3), gl.Fogf(GL_FOG_END, 5);
    ball(gl, kBalls[0]);
    gl.Enable(GL_ALPHA_TEST), gl.AlphaFunc(GL_GREATER, 0.5f);
    gl.Disable(GL_LIGHTING);
    gl.Begin(GL_QUADS);
    gl.Color4f(1, 1, 0, 0), gl.Vertex3f(-1, -0.3f, 0.3f), gl.Vertex3f(1, -0.3f, 0.4f);
    gl.Color4f(1, 0, 0, 1), gl.Vertex3f(1, 0.6f, 0.4f), gl.Vertex3f(-1, 0.6f, 0.3f);
    gl.End();
  };
  expectTraced("fog", draw, 2);
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

TEST(DrawnLayers, OfFewTrianglesAreLeftToTheRealOne) {
  BothStage stage = theStage();
  stage.settings.engine = Engine::automatic;
  const auto draw = [](Gl gl) {
    blendOver(gl);
    gl.DepthMask(GL_FALSE);
    ball(gl, kBalls[0]);
    material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, kBalls[1].color);
    send(gl, sphere(340, 340));  // 230,000 triangles
  };
  const gl::Statistics counted = compareBoth(stage, "few", draw);
  EXPECT_EQ(counted.drawsTraced, 1u);
  EXPECT_EQ(counted.rasterisedBecause[static_cast<size_t>(gl::Reason::smallScene)], 1u);
}

/// Many small ones that wait together are not few, once a frame has shown it.
TEST(DrawnLayers, OfManyDrawsAreTracedTogether) {
  BothStage stage = theStage();
  stage.settings.engine = Engine::automatic;
  const auto draw = [&](Gl gl) {
    gl.NewList(1, GL_COMPILE), send(gl, sphere(160, 160)), gl.EndList();  // 50,000 triangles
    for (int frame = 0; frame < 2; ++frame) {
      stage.prepare(gl);
      blendOver(gl);
      gl.DepthMask(GL_FALSE);
      for (int i = 0; i < 5; ++i) {
        const auto at = 0.2f * static_cast<float>(i);
        gl.PushMatrix();
        gl.Translatef(at - 0.4f, 0, 0.4f - at);
        material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {at, 0.7f, 0.3f, 0.4f});
        gl.CallList(1);
        gl.PopMatrix();
      }
      gl.DepthMask(GL_TRUE);
      gl.DepthMask(GL_TRUE);
      gl.Finish();  // ends the frame
    }
  };
  EXPECT_EQ(compareBoth(stage, "many", draw).drawsTraced, 5u);
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
    int pictures = 0;
    auto fails = std::make_unique<present::TracingPresenter>(
        present::Tracer{[&](const scene::Snapshot&, Image&, present::TraceCost&, std::string& why) {
          ++pictures;
          return why = "this test lets tracing fail", false;
        }});
    compareBoth(theStage(), writes ? "failing, writing" : "failing", draw, std::move(fails));
    EXPECT_GT(pictures, 0);
  }
}

}  // namespace
}  // namespace gluray::test
