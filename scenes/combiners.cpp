// GL_COMBINE, and several texture units: coordinates of each from every kind of vertex data.
#include "scenes/families.h"
#include "scenes/stage.h"
#include "scenes/texels.h"

#include <array>
#include <cstddef>

namespace gluray::scenes {
namespace {

void combinerStage(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  upload(gl, GL_RGBA, 16, GL_LINEAR, GL_REPEAT);
}

void env(Gl gl, GLenum name, GLint value) { gl.TexEnvi(GL_TEXTURE_ENV, name, value); }

/// One part of the combiner.
struct Part {
  GLint function;
  std::array<GLint, 3> sources{GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT};
  std::array<GLint, 3> operands{GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA};
  GLint scale = 1;
};
void rgb(Gl gl, const Part& part) {
  env(gl, GL_COMBINE_RGB, part.function);
  for (GLenum i = 0; i < 3; ++i) {
    env(gl, GL_SOURCE0_RGB + i, part.sources[i]);
    env(gl, GL_OPERAND0_RGB + i, part.operands[i]);
  }
  env(gl, GL_RGB_SCALE, part.scale);
}
void alpha(Gl gl, const Part& part) {
  env(gl, GL_COMBINE_ALPHA, part.function);
  for (GLenum i = 0; i < 3; ++i) {
    env(gl, GL_SOURCE0_ALPHA + i, part.sources[i]);
    env(gl, GL_OPERAND0_ALPHA + i, part.operands[i]);
  }
  env(gl, GL_ALPHA_SCALE, part.scale);
}

constexpr std::array<GLint, 3> kAlphas{GL_SRC_ALPHA, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};

/// Functions down, base formats across; alpha is what the read-back compares.
void functions(Gl gl, int width, int height) {
  combinerStage(gl, width, height);
  env(gl, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  const float color[] = {0.9f, 0.3f, 0.6f, 0.7f};
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
  const GLint formats[] = {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA};
  const GLint all[] = {GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT};
  gl.Color4f(0.4f, 0.7f, 0.5f, 0.8f);
  for (int f = 0; f < 6; ++f) {
    bindFresh(gl, GL_TEXTURE_2D);
    upload(gl, formats[f], 16, GL_LINEAR, GL_REPEAT);
    for (int e = 0; e < 6; ++e) {
      rgb(gl, {all[e]});
      alpha(gl, {all[e], {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT}, kAlphas});
      quad(gl, -1.0f + 0.4f * static_cast<float>(f), -0.8f + 0.32f * static_cast<float>(e), 0.15f, 0, 1);
    }
  }
}

/// Every source and operand.
void sources(Gl gl, int width, int height) {
  combinerStage(gl, width, height);
  env(gl, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  const float color[] = {0.9f, 0.3f, 0.6f, 0.7f};
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
  gl.Color4f(0.4f, 0.7f, 0.5f, 0.8f);
  const GLint from[] = {GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};
  const GLint operands[] = {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
  for (int s = 0; s < 4; ++s)
    for (int o = 0; o < 4; ++o) {
      rgb(gl, {GL_MODULATE, {from[s], GL_TEXTURE, GL_TEXTURE}, {operands[o], GL_SRC_COLOR, GL_SRC_COLOR}});
      alpha(gl,
            {GL_REPLACE, {from[s], GL_TEXTURE, GL_TEXTURE}, {operands[o | 2], GL_SRC_ALPHA, GL_SRC_ALPHA}});
      quad(gl, -0.9f + 0.6f * static_cast<float>(s), -0.72f + 0.48f * static_cast<float>(o), 0.22f, 0, 1);
    }
}

/// Scales, and the scalar products.
void scales(Gl gl, int width, int height) {
  combinerStage(gl, width, height);
  sampling(gl, GL_TEXTURE_2D, GL_NEAREST, GL_REPEAT);  // scales would magnify eight-bit weights
  env(gl, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  gl.Color4f(0.55f, 0.35f, 0.7f, 0.6f);
  const GLint all[] = {GL_MODULATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
  for (int f = 0; f < 4; ++f)
    for (int s = 0; s < 3; ++s) {
      const std::array<GLint, 3> operands{GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_COLOR};
      rgb(gl, {all[f], {GL_TEXTURE, GL_PRIMARY_COLOR, GL_TEXTURE}, operands, 1 << s});
      alpha(
          gl,
          {f == 1 ? GL_SUBTRACT : GL_MODULATE, {GL_TEXTURE, GL_PRIMARY_COLOR, GL_TEXTURE}, kAlphas, 4 >> s});
      quad(gl, -0.9f + 0.6f * static_cast<float>(f), -0.65f + 0.65f * static_cast<float>(s), 0.28f, 0, 1);
    }
}

/// Texture unit `unit` on, with a texture of its own.
void unit(Gl gl, GLenum number, GLint format, int size, GLint filter, GLint mode) {
  gl.ActiveTexture(GL_TEXTURE0 + number);
  bindFresh(gl, GL_TEXTURE_2D);
  upload(gl, format, size, filter, GL_REPEAT);
  gl.Enable(GL_TEXTURE_2D);
  env(gl, GL_TEXTURE_ENV_MODE, mode);
}

/// Sends a square whose units 0, 1 ... have coordinates of their own.
void layeredQuad(Gl gl, float x, float y, float half, GLenum units) {
  gl.Begin(GL_QUADS);
  for (int i = 0; i < 4; ++i) {
    const float s = i == 1 || i == 2 ? 1 : 0, t = i >= 2 ? 1 : 0;
    for (GLenum u = 0; u < units; ++u) {
      const auto n = static_cast<float>(u);
      gl.MultiTexCoord2f(GL_TEXTURE0 + u, s * (1 + n) + 0.13f * n, t * (1 + 0.5f * n) - 0.2f * n);
    }
    gl.Vertex2f(x + (2 * s - 1) * half, y + (2 * t - 1) * half);
  }
  gl.End();
}

void units(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  gl.Color4f(0.9f, 0.8f, 0.7f, 1);
  const GLint modes[] = {GL_MODULATE, GL_ADD, GL_DECAL, GL_BLEND, GL_REPLACE};
  const GLint formats[] = {GL_RGB, GL_LUMINANCE, GL_RGBA, GL_INTENSITY, GL_ALPHA};
  for (int i = 0; i < 5; ++i) {
    unit(gl, 0, GL_RGB, 16, GL_LINEAR, GL_MODULATE);
    unit(gl, 1, formats[i], 8, GL_NEAREST, modes[i]);
    const float x = -0.8f + 0.8f * static_cast<float>(i % 3), y = i < 3 ? 0.45f : -0.45f;
    layeredQuad(gl, x, y, 0.36f, 2);
  }
  // The second unit alone, and the first with the current coordinates of the second.
  gl.ActiveTexture(GL_TEXTURE0), gl.Disable(GL_TEXTURE_2D);
  gl.ActiveTexture(GL_TEXTURE1), env(gl, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  layeredQuad(gl, 0.8f, -0.45f, 0.36f, 2);
}

/// All eight units at once, in order.
void eightUnits(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  for (GLenum i = 0; i < 8; ++i)
    unit(gl, i, GL_RGBA, 8 + 4 * static_cast<int>(i), i % 2 ? GL_LINEAR : GL_NEAREST,
         i % 3 == 2 ? GL_DECAL : GL_MODULATE);
  gl.MatrixMode(GL_TEXTURE);
  gl.Rotatef(30, 0, 0, 1);
  gl.MatrixMode(GL_MODELVIEW);
  layeredQuad(gl, 0, 0, 0.8f, 8);
}

/// Each unit reads the textures of the others.
void crossbar(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  unit(gl, 0, GL_RGBA, 8, GL_NEAREST, GL_COMBINE);
  rgb(gl, {GL_REPLACE, {GL_TEXTURE1, GL_TEXTURE, GL_TEXTURE}});
  unit(gl, 1, GL_RGB, 16, GL_LINEAR, GL_COMBINE);
  rgb(gl, {GL_INTERPOLATE, {GL_TEXTURE0, GL_PREVIOUS, GL_TEXTURE0}});
  layeredQuad(gl, -0.65f, 0, 0.5f, 2);
  alpha(gl, {GL_REPLACE, {GL_TEXTURE0, GL_TEXTURE0, GL_TEXTURE0}, kAlphas});
  layeredQuad(gl, 0.65f, 0, 0.5f, 2);
}

struct LayeredVertex {
  float st[2], uv[3], position[3];
};
std::vector<LayeredVertex> layeredFan() {
  std::vector<LayeredVertex> fan;
  for (int i = 0; i < 6; ++i) {
    const auto a = static_cast<float>(i);
    const float x = 0.4f * (i % 3 == 0 ? 1.0f : -0.5f + 0.3f * a), y = 0.15f * a - 0.4f;
    fan.push_back({{x * 2, y}, {y, 3 * x, 1}, {x, y, 0}});
  }
  return fan;
}

void layeredArrays(Gl gl, const void* first) {
  const auto* base = static_cast<const char*>(first);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, sizeof(LayeredVertex), base + offsetof(LayeredVertex, position));
  gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
  gl.TexCoordPointer(2, GL_FLOAT, sizeof(LayeredVertex), base + offsetof(LayeredVertex, st));
  gl.ClientActiveTexture(GL_TEXTURE1);
  gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
  gl.TexCoordPointer(3, GL_FLOAT, sizeof(LayeredVertex), base + offsetof(LayeredVertex, uv));
  gl.ClientActiveTexture(GL_TEXTURE0);
}

/// Two units from glBegin, arrays, elements, buffers, lists of each, and the current coordinates.
void unitsFromArrays(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  unit(gl, 0, GL_RGB, 16, GL_LINEAR, GL_MODULATE);
  unit(gl, 1, GL_RGB, 4, GL_NEAREST, GL_ADD);
  gl.ActiveTexture(GL_TEXTURE0);
  const auto fan = layeredFan();
  const auto place = [&](float x, float y) {
    gl.LoadIdentity(), gl.Rotatef(20, 0, 1, 0), gl.Translatef(x, y, 0);
  };
  const GLuint order[] = {0, 1, 2, 2, 3, 4, 4, 5, 0};
  place(-0.85f, 0.4f);
  layeredArrays(gl, fan.data());
  gl.DrawArrays(GL_TRIANGLES, 0, 6);
  place(0, 0.4f);
  gl.DrawElements(GL_TRIANGLES, 9, GL_UNSIGNED_INT, order);
  const GLuint list = gl.GenLists(2);
  gl.NewList(list, GL_COMPILE), gl.DrawElements(GL_TRIANGLES, 9, GL_UNSIGNED_INT, order), gl.EndList();
  place(0.85f, 0.4f), gl.CallList(list);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(fan.size() * sizeof(LayeredVertex)), fan.data(),
                GL_STATIC_DRAW);
  layeredArrays(gl, nullptr);
  std::vector<GLuint> many;
  for (int i = 0; i < 300; ++i) many.push_back(order[i % 9]);
  place(-0.85f, -0.5f), gl.DrawElements(GL_TRIANGLES, 300, GL_UNSIGNED_INT, many.data());
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_TEXTURE_COORD_ARRAY}) gl.DisableClientState(array);
  gl.ClientActiveTexture(GL_TEXTURE1), gl.DisableClientState(GL_TEXTURE_COORD_ARRAY);
  gl.NewList(list + 1, GL_COMPILE), layeredQuad(gl, 0, 0, 0.35f, 2), gl.EndList();
  place(0, -0.4f), gl.CallList(list + 1);
  gl.MultiTexCoord2f(GL_TEXTURE1, 0.4f, 0.7f);
  place(0.85f, -0.4f), layeredQuad(gl, 0, 0, 0.35f, 1);
}

constexpr Scene kCombinerScenes[] = {
    {"combine-functions", functions, true, kTexelEdges},
    {"combine-sources", sources, true, kTexelEdges},
    {"combine-scales", scales, true, kTexelEdges},
    {"combine-crossbar", crossbar, true, kTexelEdges},
    {"two-units", units, true, kTexelEdges},
    {"eight-units", eightUnits, true, kTexelEdges},
    {"units-from-arrays", unitsFromArrays, true, kTexelEdges},
};

}  // namespace

std::span<const Scene> combinerScenes() { return kCombinerScenes; }

}  // namespace gluray::scenes
