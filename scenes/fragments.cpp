// What happens to fragments after texturing: secondary colours, fog, and the alpha test where it leaves
// holes.
#include "scenes/families.h"
#include "scenes/stage.h"

#include <cmath>

namespace gluray::scenes {
namespace {

void fogged(Gl gl, int width, int height, GLenum mode) {
  begin(gl, width, height, {0.5f, 0.6f, 0.7f, 1});
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.9f, 0.4f, 0.2f);
  material(gl, GL_FRONT_AND_BACK, GL_SPECULAR, {1, 1, 1, 1});
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 30);
  const float color[] = {0.5f, 0.6f, 0.7f, 1};
  gl.Enable(GL_FOG);
  gl.Fogi(GL_FOG_MODE, static_cast<GLint>(mode));
  gl.Fogfv(GL_FOG_COLOR, color);
  gl.Fogf(GL_FOG_START, 3);
  gl.Fogf(GL_FOG_END, 6);
  gl.Fogf(GL_FOG_DENSITY, mode == GL_EXP ? 0.2f : 0.25f);
  for (int i = 0; i < 5; ++i)
    sendAt(gl, torus(0.8f, 0.3f, 40, 20), -1.2f + 0.6f * static_cast<float>(i), 0,
           1.0f - static_cast<float>(i), 0.8f);
}

void fogLinear(Gl gl, int width, int height) { fogged(gl, width, height, GL_LINEAR); }
void fogExp(Gl gl, int width, int height) { fogged(gl, width, height, GL_EXP); }
void fogExp2(Gl gl, int width, int height) { fogged(gl, width, height, GL_EXP2); }

/// Fog that is switched, recoloured and thinned between draws of one frame, over unlit vertex colours.
void fogChanges(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  const float red[] = {0.6f, 0.1f, 0.1f, 1}, blue[] = {0.1f, 0.1f, 0.6f, 1};
  gl.Fogi(GL_FOG_MODE, GL_EXP);
  const Model m = sphere(20, 30);
  for (int i = 0; i < 4; ++i) {
    if (i == 1) gl.Enable(GL_FOG);
    gl.Fogfv(GL_FOG_COLOR, i % 2 ? red : blue);
    gl.Fogf(GL_FOG_DENSITY, 0.1f * static_cast<float>(i));
    sendAt(gl, m, -1.2f + 0.8f * static_cast<float>(i), 0.3f, -0.5f * static_cast<float>(i), 0.5f, kColors);
  }
}

/// Fog by coordinates: of each vertex, from an array, and one for all; the distance does not matter.
/// Never negative: of those Mesa takes the magnitude.
void fogCoordinates(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.9f, 0.7f, 0.2f);
  const float color[] = {0.2f, 0.3f, 0.6f, 1};
  gl.Enable(GL_FOG);
  gl.Fogi(GL_FOG_MODE, GL_LINEAR), gl.Fogf(GL_FOG_START, 0), gl.Fogf(GL_FOG_END, 2);
  gl.Fogfv(GL_FOG_COLOR, color);
  gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  const Model m = torus(0.5f, 0.2f, 30, 16);
  gl.PushMatrix();
  gl.Translatef(-0.9f, 0, 0);
  gl.Begin(GL_TRIANGLES);
  for (const uint32_t i : m.indices) {
    gl.Normal3fv(&m.normals[i * 3]);
    gl.FogCoordf(1 + 1.5f * m.positions[i * 3]);
    gl.Vertex3fv(&m.positions[i * 3]);
  }
  gl.End();
  gl.PopMatrix();
  std::vector<float> heights;
  for (size_t v = 0; v < m.vertexCount(); ++v) heights.push_back(1 + 1.3f * m.positions[v * 3 + 1]);
  gl.VertexPointer(3, GL_FLOAT, 0, m.positions.data()), gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.NormalPointer(GL_FLOAT, 0, m.normals.data()), gl.EnableClientState(GL_NORMAL_ARRAY);
  gl.FogCoordPointer(GL_FLOAT, 0, heights.data()), gl.EnableClientState(GL_FOG_COORD_ARRAY);
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(m.indices.size()), GL_UNSIGNED_INT, m.indices.data());
  gl.DisableClientState(GL_FOG_COORD_ARRAY);
  gl.FogCoordf(0.8f);
  sendAt(gl, m, 0.9f, 0, -1, 1);
}

