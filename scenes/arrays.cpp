// Vertex arrays: client memory and buffers, all element types, strides, interleaved formats, range and multi
// draws.
#include "scenes/families.h"
#include "scenes/stage.h"

#include <cmath>
#include <cstring>

namespace gluray::scenes {
namespace {

void arrayStage(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  gl.Enable(GL_NORMALIZE);
}

/// Byte normals, double positions, ushort indices, ubyte colours.
void oldTypes(Gl gl, int width, int height) {
  arrayStage(gl, width, height);
  gl.Enable(GL_COLOR_MATERIAL);
  const Model m = torus(0.8f, 0.4f, 40, 20);
  std::vector<GLdouble> positions(m.positions.begin(), m.positions.end());
  std::vector<GLbyte> normals;
  for (const float n : m.normals) normals.push_back(static_cast<GLbyte>(n * 127));
  std::vector<GLushort> indices(m.indices.begin(), m.indices.end());
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(3, GL_DOUBLE, 0, positions.data());
  gl.NormalPointer(GL_BYTE, 0, normals.data());
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, m.colors.data());
  gl.Rotatef(-40, 1, 0, 0);
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_SHORT, indices.data());
  gl.DisableClientState(GL_VERTEX_ARRAY);
  gl.DisableClientState(GL_NORMAL_ARRAY);
  gl.DisableClientState(GL_COLOR_ARRAY);
}

/// Integer positions of two coordinates, float colours of three, glArrayElement.
void arrayElements(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  gl.Scalef(0.01f, 0.01f, 1);
  const GLshort corners[][2] = {{-90, -80}, {90, -80}, {0, 80}, {-120, 30}, {120, 30}};
  const GLfloat colors[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}};
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(2, GL_SHORT, 0, corners);
  gl.ColorPointer(3, GL_FLOAT, 0, colors);
  gl.Begin(GL_TRIANGLES);
  for (GLint i : {0, 1, 2}) gl.ArrayElement(i);
  gl.End();
  const GLubyte second[] = {3, 4, 0};
  gl.Translatef(0, 0, -1);
  gl.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, second);
}

/// One client array, rewritten between the draws, all of them within one list.
void rewrittenArray(Gl gl, int width, int height) {
  arrayStage(gl, width, height);
  paint(gl, 0.9f, 0.8f, 0.3f);
  struct Vertex {
    float position[3], normal[3], unused[4];
  };
  static_assert(sizeof(Vertex) == 40);
  std::vector<Vertex> strip(14);
  GLushort order[14];
  for (GLushort i = 0; i < 14; ++i) order[i] = i;
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), strip[0].position);
  gl.NormalPointer(GL_FLOAT, sizeof(Vertex), strip[0].normal);
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  const Model m = torus(0.9f, 0.3f, 48, 6);
  for (uint32_t c = 0; c < 48; ++c) {
    for (uint32_t i = 0; i < 14; ++i) {
      const uint32_t v = i / 2 * 49 + c + 1 - i % 2;
      std::memcpy(strip[i].position, &m.positions[v * 3], sizeof strip[i].position);
      std::memcpy(strip[i].normal, &m.normals[v * 3], sizeof strip[i].normal);
    }
    gl.DrawElements(GL_TRIANGLE_STRIP, 14, GL_UNSIGNED_SHORT, order);
  }
  gl.EndList();
  std::memset(strip.data(), 0, strip.size() * sizeof(Vertex));
  gl.Rotatef(-30, 1, 0, 0);
  gl.CallList(list);
}

void interleaved(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  const Model m = sheet(24);
  std::vector<float> data;  // GL_C4F_N3F_V3F
  for (uint32_t i = 0; i < m.vertexCount(); ++i) {
    for (uint32_t k = 0; k < 4; ++k) data.push_back(static_cast<float>(m.colors[i * 4 + k]) / 255.0f);
    data.insert(data.end(), &m.normals[i * 3], &m.normals[i * 3] + 3);
    data.insert(data.end(), &m.positions[i * 3], &m.positions[i * 3] + 3);
  }
  gl.InterleavedArrays(GL_C4F_N3F_V3F, 0, data.data());
  gl.Rotatef(-50, 1, 0, 0);
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(m.indices.size()), GL_UNSIGNED_INT, m.indices.data());
}

