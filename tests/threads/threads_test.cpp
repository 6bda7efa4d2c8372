// Contexts current in several threads at once: of one share group, or of none. Run by the thread sanitizer;
// every picture is checked as well.
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <barrier>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <thread>
#include <vector>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;

constexpr int kSize = 16, kFrames = 400;
/// How often the thread that does not draw must act before the other stops drawing, so that both act at once
/// however late it starts.
constexpr int kActs = 20;
constexpr GLuint kSharedList = 1, kSharedBuffer = 1;

/// A colour that identifies thread and frame.
std::array<GLubyte, 4> colorOf(int thread, int frame) {
  return {static_cast<GLubyte>(frame % 2 ? 255 : 60), static_cast<GLubyte>(thread ? 200 : 20),
          static_cast<GLubyte>(frame % 200), 255};
}

// Rectangles of two triangles at different depths; more than the whole picture where `size` is 1.
std::array<GLfloat, 18> rectangle(float size) {
  const float s = size * 1.2f;
  return {-s, -s, 0.1f, s, -s, 0.2f, s, s, 0.3f, -s, -s, 0.1f, s, s, 0.3f, -s, s, 0.2f};
}

void sendRectangle(Gl gl, float size) {
  const auto positions = rectangle(size);
  gl.Begin(GL_TRIANGLES);
  for (size_t i = 0; i < positions.size(); i += 3) gl.Vertex3fv(&positions[i]);
  gl.End();
}

