#include "bench/client/balls.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace gluray::bench {
namespace {

constexpr const char* kUniforms = R"(
uniform mat4 worldFromObject;
uniform vec3 paint;
)";
constexpr const char* kInstances = R"(
in vec4 offset;
in vec3 tint;
#define paint tint
#define worldFromObject \
  mat4(offset.w, 0.0, 0.0, 0.0, 0.0, offset.w, 0.0, 0.0, 0.0, 0.0, offset.w, 0.0, offset.xyz, 1.0)
)";
constexpr const char* kVertexShader = R"(
uniform mat4 clipFromWorld;
uniform vec3 viewer;
in vec3 position, normal;
out vec3 place, toEye, direction, coat;
void main() {
  vec4 world = worldFromObject * vec4(position, 1.0);
  place = 0.3 * position;
  toEye = viewer - world.xyz;
  direction = mat3(worldFromObject) * normal;
  coat = paint;
  gl_Position = clipFromWorld * world;
})";
constexpr const char* kFragmentShader = R"(#version 130
in vec3 place, toEye, direction, coat;
out vec4 color;
void main() {
  vec3 n = normalize(direction), v = normalize(toEye);
  vec3 base = coat * (0.8 + 0.2 * fract(place.x + place.z));
  vec3 sum = 0.1 * base;
  for (int i = 0; i < 3; ++i) {
    vec3 l = normalize(v + vec3(float(i) - 1.0, 0.6, 0.5));
    sum += 0.3 * (base * max(dot(n, l), 0.0) + pow(max(dot(n, normalize(l + v)), 0.0), 40.0));
  }
  color = vec4(sum, 1.0);
})";

void send(GLuint buffer, int side, double phase) {
  std::vector<float> values;
  for (int row = 0; row <= side; ++row)
    for (int column = 0; column <= side; ++column) {
      const double theta = M_PI * row / side, phi = 2 * M_PI * column / side;
      const double n[] = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
      const double r = 0.9 + 0.1 * std::sin(5 * theta + phase) * std::cos(3 * phi);
      for (const double c : n) values.push_back(float(r * c));
      for (const double c : n) values.push_back(float(c));
    }
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(4 * values.size()), values.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(0), glEnableVertexAttribArray(1);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 24, nullptr);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 24, reinterpret_cast<const void*>(12));
}

}  // namespace

Balls::Balls(int side) : count_(6 * side * (side - 1)) {
  std::vector<unsigned short> indices;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const auto at = [&](int r, int c) { return static_cast<unsigned short>(r * (side + 1) + c); };
      const auto add = [&](auto... all) { (indices.push_back(all), ...); };
      if (row > 0) add(at(row, column), at(row + 1, column), at(row, column + 1));
      if (row + 1 < side) add(at(row, column + 1), at(row + 1, column), at(row + 1, column + 1));
    }
  glGenVertexArrays(kMeshes, arrays_.data());
  glGenBuffers(kMeshes, buffers_.data());
  GLuint elements = 0;
  glGenBuffers(1, &elements);
  for (int i = 0; i < kMeshes; ++i) {
    glBindVertexArray(arrays_[size_t(i)]);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, elements);
    if (i == 0)
      glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(2 * indices.size()), indices.data(), GL_STATIC_DRAW);
    send(buffers_[size_t(i)], side, 0.1 * i);
  }
}

void Balls::draw(int mesh) const {
  glBindVertexArray(arrays_[size_t(mesh)]);
  glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_SHORT, nullptr);
}

void Balls::drawInstances(const std::vector<BallPlace>& places) {
  glBindVertexArray(arrays_[0]);
  if (places_ == 0) glGenBuffers(1, &places_);
  glBindBuffer(GL_ARRAY_BUFFER, places_);
  const auto bytes = GLsizeiptr(places.size() * sizeof(BallPlace));
  glBufferData(GL_ARRAY_BUFFER, bytes, places.data(), GL_STREAM_DRAW);
  const auto attribute = [](GLuint location, int size, size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(BallPlace),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(location, 1);
  };
  attribute(2, 4, offsetof(BallPlace, center));
  attribute(3, 3, offsetof(BallPlace, paint));
  glDrawElementsInstanced(GL_TRIANGLES, count_, GL_UNSIGNED_SHORT, nullptr, GLsizei(places.size()));
}

GLuint makeBallProgram(bool instanced) {
  const GLuint program = glCreateProgram();
  const std::string vertex =
      std::string("#version 130\n") + (instanced ? kInstances : kUniforms) + kVertexShader;
  for (const auto& [type, text] :
       {std::pair(GL_VERTEX_SHADER, vertex.c_str()), std::pair(GL_FRAGMENT_SHADER, kFragmentShader)}) {
    const GLuint shader = glCreateShader(GLenum(type));
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  glBindAttribLocation(program, 0, "position");
  glBindAttribLocation(program, 1, "normal");
  glBindAttribLocation(program, 2, "offset");
  glBindAttribLocation(program, 3, "tint");
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) throw std::runtime_error("OpenGL does not link the shaders");
  return program;
}

}  // namespace gluray::bench