/// Secondary colours of each vertex, added after a texture; from an array; and one for all, smooth and flat.
void secondaryColors(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Enable(GL_COLOR_SUM);
  const Model m = torus(0.45f, 0.2f, 30, 16);
  const GLubyte texels[] = {40, 40, 90, 255, 160, 120, 40, 255, 30, 140, 60, 255, 90, 90, 90, 255};
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  const auto glowing = [&](float x, float y, GLenum model) {
    gl.ShadeModel(model);
    gl.PushMatrix();
    gl.Translatef(x, y, 0);
    gl.Begin(GL_TRIANGLES);
    for (const uint32_t i : m.indices) {
      gl.TexCoord2fv(&m.texcoords[i * 2]);
      gl.SecondaryColor3f(0.5f + m.positions[i * 3], 0, 0.5f + m.positions[i * 3 + 1]);
      gl.Vertex3fv(&m.positions[i * 3]);
    }
    gl.End();
    gl.PopMatrix();
  };
  glowing(-1, 0.5f, GL_SMOOTH);
  glowing(0, 0.5f, GL_FLAT);
  gl.ShadeModel(GL_SMOOTH);
  gl.SecondaryColor3f(0, 0.4f, 0);
  sendAt(gl, m, 1, 0.5f, 0, 1, kTexcoords);
  std::vector<GLubyte> glow;
  for (size_t v = 0; v < m.vertexCount(); ++v)
    for (const size_t step : {7, 3, 1}) glow.push_back(static_cast<GLubyte>(v * step % 128));
  gl.PushMatrix();
  gl.Translatef(-1, -0.6f, 0.3f);
  gl.VertexPointer(3, GL_FLOAT, 0, m.positions.data()), gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.SecondaryColorPointer(3, GL_UNSIGNED_BYTE, 0, glow.data()),
      gl.EnableClientState(GL_SECONDARY_COLOR_ARRAY);
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(m.indices.size()), GL_UNSIGNED_INT, m.indices.data());
  gl.DisableClientState(GL_SECONDARY_COLOR_ARRAY);
  gl.PopMatrix();
  keyLight(gl);  // with lighting the secondary colour is the light's
  sendAt(gl, m, 0, -0.6f, 0.3f, 1);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  material(gl, GL_FRONT_AND_BACK, GL_SPECULAR, {0.9f, 0.9f, 0.9f, 1});
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 12);
  sendAt(gl, m, 1, -0.6f, 0.3f, 1);
}

/// A texture of `size` x `size` texels whose alpha falls from 1 in the middle of each of 4 x 4 cells.
GLuint cellTexture(Gl gl, int size) {
  std::vector<uint8_t> texels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const float u = 4 * (static_cast<float>(x) + 0.5f) / static_cast<float>(size),
                  v = 4 * (static_cast<float>(y) + 0.5f) / static_cast<float>(size);
      const float du = u - std::floor(u) - 0.5f, dv = v - std::floor(v) - 0.5f;
      const float alpha = 1 - 2 * std::sqrt(du * du + dv * dv);
      const uint8_t texel[] = {static_cast<uint8_t>(60 + 40 * (static_cast<int>(u) % 4)),
                               static_cast<uint8_t>(60 + 40 * (static_cast<int>(v) % 4)), 90,
                               static_cast<uint8_t>(255 * std::max(alpha, 0.0f))};
      texels.insert(texels.end(), texel, texel + 4);
    }
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.Enable(GL_TEXTURE_2D);
  return name;
}

