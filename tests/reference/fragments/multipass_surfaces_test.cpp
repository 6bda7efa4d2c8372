// Surfaces drawn in several passes over many frames: rasterised while the passes come, traced again
// afterwards.
#include "scenes/stage.h"
#include "tests/reference/both.h"
#include "tests/reference/framebuffer.h"
#include "tests/support/gl_state.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace gluray::test {
namespace {

using namespace scenes;

constexpr int kPassesWidth = 160, kPassesHeight = 120;

/// A sphere; over it a tint if `tinted`; a label in between if `labelled`; a rectangle that hides a part of
/// it if `hidden`.
void drawFrame(Gl gl, bool tinted, bool labelled, bool hidden = false) {
  begin(gl, kPassesWidth, kPassesHeight);
  camera(gl, kPassesWidth, kPassesHeight);
  keyLight(gl);
  if (hidden) {
    paint(gl, 0.2f, 0.7f, 0.3f);
    gl.PushMatrix();
    gl.Translatef(0.3f, 0.3f, 1.2f), gl.Rotatef(25, 1, 1, 1), gl.Scalef(0.4f, 0.4f, 0.4f);
    send(gl, scenes::sheet(4));
    gl.PopMatrix();
  }
  paint(gl, 0.3f, 0.5f, 0.7f);
  const Model m = scenes::sphere(24, 36);
  send(gl, m);
  if (labelled) {
    constexpr GLubyte kDot[] = {0xff};
    gl.RasterPos3f(1, 1, 1);
    gl.Bitmap(8, 1, 0, 0, 0, 0, kDot);
  }
  if (!tinted) return;
  gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE), gl.DepthFunc(GL_EQUAL);
  paint(gl, 0.5f, 0.2f, 0);
  send(gl, m);
  gl.Disable(GL_BLEND), gl.DepthFunc(GL_LESS);
}

constexpr int kTinted = 6, kFrames = kTinted + 110;

std::vector<DrawnImage> expectedFrames(bool labelled) {
  const auto real = OsmesaContext::create({kPassesWidth, kPassesHeight});
  std::vector<DrawnImage> images;
  for (int frame = 0; frame < kFrames; ++frame) {
    drawFrame(real->real(), frame < kTinted, labelled);
    images.push_back(readImage(real->real(), kPassesWidth, kPassesHeight));
  }
  return images;
}

void expectFrames(bool labelled) {
  const std::vector<DrawnImage> expected = expectedFrames(labelled);
  TracedContext ours({kPassesWidth, kPassesHeight});
  const gl::Statistics& s = ours.context().counts.statistics;
  for (int frame = 0; frame < kFrames; ++frame) {
    const uint64_t before = s.drawsTraced;
    drawFrame(ours.gl(), frame < kTinted, labelled);
    ours.gl().Finish();
    const uint64_t traced = s.drawsTraced - before;
    const Comparison c = compare(expected[static_cast<size_t>(frame)], ours.read(), {});
    EXPECT_TRUE(c.accepted) << "frame " << frame << ": " << c.text;
    if (frame > 0 && frame < kTinted) { EXPECT_EQ(traced, 0u) << "frame " << frame; }
    if (frame > kTinted + 105) { EXPECT_EQ(traced, 1u) << "frame " << frame; }
  }
}

TEST(Passes, AreRasterisedWhileTheyCome) { expectFrames(false); }

// The first pass was traced already when the second comes: its depth is drawn again.
TEST(Passes, AreRightFromTheFirstFrameOnBehindALabel) { expectFrames(true); }

TEST(Passes, DepthThatIsDrawnAgainLeavesTheStateAlone) {
  const auto draw = [](Gl gl) {
    gl.PixelTransferf(GL_DEPTH_SCALE, 0.5f), gl.PixelTransferf(GL_DEPTH_BIAS, 0.1f);
    drawFrame(gl, true, true);
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    GlState state = queryState(gl);
    gl.PixelTransferf(GL_DEPTH_SCALE, 1), gl.PixelTransferf(GL_DEPTH_BIAS, 0);
    return std::make_pair(std::move(state), readImage(gl, kPassesWidth, kPassesHeight));
  };
  const auto real = OsmesaContext::create({kPassesWidth, kPassesHeight});
  const auto expected = draw(real->real());
  TracedContext ours({kPassesWidth, kPassesHeight});
  const auto got = draw(ours.gl());
  for (const std::string& line : differences(expected.first, got.first)) ADD_FAILURE() << line;
  const Comparison c = compare(expected.second, got.second, {});
  EXPECT_TRUE(c.accepted) << c.text;
}

