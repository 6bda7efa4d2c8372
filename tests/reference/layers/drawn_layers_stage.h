// A stage for fixed-function surfaces that are blended in the order of drawing, for tests.
#pragma once
#include "scenes/stage.h"
#include "tests/reference/both.h"

#include <GL/glext.h>

#include <array>
#include <string>

namespace gluray::test::drawn_layers {

using namespace scenes;

constexpr int kWidth = 120, kHeight = 90;

inline BothStage theStage() {
  return {kWidth, kHeight, "drawn_layers", [](Gl gl) {
            begin(gl, kWidth, kHeight, {0.4f, 0.6f, 0.2f, 0.5f});
            camera(gl, kWidth, kHeight);
            keyLight(gl);
          }};
}

/// Expects that all of its draws are traced.
inline void expectTraced(const std::string& name, const Draw& draw, uint64_t traced) {
  const gl::Statistics counted = compareBoth(theStage(), name, draw);
  EXPECT_EQ(counted.drawsTraced, traced) << name;
  EXPECT_EQ(counted.drawsRasterised, 0u) << name;
}

struct Ball {
  float x, z;
  Color color;
  float size = 0.8f;
};

inline void ball(Gl gl, const Ball& b) {
  paint(gl, b.color[0], b.color[1], b.color[2]);
  material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, b.color);
  sendAt(gl, sphere(16, 24), b.x, 0, b.z, b.size);
}

/// Left and near, in the middle, right and far; the last is opaque.
inline const std::array<Ball, 3> kBalls = {Ball{-0.5f, 0.6f, {0.9f, 0.2f, 0.1f, 0.3f}},
                                           Ball{0, 0, {0.2f, 0.8f, 0.3f, 0.6f}},
                                           Ball{0.5f, -0.6f, {0.2f, 0.3f, 0.9f, 1}}};

inline void blendOver(Gl gl) {
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

struct Function {
  const char* name;
  GLenum source, destination, sourceAlpha, destinationAlpha;
  GLenum equation = GL_FUNC_ADD, equationAlpha = GL_FUNC_ADD;
};

inline const Function kFunctions[] = {
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

inline void blendBy(Gl gl, const Function& f) {
  gl.Enable(GL_BLEND);
  gl.BlendColor(0.3f, 0.6f, 0.8f, 0.4f);
  gl.BlendEquationSeparate(f.equation, f.equationAlpha);
  gl.BlendFuncSeparate(f.source, f.destination, f.sourceAlpha, f.destinationAlpha);
}

}  // namespace gluray::test::drawn_layers