/// Pointers latch the buffer that is bound when they are set; buffers change after.
void vertexBuffers(Gl gl, int width, int height) {
  arrayStage(gl, width, height);
  paint(gl, 0.4f, 0.7f, 0.9f);
  const Model m = vase(40, 24);
  const auto bytes = static_cast<GLsizeiptr>(m.positions.size() * sizeof(float));
  GLuint names[3];
  gl.GenBuffers(3, names);
  gl.BindBuffer(GL_ARRAY_BUFFER, names[0]);
  gl.BufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_DYNAMIC_DRAW);
  gl.BufferSubData(GL_ARRAY_BUFFER, 0, bytes, m.positions.data());
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
  gl.BindBuffer(GL_ARRAY_BUFFER, names[1]);
  gl.BufferData(GL_ARRAY_BUFFER, bytes, m.normals.data(), GL_STATIC_DRAW);
  gl.NormalPointer(GL_FLOAT, 0, nullptr);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[2]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(m.indices.size() * 4), m.indices.data(),
                GL_STATIC_DRAW);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);
  const auto count = static_cast<GLsizei>(m.indices.size());
  gl.PushMatrix();
  gl.Translatef(-0.8f, 0, 0);
  gl.DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
  gl.PopMatrix();
  // Squeeze the model by writing into the mapped buffer.
  gl.BindBuffer(GL_ARRAY_BUFFER, names[0]);
  auto* mapped = static_cast<float*>(gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY));
  if (mapped)
    for (size_t i = 0; i < m.positions.size(); ++i) mapped[i] = m.positions[i] * (i % 3 == 1 ? 0.5f : 1.0f);
  gl.UnmapBuffer(GL_ARRAY_BUFFER);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.Translatef(0.8f, 0, 0);
  const auto half = static_cast<uintptr_t>(count / 6 * 3) * 4;
  gl.DrawElements(GL_TRIANGLES, count - count / 6 * 3, GL_UNSIGNED_INT, reinterpret_cast<const void*>(half));
}

/// glMultiDrawArrays, glMultiDrawElements, glDrawRangeElements, base vertices, instances.
void multiDraws(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height, 3.5f);
  const Model m = sheet(20);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, m.positions.data());
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, m.colors.data());
  gl.Rotatef(-50, 1, 0, 0);
  // Rows of the sheet: quads by elements, every second one.
  std::vector<GLsizei> counts;
  std::vector<const void*> starts;
  for (size_t row = 0; row < 20; row += 2)
    counts.push_back(120), starts.push_back(m.indices.data() + row * 120);
  gl.MultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, starts.data(),
                       static_cast<GLsizei>(counts.size()));
  gl.Translatef(0, 0, 0.5f);
  gl.Scalef(0.5f, 0.5f, 0.5f);
  gl.DrawRangeElements(GL_TRIANGLES, 0, 62, 120, GL_UNSIGNED_INT, m.indices.data());
  gl.DrawElementsBaseVertex(GL_TRIANGLES, 120, GL_UNSIGNED_INT, m.indices.data(), 21 * 5);
  // Three rounds, each a fan of its own.
  std::vector<float> rounds;
  for (int i = 0; i < 36; ++i) {
    const float angle = 0.5236f * static_cast<float>(i % 12);
    rounds.insert(rounds.end(), {-1.5f + 1.5f * static_cast<float>(i / 12) + 0.5f * std::cos(angle),
                                 0.5f * std::sin(angle), 1 + 0.2f * std::sin(angle)});
  }
  gl.DisableClientState(GL_COLOR_ARRAY);
  gl.Color3f(0.9f, 0.7f, 0.2f);
  gl.VertexPointer(3, GL_FLOAT, 0, rounds.data());
  const GLint firsts[] = {0, 12, 24};
  const GLsizei numbers[] = {12, 11, 10};
  gl.MultiDrawArrays(GL_TRIANGLE_FAN, firsts, numbers, 3);
}

