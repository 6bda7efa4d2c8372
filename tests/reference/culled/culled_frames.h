// Frames drawn with whole and with culled draws, and compared to the bit.
#pragma once
#include "tests/reference/programs/program_stage.h"
#include "tests/support/gl_state.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace gluray::test::culled {

inline constexpr int kSide = 200;  // pixels

inline Settings culling(Culling how) {
  Settings settings = TracedContext::tracing();
  settings.cull.draws = how, settings.cull.from = 300;
  return settings;
}

/// Balls in each other, whose surfaces wave.
inline ProgramMesh shells(int count, int n) {
  ProgramMesh all;
  for (int k = 0; k < count; ++k) {
    const ProgramMesh one = ball(n);
    const auto first = static_cast<GLuint>(all.positions.size());
    for (size_t i = 0; i < one.positions.size(); ++i) {
      const glm::vec3 p = one.positions[i];
      const float wave = 1 + 0.05f * std::sin(11 * p.x + k) * std::sin(9 * p.y) * std::sin(7 * p.z);
      all.positions.push_back((1 - 0.12f * static_cast<float>(k)) * wave * p);
      all.normals.push_back(one.normals[i]);
    }
    for (const GLuint i : one.indices) all.indices.push_back(first + i);
  }
  return all;
}

/// Each triangle twice, far apart in the draw.
inline ProgramMesh twice(ProgramMesh mesh) {
  const size_t vertices = mesh.positions.size(), corners = mesh.indices.size();
  for (size_t i = 0; i < vertices; ++i)
    mesh.positions.push_back(mesh.positions[i]), mesh.normals.push_back(mesh.normals[i]);
  for (size_t i = 0; i < corners; i += 3)
    for (size_t c = 0; c < 3; ++c)
      mesh.indices.push_back(mesh.indices[(i + 3 * 1234) % corners + c] + static_cast<GLuint>(vertices));
  return mesh;
}

struct Buffers {
  GLuint array = 0, positions = 0, indices = 0;
};

inline Buffers send(Gl gl, const ProgramMesh& mesh, GLuint program) {
  Buffers b;
  gl.GenVertexArrays(1, &b.array), gl.BindVertexArray(b.array);
  const auto put = [&](const char* name, const std::vector<glm::vec3>& values) {
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(glm::vec3)), values.data(),
                  GL_STATIC_DRAW);
    const GLint location = gl.GetAttribLocation(program, name);
    if (location < 0) return buffer;
    gl.EnableVertexAttribArray(static_cast<GLuint>(location));
    gl.VertexAttribPointer(static_cast<GLuint>(location), 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    return buffer;
  };
  b.positions = put("position", mesh.positions);
  put("normal", mesh.normals);
  gl.GenBuffers(1, &b.indices), gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, b.indices);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(GLuint)),
                mesh.indices.data(), GL_STATIC_DRAW);
  return b;
}

inline void turn(Gl gl, GLuint program, int frame) {
  const glm::mat4 clip = glm::perspective(glm::radians(40.0f), 1.0f, 0.5f, 20.0f);
  glm::mat4 eye = glm::translate(glm::mat4(1), glm::vec3(0.1f, 0, -4));
  eye = glm::rotate(eye, glm::radians(7.0f * static_cast<float>(frame)),
                    glm::normalize(glm::vec3(0.3f, 1, 0.2f)));
  setMat4(gl, program, "clipFromEye", clip), setMat4(gl, program, "eyeFromObject", eye);
}

inline void clear(Gl gl) {
  gl.Viewport(0, 0, kSide, kSide);
  gl.ClearColor(0.2f, 0.3f, 0.4f, 1), gl.ClearDepth(1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST), gl.DepthFunc(GL_LESS);
}