/// Copies the bound framebuffer to the window. If it is multisampled, the specification does not say which
/// sample gives the depth: copies colours only.
DrawnImage resolved(Gl gl) {
  GLint framebuffer = 0;
  gl.GetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl.BlitFramebuffer(0, 0, kPassesWidth, kPassesHeight, 0, 0, kPassesWidth, kPassesHeight,
                     GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  DrawnImage image = readImage(gl, kPassesWidth, kPassesHeight);
  image.depths.assign(image.depths.size(), 1.0f);
  gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
  return image;
}

void expectFirstFrame(GLenum depthFormat, bool perSample) {
  const auto draw = [&](Gl gl) {
    bindNewFramebuffer(gl, {kPassesWidth, kPassesHeight}, GL_RGBA8, depthFormat, 4);
    perSample ? gl.Enable(GL_MULTISAMPLE) : gl.Disable(GL_MULTISAMPLE);
    drawFrame(gl, true, true, true);
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    GlState state = queryState(gl);
    return std::make_pair(std::move(state), resolved(gl));
  };
  const auto real = OsmesaContext::create({kPassesWidth, kPassesHeight});
  const auto expected = draw(real->real());
  TracedContext ours({kPassesWidth, kPassesHeight});
  const auto got = draw(ours.gl());
  EXPECT_EQ(ours.context().counts.statistics.drawsTraced, 2u);
  for (const std::string& line : differences(expected.first, got.first)) ADD_FAILURE() << line;
  const Tolerance outlines{2, 0.004, 1e-5f, "outlines fall on either side of a sample"};
  const Comparison c = compare(expected.second, got.second, perSample ? outlines : Tolerance{});
  EXPECT_TRUE(c.accepted) << c.text;
  if (!c.accepted) writeFailure(TEST_OUTPUT "/passes", "multisampled", expected.second, got.second);
}

TEST(Passes, FindTheDepthOfEverySample) { expectFirstFrame(GL_DEPTH24_STENCIL8, true); }
TEST(Passes, FindTheDepthOfEverySampleWithoutStencil) { expectFirstFrame(GL_DEPTH_COMPONENT24, true); }
TEST(Passes, FindTheDepthOfEverySampleIn32Bits) { expectFirstFrame(GL_DEPTH_COMPONENT32, true); }
TEST(Passes, FindTheDepthOfEverySampleInFloats) { expectFirstFrame(GL_DEPTH_COMPONENT32F, true); }
TEST(Passes, FindTheDepthOfPixelsThatIgnoreTheirSamples) { expectFirstFrame(GL_DEPTH24_STENCIL8, false); }

/// A ball that is traced; then `between`; then the ball again, which shows where its depth is found.
void expectBothPasses(const std::string& name, const Draw& between) {
  const BothStage stage{kPassesWidth, kPassesHeight, "passes", [](Gl) {}};
  const gl::Statistics counts = compareBoth(stage, name, [&](Gl gl) {
    begin(gl, kPassesWidth, kPassesHeight), camera(gl, kPassesWidth, kPassesHeight), keyLight(gl);
    paint(gl, 0.3f, 0.5f, 0.7f);
    const Model ball = scenes::sphere(24, 36);
    send(gl, ball);
    between(gl);
    gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE), gl.DepthFunc(GL_EQUAL);
    paint(gl, 0.5f, 0.2f, 0);
    send(gl, ball);
  });
  EXPECT_GE(counts.drawsTraced, 1u) << name;
}

void sendWidget(Gl gl) { sendAt(gl, scenes::sphere(8, 12), 0, 0, 0, 0.1f); }

TEST(Passes, AreFoundAfterAnotherFramebufferWasCleared) {
  expectBothPasses("other_framebuffer", [](Gl gl) {
    bindNewFramebuffer(gl, {kPassesWidth, kPassesHeight}, GL_RGBA8, GL_DEPTH_COMPONENT24);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    sendWidget(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  });
}

TEST(Passes, AreFoundAfterAPartOfTheDepthWasCleared) {
  for (const bool view : {false, true})
    expectBothPasses(view ? "corner_view" : "corner", [&](Gl gl) {
      gl.Enable(GL_SCISSOR_TEST), gl.Scissor(0, 0, 30, 30);
      if (view) gl.Viewport(0, 0, 30, 30);
      gl.Clear(GL_DEPTH_BUFFER_BIT);
      sendWidget(gl);
      gl.Disable(GL_SCISSOR_TEST), gl.Viewport(0, 0, kPassesWidth, kPassesHeight);
    });
}

TEST(Passes, AreFoundAfterAClearThatKeepsDepth) {
  expectBothPasses(
      "masked", [](Gl gl) { gl.DepthMask(GL_FALSE), gl.Clear(GL_DEPTH_BUFFER_BIT), gl.DepthMask(GL_TRUE); });
}

TEST(Passes, AreFoundAfterAFrameWithoutASwap) {
  expectBothPasses("flushed", [](Gl gl) { gl.Flush(); });
  expectBothPasses("finished", [](Gl gl) { gl.Finish(), sendWidget(gl), gl.Finish(); });
}

void sendArrays(Gl gl, const Model& model) {
  gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, model.positions.data());
  gl.EnableClientState(GL_NORMAL_ARRAY), gl.NormalPointer(GL_FLOAT, 0, model.normals.data());
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(model.indices.size()), GL_UNSIGNED_INT,
                  model.indices.data());
  gl.DisableClientState(GL_VERTEX_ARRAY), gl.DisableClientState(GL_NORMAL_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr), gl.NormalPointer(GL_FLOAT, 0, nullptr);
}