void startFrame(Gl gl) {
  gl.Viewport(0, 0, kSize, kSize);
  gl.Enable(GL_DEPTH_TEST);
  gl.ClearColor(0, 0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// Whether every pixel has this colour, give or take a step.
bool isAll(Gl gl, const std::array<GLubyte, 4>& color) {
  std::array<GLubyte, kSize * kSize * 4> pixels{};
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  for (size_t i = 0; i < pixels.size(); ++i)
    if (std::abs(pixels[i] - color[i % 4]) > 1) return false;
  return true;
}

/// Makes, uses and deletes lists and buffers of its own; only draws from shared objects of the group.
void drawFrame(Gl gl, int thread, int frame) {
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

int wrongFrames(Gl gl, int thread) {
  int wrong = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    drawFrame(gl, thread, frame);
    wrong += !isAll(gl, colorOf(thread, frame));
  }
  return wrong;
}

void makeSharedObjects(Gl gl) {
  const auto positions = rectangle(1);
  gl.NewList(kSharedList, GL_COMPILE), sendRectangle(gl, 1), gl.EndList();
  gl.BindBuffer(GL_ARRAY_BUFFER, kSharedBuffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof positions, positions.data(), GL_STATIC_DRAW);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
}

/// Whether a thread that has drawn `frame` frames goes on, while another has acted `acts` times.
bool goesOn(int frame, const std::atomic<int>& acts) { return frame < kFrames || acts < kActs; }

/// Runs `body(thread)` in two threads.
void inTwoThreads(const std::function<void(int)>& body) {
  std::thread first([&] { body(0); }), second([&] { body(1); });
  first.join(), second.join();
}

TEST(Threads, ShareGroupDrawsInBothThreads) {
  TracedContext owner({kSize, kSize});
  makeSharedObjects(owner.gl());
  std::array<int, 2> wrong{-1, -1};
  std::array<uint64_t, 2> traced{};
  inTwoThreads([&](int thread) {
    TracedContext context({kSize, kSize}, TracedContext::vertexShading(), nullptr, &owner);
    wrong[static_cast<size_t>(thread)] = wrongFrames(context.gl(), thread);
    traced[static_cast<size_t>(thread)] = context.context().counts.statistics.drawsTraced;
  });
  EXPECT_EQ(wrong, (std::array<int, 2>{0, 0}));
  for (const uint64_t draws : traced) EXPECT_EQ(draws, kFrames - kFrames / 8) << "all but the stencilled";
}

TEST(Threads, UnrelatedContextsDrawAtOnce) {
  std::array<int, 2> wrong{-1, -1};
  inTwoThreads([&](int thread) {
    TracedContext context({kSize, kSize});
    makeSharedObjects(context.gl());
    wrong[static_cast<size_t>(thread)] = wrongFrames(context.gl(), thread);
  });
  EXPECT_EQ(wrong, (std::array<int, 2>{0, 0}));
}

TEST(Threads, ContextsComeAndGoWhileAnotherDraws) {
  TracedContext owner({kSize, kSize});
  makeSharedObjects(owner.gl());
  std::atomic<bool> done = false;
  std::array<int, 2> wrong{-1, 0};
  inTwoThreads([&](int thread) {
    if (thread == 0) {
      TracedContext context({kSize, kSize}, TracedContext::vertexShading(), nullptr, &owner);
      wrong[0] = wrongFrames(context.gl(), thread);
      done = true;
      return;
    }
    constexpr int kMin = 64;
    for (int frame = 0; !done || frame < kMin; ++frame) {
      // Destroyed while its objects remain in the group.
      TracedContext context({kSize, kSize}, TracedContext::vertexShading(), nullptr, &owner);
      Gl gl = context.gl();
      const GLuint list = gl.GenLists(1);
      gl.NewList(list, GL_COMPILE), sendRectangle(gl, 0.5f), gl.EndList();
      drawFrame(gl, thread, frame);
      wrong[1] += !isAll(gl, colorOf(thread, frame));
      gl.DeleteLists(list, 1);
    }
  });
  EXPECT_EQ(wrong, (std::array<int, 2>{0, 0}));
}

TEST(Threads, ListsAreReplacedWhileTheOtherThreadCallsThem) {
  TracedContext owner({kSize, kSize});
  makeSharedObjects(owner.gl());
  std::atomic<bool> done = false;
  int wrong = -1;
  std::atomic<int> compiled = 0;
  inTwoThreads([&](int thread) {
    TracedContext context({kSize, kSize}, TracedContext::vertexShading(), nullptr, &owner);
    Gl gl = context.gl();
    if (thread == 0) {
      wrong = 0;
      for (int frame = 0; goesOn(frame, compiled); ++frame) {
        const auto color = colorOf(thread, frame);
        startFrame(gl);
        gl.Color4ubv(color.data());
        gl.CallList(kSharedList);
        wrong += !isAll(gl, color);
      }
      done = true;
      return;
    }
    // Every list that the other thread may find covers the picture.
    for (; !done; ++compiled)
      gl.NewList(kSharedList, GL_COMPILE), sendRectangle(gl, 1.0f + 0.01f * static_cast<float>(compiled % 7)),
          gl.EndList();
  });
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(compiled, kActs);
}

TEST(Threads, PendingDataIsSentByTheThreadThatDrawsFirst) {
  constexpr int kRounds = 100;
  TracedContext owner({kSize, kSize});
  makeSharedObjects(owner.gl());
  std::barrier together(2);
  std::array<int, 2> wrong{};
  inTwoThreads([&](int thread) {
    TracedContext context({kSize, kSize}, TracedContext::vertexShading(), nullptr, &owner);
    Gl gl = context.gl();
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.Enable(GL_STENCIL_TEST);  // rasterised
    for (int round = 0; round < kRounds; ++round) {
      const auto positions = rectangle(1.0f + 0.01f * static_cast<float>(round));
      gl.BindBuffer(GL_ARRAY_BUFFER, kSharedBuffer);
      if (thread == round % 2)
        gl.BufferData(GL_ARRAY_BUFFER, sizeof positions, positions.data(), GL_STREAM_DRAW);
      gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
      const auto color = colorOf(thread, round);
      startFrame(gl);
      gl.Color4ubv(color.data());
      together.arrive_and_wait();
      gl.DrawArrays(GL_TRIANGLES, 0, 6);
      wrong[static_cast<size_t>(thread)] += !isAll(gl, color);
      together.arrive_and_wait();
    }
  });
  EXPECT_EQ(wrong, (std::array<int, 2>{0, 0}));
}

TEST(Threads, BuffersAreFilledWhileTheOtherThreadDraws) {
  TracedContext owner({kSize, kSize});
  makeSharedObjects(owner.gl());
  std::atomic<bool> done = false;
  int wrong = 0;
  std::atomic<int> filled = 0;
  inTwoThreads([&](int thread) {
    TracedContext context({kSize, kSize}, TracedContext::vertexShading(), nullptr, &owner);
    Gl gl = context.gl();
    const auto positions = rectangle(1);
    if (thread == 0) {
      gl.Enable(GL_STENCIL_TEST);
      for (int frame = 0; goesOn(frame, filled); ++frame) {
        const auto color = colorOf(thread, frame);
        startFrame(gl);
        gl.Color4ubv(color.data());
        for (int i = 0; i < 20; ++i) sendRectangle(gl, 1);  // each checks for buffers to send
        wrong += !isAll(gl, color);
      }
      done = true;
      return;
    }
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    for (; !done; ++filled)
      gl.BufferData(GL_ARRAY_BUFFER, sizeof positions, positions.data(), GL_STREAM_DRAW);
    gl.DeleteBuffers(1, &buffer);
  });
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(filled, kActs);
}

TEST(Threads, ReportsMayBeSummedMeanwhile) {
  TracedContext context({kSize, kSize});
  makeSharedObjects(context.gl());
  std::atomic<bool> done = false;
  uint64_t last = 0;
  std::atomic<int> looks = 0;
  bool fell = false;
  std::thread watcher([&] {
    while (!done) {
      gl::Statistics sum;
      sum += context.context().counts.statistics;
      fell = fell || sum.frames < last;
      last = sum.frames, ++looks;
    }
  });
  EXPECT_EQ(wrongFrames(context.gl(), 0), 0);
  while (looks < kActs) std::this_thread::yield();
  done = true;
  watcher.join();
  EXPECT_FALSE(fell);
  EXPECT_EQ(context.context().counts.statistics.frames, kFrames) << "the rasterised, too";
}

}  // namespace
}  // namespace gluray::test