/// The first few pixels that differ, in words.
/// Depth function GEQUAL, which is not traced.
inline void drawByFixedFunction(Gl gl, const ProgramMesh& mesh, int frame, GLenum mode,
                                const std::vector<GLuint>& indices) {
  clear(gl);
  gl.ClearDepth(0), gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.DepthRange(1, 0), gl.DepthFunc(GL_GEQUAL);
  for (const GLenum on : {GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE, GL_POLYGON_STIPPLE}) gl.Enable(on);
  std::array<GLubyte, 128> stipple;
  for (size_t i = 0; i < stipple.size(); ++i) stipple[i] = static_cast<GLubyte>(0xF5 ^ 13 * i);
  gl.PolygonStipple(stipple.data());
  gl.MatrixMode(GL_PROJECTION), gl.LoadIdentity(), gl.Frustum(-0.2, 0.2, -0.2, 0.2, 0.5, 20);
  gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity(), gl.Translatef(0.1f, 0, -4);
  gl.Rotatef(7.0f * static_cast<float>(frame), 0.3f, 1, 0.2f);
  gl.EnableClientState(GL_VERTEX_ARRAY), gl.EnableClientState(GL_NORMAL_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, mesh.positions.data());
  gl.NormalPointer(GL_FLOAT, 0, mesh.normals.data());
  gl.DrawElements(mode, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, indices.data());
}

inline std::string whereDifferent(const DrawnImage& a, const DrawnImage& b) {
  std::ostringstream words;
  words << std::hex;
  int count = 0;
  for (size_t i = 0; i < a.colors.size(); ++i) {
    if ((a.colors[i] == b.colors[i] && a.depths[i] == b.depths[i]) || ++count > 8) continue;
    words << "(" << std::dec << i % kSide << ", " << i / kSide << std::hex << ") colour " << a.colors[i]
          << " / " << b.colors[i] << ", depth " << a.depths[i] << " / " << b.depths[i] << "\n";
  }
  words << std::dec << count << " pixels";
  return words.str();
}

inline DrawnImage readWindow(Gl gl) { return readImage(gl, kSide, kSide); }

/// An image and state after each frame.
using Frames = std::vector<std::pair<DrawnImage, GlState>>;

inline void expectSameFrames(const std::string& name, const Frames& whole, const Frames& culled) {
  for (size_t i = 0; i < whole.size(); ++i) {
    SCOPED_TRACE(name + ", frame " + std::to_string(i));
    for (const std::string& line : differences(whole[i].second, culled[i].second)) ADD_FAILURE() << line;
    const bool same =
        whole[i].first.colors == culled[i].first.colors && whole[i].first.depths == culled[i].first.depths;
    EXPECT_TRUE(same) << whereDifferent(whole[i].first, culled[i].first);
    if (!same) writeFailure(TEST_OUTPUT "/culled", name + std::to_string(i), whole[i].first, culled[i].first);
  }
}

/// Images, which `read` reads, and state after each frame, with draws whole and culled. Returns the counts
/// of the latter.
inline gl::Statistics compareFrames(const std::string& name, int frames,
                                    const std::function<void(Gl)>& prepare,
                                    const std::function<void(Gl, int)>& draw,
                                    const Settings* settings = nullptr,
                                    const ContextWish& wish = {kSide, kSide, true, 3, 2},
                                    const std::function<DrawnImage(Gl)>& read = readWindow) {
  const auto seen = [&](Culling how, gl::Statistics* counts) {
    TracedContext context(wish, counts && settings ? *settings : culling(how));
    Frames all;
    Gl gl = context.gl();
    prepare(gl);
    for (int frame = 0; frame < frames; ++frame) {
      draw(gl, frame);
      EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
      GlState state = queryState(gl);
      all.emplace_back(read(gl), std::move(state));
    }
    if (counts) *counts = context.context().counts.statistics;
    return all;
  };
  gl::Statistics counts;
  const auto whole = seen(Culling::off, nullptr), culled = seen(Culling::always, &counts);
  expectSameFrames(name, whole, culled);
  return counts;
}

}  // namespace gluray::test::culled