void vertexArrayObjects(Gl gl, int width, int height) {
  arrayStage(gl, width, height);
  const Model models[] = {sphere(20, 30), torus(0.7f, 0.3f, 30, 16)};
  GLuint arrays[2], buffers[6];
  gl.GenVertexArrays(2, arrays);
  gl.GenBuffers(6, buffers);
  for (int i = 0; i < 2; ++i) {
    gl.BindVertexArray(arrays[i]);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers[i * 3]);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(models[i].positions.size() * 4),
                  models[i].positions.data(), GL_STATIC_DRAW);
    gl.VertexPointer(3, GL_FLOAT, 12, nullptr);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers[i * 3 + 1]);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(models[i].normals.size() * 4),
                  models[i].normals.data(), GL_STATIC_DRAW);
    gl.NormalPointer(GL_FLOAT, 12, nullptr);
    gl.EnableClientState(GL_NORMAL_ARRAY);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[i * 3 + 2]);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(models[i].indices.size() * 4),
                  models[i].indices.data(), GL_STATIC_DRAW);
  }
  gl.BindVertexArray(0);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  for (int i = 0; i < 4; ++i) {
    gl.BindVertexArray(arrays[i % 2]);
    paint(gl, 0.3f * static_cast<float>(i), 0.7f, 0.4f);
    gl.PushMatrix();
    gl.Translatef(-1.5f + static_cast<float>(i), 0, 0);
    gl.Scalef(0.45f, 0.45f, 0.45f);
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(models[i % 2].indices.size()), GL_UNSIGNED_INT,
                    nullptr);
    gl.PopMatrix();
  }
}

/// Quads and strips by glDrawArrays, with a constant colour and texture coordinates in shorts.
void drawArraysKinds(Gl gl, int width, int height) {
  begin(gl, width, height);
  flatCamera(gl, width, height);
  const GLfloat strip[][3] = {{-1.2f, -0.8f, 0}, {-1.2f, 0.8f, 0}, {-0.8f, -0.7f, 0.3f}, {-0.8f, 0.7f, 0.3f},
                              {-0.4f, -0.8f, 0}, {-0.4f, 0.8f, 0}, {0, -0.7f, 0.3f},     {0, 0.7f, 0.3f}};
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, strip);
  gl.Color3f(0.9f, 0.4f, 0.1f);
  gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 6);
  gl.Color3f(0.1f, 0.4f, 0.9f);
  gl.Translatef(0.6f, 0, 0);
  gl.DrawArrays(GL_QUAD_STRIP, 2, 6);
  const GLfloat quads[][3] = {{-0.4f, -0.8f, 0.3f}, {0, -0.8f, 0}, {0, -0.1f, 0},   {-0.4f, -0.1f, 0.3f},
                              {-0.4f, 0.1f, 0},     {0, 0.2f, 0},  {0, 0.8f, 0.3f}, {-0.4f, 0.7f, 0.3f}};
  gl.VertexPointer(3, GL_FLOAT, 0, quads);
  gl.Color3f(0.1f, 0.8f, 0.3f);
  gl.Translatef(0.1f, 0, 0.5f);
  gl.DrawArrays(GL_QUADS, 0, 4);
  gl.Color3f(0.8f, 0.8f, 0.1f);
  gl.DrawArrays(GL_POLYGON, 4, 4);
}

constexpr Scene kArrayScenes[] = {
    {"old-array-types", oldTypes},
    {"array-elements", arrayElements},
    {"rewritten-array", rewrittenArray},
    {"interleaved-arrays", interleaved},
    {"vertex-buffers", vertexBuffers},
    {"multi-draws", multiDraws},
    {"vertex-array-objects", vertexArrayObjects},
    {"draw-arrays-kinds", drawArraysKinds},
};

}  // namespace

std::span<const Scene> arrayScenes() { return kArrayScenes; }

}  // namespace gluray::scenes
