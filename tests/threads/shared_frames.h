// Frames of two threads, whose contexts share objects, and whether their images are right.
#pragma once
#include "tests/support/traced_context.h"

#include <GL/gl.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <thread>

namespace gluray::test {

using Gl = const gl::RealGl&;

constexpr int kSize = 16, kFrames = 400;
/// How often the thread that does not draw must act before the other stops drawing, so that both act at once
/// however late it starts.
constexpr int kActs = 20;
constexpr GLuint kSharedList = 1, kSharedBuffer = 1;

/// A colour that identifies thread and frame.
inline std::array<GLubyte, 4> colorOf(int thread, int frame) {
  return {static_cast<GLubyte>(frame % 2 ? 255 : 60), static_cast<GLubyte>(thread ? 200 : 20),
          static_cast<GLubyte>(frame % 200), 255};
}

// Rectangles of two triangles at different depths; more than the whole image where `size` is 1.
inline std::array<GLfloat, 18> rectangle(float size) {
  const float s = size * 1.2f;
  return {-s, -s, 0.1f, s, -s, 0.2f, s, s, 0.3f, -s, -s, 0.1f, s, s, 0.3f, -s, s, 0.2f};
}

inline void sendRectangle(Gl gl, float size) {
  const auto positions = rectangle(size);
  gl.Begin(GL_TRIANGLES);
  for (size_t i = 0; i < positions.size(); i += 3) gl.Vertex3fv(&positions[i]);
  gl.End();
}

inline void startFrame(Gl gl) {
  gl.Viewport(0, 0, kSize, kSize);
  gl.Enable(GL_DEPTH_TEST);
  gl.ClearColor(0, 0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// Whether every pixel has this colour, give or take a step.
inline bool isAll(Gl gl, const std::array<GLubyte, 4>& color) {
  std::array<GLubyte, kSize * kSize * 4> pixels{};
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  for (size_t i = 0; i < pixels.size(); ++i)
    if (std::abs(pixels[i] - color[i % 4]) > 1) return false;
  return true;
}

/// Makes, uses and deletes lists and buffers of its own; only draws from shared objects of the group.
inline void drawFrame(Gl gl, int thread, int frame) {
  const auto color = colorOf(thread, frame);
  startFrame(gl);
  gl.Color4ubv(color.data());
  switch (frame % 4) {
    case 0: {
      const GLuint list = gl.GenLists(2);
      gl.NewList(list, GL_COMPILE), sendRectangle(gl, 1), gl.EndList();
      gl.NewList(list + 1, GL_COMPILE), gl.CallList(list), gl.EndList();
      gl.CallList(list + 1);
      gl.DeleteLists(list, 2);
      break;
    }
    case 1: {
      const auto positions = rectangle(1);
      GLuint buffer = 0;
      gl.GenBuffers(1, &buffer);
      gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
      gl.BufferData(GL_ARRAY_BUFFER, sizeof positions, nullptr, GL_STREAM_DRAW);
      if (void* mapped = gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY)) {
        std::memcpy(mapped, positions.data(), sizeof positions);
        gl.UnmapBuffer(GL_ARRAY_BUFFER);
      }
      gl.EnableClientState(GL_VERTEX_ARRAY);
      gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
      gl.DrawArrays(GL_TRIANGLES, 0, 6);
      const GLfloat moved = 0.15f;  // the mesh of the earlier draw must not change
      gl.BufferSubData(GL_ARRAY_BUFFER, 2 * sizeof(GLfloat), sizeof moved, &moved);
      gl.DisableClientState(GL_VERTEX_ARRAY);
      gl.DeleteBuffers(1, &buffer);
      break;
    }
    case 2: gl.CallList(kSharedList); break;
    default:
      gl.BindBuffer(GL_ARRAY_BUFFER, kSharedBuffer);
      gl.EnableClientState(GL_VERTEX_ARRAY);
      gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
      // Rasterised every other time, which sends the buffer.
      if (frame % 8 == 3) gl.Enable(GL_STENCIL_TEST);
      gl.DrawArrays(GL_TRIANGLES, 0, 6);
      gl.Disable(GL_STENCIL_TEST), gl.DisableClientState(GL_VERTEX_ARRAY);
      gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  }
  gl.Finish();
}

inline int wrongFrames(Gl gl, int thread) {
  int wrong = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    drawFrame(gl, thread, frame);
    wrong += !isAll(gl, colorOf(thread, frame));
  }
  return wrong;
}

inline void makeSharedObjects(Gl gl) {
  const auto positions = rectangle(1);
  gl.NewList(kSharedList, GL_COMPILE), sendRectangle(gl, 1), gl.EndList();
  gl.BindBuffer(GL_ARRAY_BUFFER, kSharedBuffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof positions, positions.data(), GL_STATIC_DRAW);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
}

/// Whether a thread that has drawn `frame` frames goes on, while another has acted `acts` times.
inline bool goesOn(int frame, const std::atomic<int>& acts) { return frame < kFrames || acts < kActs; }

/// Runs `body(thread)` in two threads.
inline void inTwoThreads(const std::function<void(int)>& body) {
  std::thread first([&] { body(0); }), second([&] { body(1); });
  first.join(), second.join();
}

}  // namespace gluray::test
