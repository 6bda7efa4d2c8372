// Frame lag: whatever a program does between two swaps, each frame is shown once, in order, as it
// was when it was swapped.
#include "tests/lag/lag_stage.h"
#include "tests/reference/triangle_field.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>

namespace gluray::test {
namespace {

using gl::LagRefusal;
using Gl = const gl::RealGl&;
using triangle_field::field, triangle_field::kBytes, triangle_field::kVertices;

TEST(Lag, EachSwapShowsTheFrameBefore) {
  const Shown shown = expectSameFrames("plain", ringFrame, kLagFrames, kLagFrames);
  for (size_t i = 0; i < shown.shownAtSwap.size(); ++i) EXPECT_EQ(shown.shownAtSwap[i], i);
}

TEST(Lag, RasterisedDrawsBelongToTheSameFrame) {
  expectSameFrames(
      "overlay",
      [](Gl gl, int frame) {
        beginLagFrame(gl, frame);
        drawFrameNumber(gl, frame);
        drawRing(gl, frame);
      },
      kLagFrames, kLagFrames);
}

TEST(Lag, OverlaysOnTopAreShownAtOnce) {
  const Shown shown = expectSameFrames(
      "on top",
      [](Gl gl, int frame) {
        beginLagFrame(gl, frame);
        drawRing(gl, frame);
        gl.Disable(GL_DEPTH_TEST);
        drawFrameNumber(gl, frame);
        gl.Enable(GL_DEPTH_TEST);
      },
      kLagFrames, 0);
  EXPECT_EQ(shown.swaps.back(), LagRefusal::nothingToDo);
}

TEST(Lag, FramesThatRepeatAreShownAtOnce) {
  const Shown shown = expectSameFrames(
      "repeated", [](Gl gl, int frame) { ringFrame(gl, frame / 2); }, kLagFrames, 3);
  EXPECT_EQ(shown.swaps[1], LagRefusal::repeated);
}

TEST(Lag, FramesDrawnOverTheLastOne) {
  expectSameFrames(
      "over the last",
      [](Gl gl, int frame) {
        if (frame == 0) beginLagFrame(gl, frame);
        drawRing(gl, frame);
      },
      kLagFrames, kLagFrames);
}

TEST(Lag, ClearsOfAPartComeInOrder) {
  expectSameFrames(
      "part",
      [](Gl gl, int frame) {
        beginLagFrame(gl, frame);
        gl.Enable(GL_SCISSOR_TEST), gl.Scissor(10, 10, 30, 20);
        gl.ClearColor(1, 1, 1, 1), gl.Clear(GL_COLOR_BUFFER_BIT);
        gl.Disable(GL_SCISSOR_TEST);
        gl.ColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        drawRing(gl, frame);
      },
      kLagFrames, kLagFrames);
}

TEST(Lag, ClearsOfEachBufferWithChangingValues) {
  expectSameFrames(
      "one by one",
      [](Gl gl, int frame) {
        beginLagFrame(gl, frame);
        gl.ClearDepth(0.9), gl.Clear(GL_DEPTH_BUFFER_BIT);
        gl.ClearColor(0, 1, 0.1f * static_cast<float>(frame), 1), gl.Clear(GL_COLOR_BUFFER_BIT);
        gl.ClearColor(1, 0, 0, 0), gl.ClearDepth(1);
        gl.Enable(GL_SCISSOR_TEST), gl.Scissor(3, 3, 1, 1);
        gl.DepthMask(GL_FALSE), gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        gl.Disable(GL_SCISSOR_TEST);
        gl.DepthMask(GL_TRUE), gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        drawRing(gl, frame);
      },
      kLagFrames, kLagFrames);
}

TEST(Lag, StateSetAfterAClearDoesNotChangeIt) {
  LagOptions options;
  options.afterSwap = [](Gl gl, int) {
    gl.ClearColor(0, 0, 1, 1), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Enable(GL_SCISSOR_TEST), gl.Scissor(0, 0, 5, 5);
    gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE), gl.DepthMask(GL_FALSE);
    gl.ClearColor(1, 1, 1, 1), gl.ClearDepth(0.1);
    std::vector<uint32_t> pixel(1);
    gl.ReadPixels(kLagWidth - 1, kLagHeight - 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    EXPECT_EQ(pixel[0], 0xffff0000u);
    EXPECT_TRUE(gl.IsEnabled(GL_SCISSOR_TEST));
    std::array<GLboolean, 4> mask{};
    gl.GetBooleanv(GL_COLOR_WRITEMASK, mask.data());
    EXPECT_EQ(mask, (std::array<GLboolean, 4>{GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE}));
    std::array<GLfloat, 4> color{};
    gl.GetFloatv(GL_COLOR_CLEAR_VALUE, color.data());
    EXPECT_EQ(color, (std::array<GLfloat, 4>{1, 1, 1, 1}));
    gl.Disable(GL_SCISSOR_TEST), gl.DepthMask(GL_TRUE), gl.ClearDepth(1);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  };
  expectSameFrames("state after", ringFrame, kLagFrames, kLagFrames, options);
}

TEST(Lag, ReadsSeeTheFrameThatWasSwapped) {
  for (const bool readFirst : {true, false}) {
    std::vector<DrawnImage> read;
    LagOptions options;
    options.afterSwap = [&](Gl gl, int) {
      if (!readFirst) gl.Finish();
      read.push_back(readImage(gl, kLagWidth, kLagHeight));
    };
    const Shown shown = play(ringFrame, kLagFrames, options);
    EXPECT_EQ(read, shown.frames);
    for (size_t i = 0; i < shown.shownAtSwap.size(); ++i) EXPECT_EQ(shown.shownAtSwap[i], i);
  }
}

TEST(Lag, CopiesSeeTheFrameThatWasSwapped) {
  LagOptions options;
  std::vector<std::vector<uint32_t>> copies;
  options.afterSwap = [&](Gl gl, int) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, kLagWidth, kLagHeight, 0);
    copies.emplace_back(static_cast<size_t>(kLagWidth) * kLagHeight);
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, copies.back().data());
    gl.DeleteTextures(1, &name);
  };
  const Shown shown = expectSameFrames("copies", ringFrame, kLagFrames, kLagFrames, options);
  ASSERT_EQ(copies.size() % kLagFrames, 0u);
  for (size_t i = 0; i < kLagFrames; ++i)
    EXPECT_EQ(copies[copies.size() - kLagFrames + i], shown.frames[i].colors);
}

