// Many instances of a small mesh, which hide each other, and programs that place them.
#pragma once
#include "tests/reference/culled/culled_programs.h"
#include "tests/reference/culled/sampled_framebuffer.h"

#include <glm/gtc/quaternion.hpp>

#include <random>
#include <string>
#include <vector>

namespace gluray::test::culled {

/// How a program gets the places of instances.
struct Placing {
  const char* name;
  const char* declared;  // attributes of the instance
  const char* world;     // vec3, of `position`
};
inline constexpr Placing kPlacings[]{
    {"matrix", "in mat4 place;", "(place * vec4(position, 1.0)).xyz"},
    {"moved", "in vec4 moved;", "position * moved.w + moved.xyz"},
    {"shifted", "in vec3 shift;", "0.2 * position + shift"},
    {"rows", "in mat3x4 rows;", "vec4(position, 1.0) * rows"},
    {"turned", "in vec4 q, moved;",
     "moved.w * (position + 2.0 * cross(q.xyz, cross(q.xyz, position) + q.w * position)) + moved.xyz"}};

/// The same by functions that are no polynomials: positions come by feedback.
inline constexpr Placing kFedPlacings[]{
    {"waving", "in vec4 moved;",
     "position * moved.w * (1.0 + 0.2 * sin(9.0 * moved.x + 5.0 * position.y)) + moved.xyz"},
    {"facing", "in vec4 moved;",
     "moved.w * (0.8 * position + 0.2 * normalize(moved.xyz + vec3(0.01))) + moved.xyz"},
    {"divided", "in vec3 shift; in vec4 moved;", "0.2 * position / (1.0 + moved.w) + shift"}};

/// With a colour for each instance.
inline std::string vertexOf(const Placing& how) {
  const std::string at = std::string("vec3 world = ") + how.world + ";\n  ";
  std::string text = replacedIn(kCulledVertex, "out vec3 place, n;",
                                std::string(how.declared) + "\nin vec3 tint;\nout vec3 part, n, color;");
  text = replacedIn(text, "place = position;", "part = position;\n  color = tint;\n  " + at);
  return replacedIn(text, "vec4(position, 1.0);\n  gl_Position", "vec4(world, 1.0);\n  gl_Position");
}
inline std::string tintedFragment() {
  std::string text = replacedIn(kCulledFragment, "in vec3 place, n;\nout vec4 color;",
                                "in vec3 part, n, color;\nout vec4 shown;");
  text = replacedIn(text, "wood(place)", "wood(part)");
  return replacedIn(text, "color = vec4(light", "shown = vec4(color * light");
}

/// What each instance has.
struct Swarm {
  std::vector<glm::mat4> matrices;
  std::vector<glm::vec4> moved, q;
  std::vector<glm::vec3> shifts, tints;
  std::vector<float> rows;  // 12 each
  size_t count() const { return matrices.size(); }
};

/// Places on a lattice of `n` in each direction that fills a box, all moved a little.
inline Swarm swarm(int n, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> number(-1, 1);
  Swarm all;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const float step = 2.0f / static_cast<float>(n);
        glm::vec3 at(x, y, z);
        at = step * (at + 0.5f) - 1.0f;
        for (int c = 0; c < 3; ++c) at[c] += 0.1f * step * number(random);
        const float size = 0.75f * step * (1 + 0.1f * number(random)), angle = 3 * number(random);
        const glm::vec3 axis = glm::normalize(glm::vec3(0.3f, 1, 0.2f + at.x));
        const glm::mat4 m = glm::scale(glm::rotate(glm::translate(glm::mat4(1), at), angle, axis),
                                       size * glm::vec3(1, 0.8f, 0.9f));
        all.matrices.push_back(m);
        all.moved.emplace_back(at, size);
        all.q.emplace_back(axis * std::sin(angle / 2), std::cos(angle / 2));
        all.shifts.push_back(at);
        all.tints.push_back(0.5f + 0.5f * at);
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 4; ++c) all.rows.push_back(m[c][r]);
      }
  return all;
}

/// Puts the values of one attribute into a buffer; does nothing where the program has none of that name.
template <class Value>
GLuint sendOfInstances(Gl gl, GLuint program, const char* name, int columns, int rows,
                       const std::vector<Value>& values, GLuint divisor) {
  GLuint buffer = 0;
  const GLint location = gl.GetAttribLocation(program, name);
  if (location < 0) return 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(),
                GL_DYNAMIC_DRAW);
  const size_t column = static_cast<size_t>(rows) * sizeof(float);
  for (int c = 0; c < columns; ++c) {
    const auto at = static_cast<GLuint>(location + c);
    gl.EnableVertexAttribArray(at);
    gl.VertexAttribPointer(at, rows, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(column) * columns,
                           reinterpret_cast<const void*>(static_cast<size_t>(c) * column));
    gl.VertexAttribDivisor(at, divisor);
  }
  return buffer;
}

/// All that a program may want of the swarm, into the bound vertex array object.
inline void sendSwarm(Gl gl, GLuint program, const Swarm& s, GLuint divisor = 1) {
  sendOfInstances(gl, program, "place", 4, 4, s.matrices, divisor);
  sendOfInstances(gl, program, "moved", 1, 4, s.moved, divisor);
  sendOfInstances(gl, program, "q", 1, 4, s.q, divisor);
  sendOfInstances(gl, program, "shift", 1, 3, s.shifts, divisor);
  sendOfInstances(gl, program, "rows", 3, 4, s.rows, divisor);
  sendOfInstances(gl, program, "tint", 1, 3, s.tints, divisor);
}

inline GLsizei countOf(const Swarm& s) { return static_cast<GLsizei>(s.count()); }

}  // namespace gluray::test::culled
