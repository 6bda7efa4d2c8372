// Contexts current in several threads at once: of one share group, or of none. Run by the thread sanitizer;
// every image is checked as well.
#include "tests/support/traced_context.h"
#include "tests/threads/shared_frames.h"

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
    // Every list that the other thread may find covers the image.
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
