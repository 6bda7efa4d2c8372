#include "bench/client/paths.h"

#include <stdexcept>

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

namespace gluray::bench {
namespace {

void sendVertices(const TriangleMesh& mesh) {
  for (const uint32_t index : mesh.indices) {
    glNormal3fv(&mesh.normals[index].x);
    glVertex3fv(&mesh.positions[index].x);
  }
}

void sendCorners(const TriangleMesh& mesh) {
  glBegin(GL_TRIANGLES);
  sendVertices(mesh);
  glEnd();
}

void sendPieces(const MeshPieces& pieces) {
  glBegin(GL_TRIANGLES);
  pieces.forEach(sendVertices);
  glEnd();
}

/// Draws with normals, vertices and indices at the given places: memory, or offsets into bound buffers.
void sendElements(size_t indexCount, const void* positions, const void* normals, const void* indices) {
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, positions);
  glNormalPointer(GL_FLOAT, 0, normals);
  glDrawElements(GL_TRIANGLES, GLsizei(indexCount), GL_UNSIGNED_INT, indices);
  glDisableClientState(GL_NORMAL_ARRAY);
  glDisableClientState(GL_VERTEX_ARRAY);
}

void sendIndexed(const TriangleMesh& mesh) {
  sendElements(mesh.indices.size(), mesh.positions.data(), mesh.normals.data(), mesh.indices.data());
}

class ListPath : public DrawPath {
 public:
  template <typename Geometry>
  ListPath(Geometry mesh, void (*send)(const Geometry&)) : list_(glGenLists(1)) {
    glNewList(list_, GL_COMPILE);
    send(mesh);
    glEndList();
  }
  ~ListPath() override { glDeleteLists(list_, 1); }
  void draw() override { glCallList(list_); }

 private:
  GLuint list_;
};

class MemoryPath : public DrawPath {
 public:
  MemoryPath(TriangleMesh mesh, void (*send)(const TriangleMesh&)) : mesh_(std::move(mesh)), send_(send) {}
  void draw() override { send_(mesh_); }

 private:
  TriangleMesh mesh_;
  void (*send_)(const TriangleMesh&);
};

class BufferPath : public DrawPath {
 public:
  explicit BufferPath(TriangleMesh mesh) : indexCount_(mesh.indices.size()) {
    glGenBuffers(3, buffers_);
    upload(GL_ARRAY_BUFFER, buffers_[0], mesh.positions);
    upload(GL_ARRAY_BUFFER, buffers_[1], mesh.normals);
    upload(GL_ELEMENT_ARRAY_BUFFER, buffers_[2], mesh.indices);
  }
  explicit BufferPath(const MeshPieces& pieces) : indexCount_(3 * pieces.size.triangles) {
    glGenBuffers(3, buffers_);
    makeRoom(GL_ARRAY_BUFFER, buffers_[0], pieces.size.vertices * sizeof(Vertex));
    makeRoom(GL_ARRAY_BUFFER, buffers_[1], pieces.size.vertices * sizeof(Vertex));
    makeRoom(GL_ELEMENT_ARRAY_BUFFER, buffers_[2], indexCount_ * sizeof(uint32_t));
    size_t vertices = 0, indices = 0;
    pieces.forEach([&](const TriangleMesh& piece) {
      fill(GL_ARRAY_BUFFER, buffers_[0], vertices, piece.positions);
      fill(GL_ARRAY_BUFFER, buffers_[1], vertices, piece.normals);
      LargeArray<uint32_t> numbers = piece.indices;
      for (uint32_t& number : numbers) number += uint32_t(vertices);
      fill(GL_ELEMENT_ARRAY_BUFFER, buffers_[2], indices, numbers);
      vertices += piece.positions.size(), indices += numbers.size();
    });
  }
  ~BufferPath() override { glDeleteBuffers(3, buffers_); }
  void draw() override {
    // The pointers are latched one by one: each takes the buffer bound at its call.
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    glVertexPointer(3, GL_FLOAT, 0, nullptr);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
    glNormalPointer(GL_FLOAT, 0, nullptr);
    glDrawElements(GL_TRIANGLES, GLsizei(indexCount_), GL_UNSIGNED_INT, nullptr);
  }