/// A ball and a part of it, at one place but in separate batches, which could be traced. `less` changes the
/// depth function in between; otherwise the framebuffer is read.
void drawTwice(Gl gl, bool partFirst, bool less, bool arrays) {
  begin(gl, kPassesWidth, kPassesHeight), camera(gl, kPassesWidth, kPassesHeight), keyLight(gl);
  gl.DepthFunc(less ? GL_LESS : GL_LEQUAL);
  const Model ball = scenes::sphere(24, 36);
  Model part = ball;
  part.indices.resize(part.indices.size() / 12 * 3);
  paint(gl, 0.3f, 0.5f, 0.7f);
  send(gl, partFirst ? part : ball);
  GLubyte pixel[4];
  gl.ReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  gl.DepthFunc(GL_LEQUAL);
  paint(gl, 0.9f, 0.5f, 0.7f);
  const Model& again = partFirst ? ball : part;
  arrays ? sendArrays(gl, again) : send(gl, again);
}

TEST(Passes, ThatCouldBothBeTracedAreRasterised) {
  for (const bool partFirst : {false, true})
    for (const bool less : {false, true})
      for (const bool arrays : {false, true}) {
        const std::string name = std::string("twice") + (partFirst ? "_part" : "") + (less ? "_less" : "") +
                                 (arrays ? "_arrays" : "");
        const BothStage stage{kPassesWidth, kPassesHeight, "passes", [](Gl) {}};
        const gl::Statistics counts =
            compareBoth(stage, name, [&](Gl gl) { drawTwice(gl, partFirst, less, arrays); });
        EXPECT_GE(counts.rasterisedBecause[static_cast<size_t>(gl::Reason::passes)], 1u) << name;
      }
}

/// Faces in front are filled with an offset, and those in the back are points; then all are filled.
TEST(Passes, AfterOneFilledFaceAreRasterised) {
  for (const bool arrays : {false, true}) {
    const BothStage stage{kPassesWidth, kPassesHeight, "passes", [](Gl) {}};
    const gl::Statistics counts = compareBoth(stage, arrays ? "face_arrays" : "face", [&](Gl gl) {
      begin(gl, kPassesWidth, kPassesHeight);
      camera(gl, kPassesWidth, kPassesHeight);
      keyLight(gl);
      gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(0.13f, 3.1f);
      const Model ball = scenes::sphere(24, 36);
      paint(gl, 0.3f, 0.5f, 0.7f);
      gl.PolygonMode(GL_BACK, GL_POINT);
      sendArrays(gl, ball);
      gl.PolygonMode(GL_BACK, GL_FILL);
      paint(gl, 0.9f, 0.5f, 0.7f);
      arrays ? sendArrays(gl, ball) : send(gl, ball);
    });
    EXPECT_GE(counts.rasterisedBecause[static_cast<size_t>(gl::Reason::passes)], 1u) << arrays;
  }
}

/// The same surface in two viewports, or under two cameras: neither has the other's depth.
TEST(Passes, AreNoneInOtherViewsOfTheFramebuffer) {
  for (const bool camera : {false, true}) {
    const BothStage stage{kPassesWidth, kPassesHeight, "passes", [](Gl) {}};
    const gl::Statistics counts = compareBoth(stage, camera ? "cameras" : "viewports", [&](Gl gl) {
      begin(gl, kPassesWidth, kPassesHeight), scenes::camera(gl, kPassesWidth, kPassesHeight), keyLight(gl);
      for (int view = 0; view < 2; ++view) {
        if (!camera) gl.Viewport(view * kPassesWidth / 2, 0, kPassesWidth / 2, kPassesHeight);
        if (camera && view) gl.MatrixMode(GL_PROJECTION), gl.Scaled(0.5, 0.5, 1), gl.MatrixMode(GL_MODELVIEW);
        paint(gl, 0.3f + 0.5f * static_cast<float>(view), 0.5f, 0.7f);
        send(gl, scenes::sphere(24, 36));
      }
    });
    EXPECT_EQ(counts.drawsTraced, 2u);
  }
}

/// Boxes as in occlusion culling: they write nothing.
TEST(Passes, AreNoneThatWriteNeitherColorNorDepth) {
  const TracedContext ours({kPassesWidth, kPassesHeight});
  Gl gl = ours.gl();
  begin(gl, kPassesWidth, kPassesHeight), camera(gl, kPassesWidth, kPassesHeight), keyLight(gl);
  const Model model = scenes::sphere(24, 36);
  gl.ColorMask(0, 0, 0, 0), gl.DepthMask(0);
  send(gl, model);
  gl.ColorMask(1, 1, 1, 1), gl.DepthMask(1);
  send(gl, model);
  gl.Finish();
  EXPECT_EQ(ours.context().counts.statistics.drawsTraced, 1u);
}

}  // namespace
}  // namespace gluray::test