/// Sheets with holes one behind the other, each with a comparison of its own.
void holes(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  const GLuint texture = cellTexture(gl, 256);
  gl.Enable(GL_ALPHA_TEST);
  const Model m = sheet(12);
  const GLenum functions[] = {GL_GREATER, GL_LESS, GL_GEQUAL, GL_LEQUAL};
  for (int i = 0; i < 4; ++i) {
    gl.AlphaFunc(functions[i], i % 2 ? 0.35f : 0.5f);
    paint(gl, 0.9f, 0.9f - 0.2f * static_cast<float>(i), 0.5f + 0.15f * static_cast<float>(i));
    gl.PushMatrix();
    gl.Translatef(0.15f * static_cast<float>(i), 0.1f * static_cast<float>(i),
                  0.8f - 0.5f * static_cast<float>(i));
    gl.Rotatef(-50 + 8 * static_cast<float>(i), 1, 0, 0);
    send(gl, m, kNormals | kTexcoords);
    gl.PopMatrix();
  }
  gl.DeleteTextures(1, &texture);
}

/// Alpha from vertex colours and materials; a surface that fails everywhere hides nothing.
void alphaOfColors(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 0.4f);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 12; ++i) {
    const float turn = 0.5236f * static_cast<float>(i), next = turn + 0.45f;
    gl.Color4f(0.9f, 0.8f, 0.2f, 1);
    gl.Vertex3f(0, 0, 0.5f);
    gl.Color4f(0.9f, 0.2f, 0.2f, 0.1f);
    gl.Vertex3f(1.3f * std::cos(turn), 1.3f * std::sin(turn), -0.2f);
    gl.Color4f(0.2f, 0.2f, 0.9f, 0.6f);
    gl.Vertex3f(1.3f * std::cos(next), 1.3f * std::sin(next), 0.3f);
  }
  gl.End();
  keyLight(gl);
  material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.2f, 0.9f, 0.3f, 0.3f});
  sendAt(gl, sphere(16, 24), 0.3f, 0, 1.2f, 0.4f);
  material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.2f, 0.9f, 0.3f, 0.5f});
  sendAt(gl, sphere(16, 24), -0.5f, 0, 0.8f, 0.3f);
  gl.AlphaFunc(GL_NEVER, 0);
  sendAt(gl, sphere(16, 24), 0, 0, 1.8f, 0.6f);
}

constexpr Tolerance kHoleEdges{2, 0.004, 1e-5f,
                               "the edges of holes go through pixels by a rounding of alpha"};

/// Fog by coordinates and by distance in turn, in one batch.
void fogSources(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  const float color[] = {0.2f, 0.3f, 0.6f, 1};
  gl.Enable(GL_FOG);
  gl.Fogi(GL_FOG_MODE, GL_LINEAR), gl.Fogf(GL_FOG_START, 0), gl.Fogf(GL_FOG_END, 6);
  gl.Fogfv(GL_FOG_COLOR, color);
  gl.FogCoordf(1.5f);
  for (int i = 0; i < 4; ++i) {
    gl.Fogi(GL_FOG_COORD_SRC, i % 2 ? GL_FRAGMENT_DEPTH : GL_FOG_COORD);
    paint(gl, 0.9f, 0.7f, 0.2f * static_cast<float>(i));
    sendAt(gl, sphere(16, 24), static_cast<float>(i) - 1.5f, 0, -0.5f * static_cast<float>(i), 0.45f);
  }
  gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
}

constexpr Scene kFragmentScenes[] = {
    {"fog-linear", fogLinear},
    {"fog-exp", fogExp},
    {"fog-coordinates", fogCoordinates},
    {"fog-sources", fogSources},
    {"secondary-colors", secondaryColors},
    {"fog-exp2", fogExp2},
    {"fog-changes", fogChanges},
    {"holes", holes, true, kHoleEdges},
    {"alpha-of-colors", alphaOfColors, true, kHoleEdges},
};

}  // namespace

std::span<const Scene> fragmentScenes() { return kFragmentScenes; }

}  // namespace gluray::scenes
