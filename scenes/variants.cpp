// One model, one camera, one light, sent in every way that OpenGL offers.
#include "scenes/stage.h"

namespace gluray::scenes {
namespace {

/// A model whose coordinates survive every array type unchanged: positions are multiples of 1/64 within [-1,
/// 1].
const Model& model() {
  static const Model kModel = [] {
    Model m = torus(0.7f, 0.29f, 15, 14);  // 240 vertices: ubyte indices reach them all
    for (float& x : m.positions)
      x = static_cast<float>(static_cast<int>(x * 64 + (x < 0 ? -0.5f : 0.5f))) / 64;
    return m;
  }();
  return kModel;
}
GLsizei count() { return static_cast<GLsizei>(model().indices.size()); }

void variantStage(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  gl.Enable(GL_NORMALIZE);
  gl.Enable(GL_COLOR_MATERIAL);
  gl.Rotatef(-30, 1, 0, 0);
}

void pointers(Gl gl, const void* positions, const void* normals, const void* colors) {
  for (GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY}) gl.EnableClientState(array);
  gl.VertexPointer(3, GL_FLOAT, 0, positions);
  gl.NormalPointer(GL_FLOAT, 0, normals);
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, colors);
}
void clientPointers(Gl gl) {
  pointers(gl, model().positions.data(), model().normals.data(), model().colors.data());
}

GLuint buffer(Gl gl, GLenum target, const void* data, size_t bytes) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  gl.BindBuffer(target, name);
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  return name;
}

/// All of the model in one buffer.
void bufferPointers(Gl gl) {
  const Model& m = model();
  const size_t p = m.positions.size() * 4, n = m.normals.size() * 4, c = m.colors.size();
  buffer(gl, GL_ARRAY_BUFFER, nullptr, p + n + c);
  gl.BufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(p), m.positions.data());
  gl.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(p), static_cast<GLsizeiptr>(n), m.normals.data());
  gl.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(p + n), static_cast<GLsizeiptr>(c),
                   m.colors.data());
  pointers(gl, nullptr, reinterpret_cast<void*>(p), reinterpret_cast<void*>(p + n));
}

/// The model without sharing of vertices, for glDrawArrays.
Model soup() {
  const Model& m = model();
  Model s;
  for (const uint32_t i : m.indices) {
    s.positions.insert(s.positions.end(), &m.positions[i * 3], &m.positions[i * 3] + 3);
    s.normals.insert(s.normals.end(), &m.normals[i * 3], &m.normals[i * 3] + 3);
    s.colors.insert(s.colors.end(), &m.colors[i * 4], &m.colors[i * 4] + 4);
  }
  return s;
}