 private:
  template <typename T>
  static void upload(GLenum target, GLuint buffer, const LargeArray<T>& data) {
    glBindBuffer(target, buffer);
    glBufferData(target, GLsizeiptr(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
  }
  static void makeRoom(GLenum target, GLuint buffer, size_t bytes) {
    glBindBuffer(target, buffer);
    glBufferData(target, GLsizeiptr(bytes), nullptr, GL_STATIC_DRAW);
  }
  /// Elements from number `first` on.
  template <typename T>
  static void fill(GLenum target, GLuint buffer, size_t first, const LargeArray<T>& data) {
    glBindBuffer(target, buffer);
    glBufferSubData(target, GLintptr(first * sizeof(T)), GLsizeiptr(data.size() * sizeof(T)), data.data());
  }
  size_t indexCount_;
  GLuint buffers_[3] = {};
};

/// Follows a function that moves vertices.
constexpr const char* kVertexShader = R"(
varying vec3 place, toEye, normal;
void main() {
  vec4 vertex = moved(gl_Vertex);
  place = 0.05 * vertex.xyz;
  toEye = -(gl_ModelViewMatrix * vertex).xyz;
  normal = gl_NormalMatrix * gl_Normal;
  gl_Position = gl_ModelViewProjectionMatrix * vertex;
})";
constexpr const char* kAtRest = "#version 120\nvec4 moved(vec4 vertex) { return vertex; }";
constexpr const char* kInWaves = R"(#version 120
vec4 moved(vec4 vertex) {
  return vec4(vertex.xyz + 0.2 * sin(0.7 * vertex.yzx) * sin(0.9 * vertex.zxy), 1.0);
})";
constexpr const char* kFragmentShader = R"(#version 120
varying vec3 place, toEye, normal;
float rings(vec3 p) { return fract(length(p.xz + 0.3 * sin(p.yx)) + 0.2 * sin(3.0 * p.y)); }
void main() {
  vec3 n = normalize(normal), v = normalize(toEye);
  vec3 wood = mix(vec3(0.45, 0.25, 0.1), vec3(0.9, 0.7, 0.45), rings(place));
  vec3 color = 0.1 * wood;
  for (int i = 0; i < 3; ++i) {
    vec3 l = normalize(vec3(float(i) - 1.0, 0.6, 1.0));
    vec3 h = normalize(l + v);
    color += 0.35 * (wood * abs(dot(n, l)) + pow(abs(dot(n, h)), 40.0));
  }
  gl_FragColor = vec4(color, 1.0);
})";

/// The buffers drawn by a program whose fragments have three lights and a pattern, and which may move
/// vertices.
class ShaderPath : public DrawPath {
 public:
  ShaderPath(TriangleMesh mesh, const std::string& moved)
      : buffers_(std::move(mesh)), program_(glCreateProgram()) {
    attach(GL_VERTEX_SHADER, (moved + kVertexShader).c_str());
    attach(GL_FRAGMENT_SHADER, kFragmentShader);
    glLinkProgram(program_);
    GLint linked = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (!linked) throw std::runtime_error("OpenGL does not link the shaders");
  }
  ~ShaderPath() override { glDeleteProgram(program_); }
  void draw() override {
    glUseProgram(program_);
    buffers_.draw();
    glUseProgram(0);
  }

 private:
  void attach(GLenum type, const char* text) {
    const GLuint shader = glCreateShader(type);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program_, shader);
    glDeleteShader(shader);
  }
  BufferPath buffers_;
  GLuint program_;
};

std::unique_ptr<DrawPath> makeUnchecked(const std::string& name, TriangleMesh&& mesh) {
  if (name == "list") return std::make_unique<ListPath>(std::move(mesh), sendCorners);
  if (name == "elements") return std::make_unique<ListPath>(std::move(mesh), sendIndexed);
  if (name == "vbo") return std::make_unique<BufferPath>(std::move(mesh));
  if (name == "shader") return std::make_unique<ShaderPath>(std::move(mesh), kAtRest);
  if (name == "waves") return std::make_unique<ShaderPath>(std::move(mesh), kInWaves);
  if (name == "arrays") return std::make_unique<MemoryPath>(std::move(mesh), sendIndexed);
  if (name == "immediate") return std::make_unique<MemoryPath>(std::move(mesh), sendCorners);
  throw std::runtime_error("no path '" + name + "'");
}

std::unique_ptr<DrawPath> checked(std::unique_ptr<DrawPath> path) {
  if (glGetError() == GL_OUT_OF_MEMORY) throw std::runtime_error("OpenGL has no memory for the mesh");
  return path;
}

}  // namespace

const std::vector<std::string>& pathNames() {
  static const std::vector<std::string> names{"list",   "elements", "vbo",        "arrays",     "immediate",
                                              "shader", "waves",    "vbo-pieces", "list-pieces"};
  return names;
}

bool takesPieces(const std::string& name) { return name == "vbo-pieces" || name == "list-pieces"; }

std::unique_ptr<DrawPath> makePath(const std::string& name, TriangleMesh&& mesh) {
  return checked(makeUnchecked(name, std::move(mesh)));
}

std::unique_ptr<DrawPath> makePath(const std::string& name, const MeshPieces& pieces) {
  if (name == "vbo-pieces") return checked(std::make_unique<BufferPath>(pieces));
  if (name == "list-pieces") return checked(std::make_unique<ListPath>(pieces, sendPieces));
  throw std::runtime_error("path '" + name + "' takes no pieces");
}

}  // namespace gluray::bench