/// Changes after the swap must not affect the frame.
TEST(Lag, ListsBuffersAndTexturesChangeBehindTheSwap) {
  GLuint list = 0, buffer = 0, texture = 0;
  const auto texel = [](int frame) {
    return static_cast<GLuint>(0xff000000u | static_cast<unsigned>(40 * frame) << 8 | 200u);
  };
  const auto draw = [&](Gl gl, int frame) {
    beginLagFrame(gl, frame);
    list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE), drawRing(gl, frame), gl.EndList();
    gl.CallList(list);
    const std::vector<float> triangles = field(1.0f + static_cast<float>(frame % 3));
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, kBytes, triangles.data(), GL_STREAM_DRAW);
    gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    const GLuint color = texel(frame);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &color);
    gl.Enable(GL_TEXTURE_2D), gl.Disable(GL_LIGHTING), gl.Color3f(1, 1, 1);
    gl.PushMatrix(), gl.Translatef(0, 0, -4);
    gl.DrawArrays(GL_TRIANGLES, 0, kVertices);
    gl.PopMatrix();
    gl.Disable(GL_TEXTURE_2D), gl.Enable(GL_LIGHTING);
  };
  LagOptions options;
  options.afterSwap = [&](Gl gl, int) {
    const GLuint white = ~0u;
    const std::vector<float> nothing(3 * kVertices);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &white);
    gl.BufferSubData(GL_ARRAY_BUFFER, 0, kBytes, nothing.data());
    gl.DeleteBuffers(1, &buffer), gl.DeleteTextures(1, &texture), gl.DeleteLists(list, 1);
    gl.Enable(GL_FRAMEBUFFER_SRGB), gl.Disable(GL_FRAMEBUFFER_SRGB);
  };
  expectSameFrames("changes", draw, kLagFrames, kLagFrames, options);
}

TEST(Lag, AFrameThatCannotBeTracedIsRasterisedInOrder) {
  for (const int failing : {0, 2}) {
    LagOptions options;
    std::atomic<int> asked{0};
    options.trace = [&](const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                        std::string& why) {
      if (asked++ != failing) return traceByRenderer(snapshot, image, cost, why);
      return why = "it fails in this test", false;
    };
    const Shown shown = play(ringFrame, kLagFrames, options);
    EXPECT_LE(asked, failing + 2);  // the next frame is already pending
    expectClose("failing", playReal(ringFrame, kLagFrames), shown.frames);
  }
}

TEST(Lag, FramesOfADestroyedWindowAreNotShown) {
  bool there = true;
  LagOptions options;
  options.stands = [&] { return there; };
  options.afterSwap = [&](Gl, int frame) { there = frame != 2; };
  const Shown shown = play(ringFrame, kLagFrames, options);
  LagOptions plainly;
  plainly.lag = false;
  std::vector<DrawnImage> plain = play(ringFrame, kLagFrames, plainly).frames;
  plain.erase(plain.begin() + 2);
  EXPECT_EQ(shown.frames, plain);
}

TEST(Lag, QueriesAndOtherFramebuffersAreShownAtOnce) {
  const Shown shown = expectSameFrames(
      "query",
      [](Gl gl, int frame) {
        GLuint query = 0, samples = 0;
        beginLagFrame(gl, frame);
        gl.GenQueries(1, &query);
        gl.BeginQuery(GL_SAMPLES_PASSED, query);
        drawRing(gl, frame);
        gl.EndQuery(GL_SAMPLES_PASSED);
        gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
        EXPECT_GT(samples, 0u);
        gl.DeleteQueries(1, &query);
      },
      kLagFrames, 0);
  EXPECT_EQ(shown.swaps.front(), LagRefusal::nothingToDo);
}

}  // namespace
}  // namespace gluray::test