void immediate(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  send(gl, model(), kNormals | kColors);
}
void immediatePairs(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  const Model& m = model();
  for (size_t t = 0; t < m.indices.size(); t += 3) {
    gl.Begin(GL_TRIANGLES);
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t i = m.indices[t + k];
      gl.Normal3f(m.normals[i * 3], m.normals[i * 3 + 1], m.normals[i * 3 + 2]);
      gl.Color4ub(m.colors[i * 4], m.colors[i * 4 + 1], m.colors[i * 4 + 2], m.colors[i * 4 + 3]);
      gl.Vertex3d(m.positions[i * 3], m.positions[i * 3 + 1], m.positions[i * 3 + 2]);
    }
    gl.End();
  }
}
GLuint list(Gl gl, GLenum mode) {
  const GLuint name = gl.GenLists(1);
  gl.NewList(name, mode);
  send(gl, model(), kNormals | kColors);
  gl.EndList();
  return name;
}
void displayList(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  gl.CallList(list(gl, GL_COMPILE));
}
void nestedList(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  const GLuint inner = list(gl, GL_COMPILE), outer = gl.GenLists(1);
  gl.NewList(outer, GL_COMPILE);
  gl.CallList(inner);
  gl.EndList();
  gl.CallList(outer);
}
void compileExecute(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  list(gl, GL_COMPILE_AND_EXECUTE);
}
void clientArrays(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  const Model s = soup();
  pointers(gl, s.positions.data(), s.normals.data(), s.colors.data());
  gl.DrawArrays(GL_TRIANGLES, 0, count());
}
void clientElements32(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  clientPointers(gl);
  gl.DrawElements(GL_TRIANGLES, count(), GL_UNSIGNED_INT, model().indices.data());
}
void clientElements16(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  clientPointers(gl);
  const std::vector<GLushort> indices(model().indices.begin(), model().indices.end());
  gl.DrawElements(GL_TRIANGLES, count(), GL_UNSIGNED_SHORT, indices.data());
}
void clientElements8(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  clientPointers(gl);
  const std::vector<GLubyte> indices(model().indices.begin(), model().indices.end());
  gl.DrawElements(GL_TRIANGLES, count(), GL_UNSIGNED_BYTE, indices.data());
}
void rangeElements(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  clientPointers(gl);
  gl.DrawRangeElements(GL_TRIANGLES, 0, model().vertexCount() - 1, count(), GL_UNSIGNED_INT,
                       model().indices.data());
}
void multiElements(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  clientPointers(gl);
  const GLsizei counts[] = {count() / 6 * 3, count() - count() / 6 * 3};
  const void* starts[] = {model().indices.data(), model().indices.data() + counts[0]};
  gl.MultiDrawElements(GL_TRIANGLES, counts, GL_UNSIGNED_INT, starts, 2);
}
void doublePositions(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  clientPointers(gl);
  const std::vector<GLdouble> positions(model().positions.begin(), model().positions.end());
  gl.VertexPointer(3, GL_DOUBLE, 0, positions.data());
  gl.DrawElements(GL_TRIANGLES, count(), GL_UNSIGNED_INT, model().indices.data());
}
void strided(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  const Model& m = model();
  struct Vertex {
    float normal[3];
    GLubyte color[4];
    float position[3], unused;
  };
  std::vector<Vertex> data(m.vertexCount());
  for (uint32_t i = 0; i < m.vertexCount(); ++i)
    for (uint32_t k = 0; k < 3; ++k) {
      data[i].position[k] = m.positions[i * 3 + k];
      data[i].normal[k] = m.normals[i * 3 + k];
      data[i].color[k] = m.colors[i * 4 + k];
      data[i].color[3] = 255;
    }
  pointers(gl, nullptr, nullptr, nullptr);
  gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), data[0].position);
  gl.NormalPointer(GL_FLOAT, sizeof(Vertex), data[0].normal);
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), data[0].color);
  gl.DrawElements(GL_TRIANGLES, count(), GL_UNSIGNED_INT, m.indices.data());
}
void elementsOneByOne(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  clientPointers(gl);
  gl.Begin(GL_TRIANGLES);
  for (const uint32_t i : model().indices) gl.ArrayElement(static_cast<GLint>(i));
  gl.End();
}
void arraysInList(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  const GLuint name = gl.GenLists(1);
  {
    const Model copy = model();
    pointers(gl, copy.positions.data(), copy.normals.data(), copy.colors.data());
    gl.NewList(name, GL_COMPILE);
    gl.DrawElements(GL_TRIANGLES, count(), GL_UNSIGNED_INT, copy.indices.data());
    gl.EndList();
  }
  for (GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY}) gl.DisableClientState(array);
  gl.CallList(name);
}
void vbo(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  bufferPointers(gl);
  gl.DrawElements(GL_TRIANGLES, count(), GL_UNSIGNED_INT, model().indices.data());
}
void vboWithIndices(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  bufferPointers(gl);
  buffer(gl, GL_ELEMENT_ARRAY_BUFFER, model().indices.data(), model().indices.size() * 4);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.DrawElements(GL_TRIANGLES, count(), GL_UNSIGNED_INT, nullptr);
}
void vertexArrayObject(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  GLuint name = 0;
  gl.GenVertexArrays(1, &name);
  gl.BindVertexArray(name);
  bufferPointers(gl);
  buffer(gl, GL_ELEMENT_ARRAY_BUFFER, model().indices.data(), model().indices.size() * 4);
  gl.BindVertexArray(0);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.BindVertexArray(name);
  gl.DrawElements(GL_TRIANGLES, count(), GL_UNSIGNED_INT, nullptr);
}
void interleavedArrays(Gl gl, int width, int height) {
  variantStage(gl, width, height);
  const Model& m = model();
  std::vector<float> data;  // GL_C4F_N3F_V3F
  for (uint32_t i = 0; i < m.vertexCount(); ++i) {
    for (uint32_t k = 0; k < 4; ++k) data.push_back(static_cast<float>(m.colors[i * 4 + k]) / 255.0f);
    data.insert(data.end(), &m.normals[i * 3], &m.normals[i * 3] + 3);
    data.insert(data.end(), &m.positions[i * 3], &m.positions[i * 3] + 3);
  }
  gl.InterleavedArrays(GL_C4F_N3F_V3F, 0, data.data());
  gl.DrawElements(GL_TRIANGLES, count(), GL_UNSIGNED_INT, m.indices.data());
}

constexpr Scene kVariants[] = {
    {"variant-immediate", immediate},
    {"variant-immediate-pairs", immediatePairs},
    {"variant-list", displayList},
    {"variant-nested-list", nestedList},
    {"variant-compile-and-execute", compileExecute},
    {"variant-client-arrays", clientArrays},
    {"variant-elements-32", clientElements32},
    {"variant-elements-16", clientElements16},
    {"variant-elements-8", clientElements8},
    {"variant-range-elements", rangeElements},
    {"variant-multi-elements", multiElements},
    {"variant-double-positions", doublePositions},
    {"variant-strided", strided},
    {"variant-array-elements", elementsOneByOne},
    {"variant-arrays-in-list", arraysInList},
    {"variant-vbo", vbo},
    {"variant-vbo-with-indices", vboWithIndices},
    {"variant-vertex-array-object", vertexArrayObject},
    {"variant-interleaved-arrays", interleavedArrays},
};

}  // namespace

std::span<const Scene> variants() { return kVariants; }

}  // namespace gluray::scenes
