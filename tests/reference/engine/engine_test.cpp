// engine = auto: changes between tracing and the real OpenGL keep images, errors and state.
#include "scenes/stage.h"
#include "tests/reference/drawn_scene.h"
#include "tests/reference/engine/large_backdrop.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace gluray::test {
namespace {

using scenes::Gl;

constexpr auto kSmall = static_cast<size_t>(gl::Reason::smallScene);

Settings withEngine(Engine engine) {
  Settings settings = TracedContext::vertexShading();
  settings.engine = engine;
  return settings;
}

std::vector<const scenes::Scene*> allScenes() {
  std::vector<const scenes::Scene*> all;
  // The front buffer of a second frame is undefined: two real contexts differ.
  for (const scenes::Scene& scene : scenes::scenes())
    if (std::string_view(scene.name) != "front-buffer") all.push_back(&scene);
  for (const scenes::Scene& scene : scenes::variants()) all.push_back(&scene);
  return all;
}

class EngineTest : public testing::TestWithParam<const scenes::Scene*> {
 protected:
  /// The images of frames drawn by `gl` one after another.
  std::vector<DrawnImage> play(Gl gl, int frames, const std::function<void(int)>& before = {}) {
    std::vector<DrawnImage> images;
    for (int i = 0; i < frames; ++i) {
      if (before) before(i);
      GetParam()->draw(gl, kSceneWidth, kSceneHeight);
      gl.Finish();
      images.push_back(readImage(gl, kSceneWidth, kSceneHeight));
      errors.push_back(gl.GetError());
    }
    return images;
  }
  std::vector<GLenum> errors;
};

TEST_P(EngineTest, FramesLeftToTheRealOneAreItsImages) {
  const auto real = OsmesaContext::create({kSceneWidth, kSceneHeight});
  const std::vector<DrawnImage> expected = play(real->real(), 2);
  const std::vector<GLenum> wanted = std::exchange(errors, {});
  TracedContext ours({kSceneWidth, kSceneHeight}, withEngine(Engine::never));
  const std::vector<DrawnImage> got = play(ours.gl(), 2);
  for (size_t i = 0; i < expected.size(); ++i) {
    const Comparison c = compare(expected[i], got[i],
                                 {1, 0, 0, "in lists colours come with each vertex, and are interpolated"});
    EXPECT_TRUE(c.accepted) << "frame " << i << ": " << c.text;
  }
  EXPECT_EQ(errors, wanted);
  EXPECT_EQ(ours.context().counts.statistics.drawsTraced, 0u);
}

/// Frame 0 is mixed and frame 1 direct; frame 2 begins with a large draw, after which GLuRay chooses tracing.
TEST_P(EngineTest, TheImageIsTheSameWhileTheEngineChanges) {
  const auto with = [](Gl gl) {
    return [&gl](int frame) {
      if (frame >= 2) backdrop(gl);
    };
  };
  const auto real = OsmesaContext::create({kSceneWidth, kSceneHeight});
  const std::vector<DrawnImage> expected = play(real->real(), 4, with(real->real()));
  const std::vector<GLenum> wanted = std::exchange(errors, {});
  TracedContext ours({kSceneWidth, kSceneHeight}, withEngine(Engine::automatic));
  const std::vector<DrawnImage> got = play(ours.gl(), 4, with(ours.gl()));
  for (size_t i = 0; i < expected.size(); ++i) {
    const Comparison c = compare(expected[i], got[i], GetParam()->tolerance);
    EXPECT_TRUE(c.accepted) << "frame " << i << ": " << c.text;
    if (!c.accepted)
      writeFailure(TEST_OUTPUT, std::string("engine-") + GetParam()->name, expected[i], got[i]);
  }
  EXPECT_EQ(errors, wanted);
  const gl::Statistics& s = ours.context().counts.statistics;
  EXPECT_TRUE(s.rasterisedBecause[kSmall] > 0 || !GetParam()->traced);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EngineTest, testing::ValuesIn(allScenes()), sceneNameOf);

/// Whether vertices of a list take colours from its caller until the list sets one. Mesa 25.0 gives those of
/// the triangle that is open then the list's colour, against the specification.
bool listsInherit(Gl gl) {
  gl.NewList(2, GL_COMPILE);
  gl.Begin(GL_TRIANGLES);
  gl.Vertex3f(-1, -1, 0), gl.Vertex3f(1, -1, 0), gl.Color3f(0, 0, 1), gl.Vertex3f(0, 1, 0);
  gl.End();
  gl.EndList();
  scenes::begin(gl, kSceneWidth, kSceneHeight);
  gl.Color3f(1, 0, 0);
  gl.CallList(2);
  uint32_t nearCaller = 0;
  gl.ReadPixels(kSceneWidth / 4, kSceneHeight / 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &nearCaller);
  return (nearCaller & 255) > 100;
}

/// One frame of a program that never swaps, by a list, arrays in a buffer and glBegin.
struct Mixture {
  std::vector<GLfloat> triangle = {-0.5f, 0, 0.3f, 0.5f, 0, 0.2f, 0, 0.8f, 0.1f};
  GLuint buffer = 0;
  bool large = false;
  bool inherits = true;

  void setUp(Gl gl) {
    gl.NewList(1, GL_COMPILE);
    gl.Begin(GL_TRIANGLES);
    if (!inherits) gl.Color3f(1, 1, 0);
    gl.Vertex3f(-1, -1, 0), gl.Vertex3f(0, -1, 0.1f), gl.Color3f(0, 1, 1), gl.Vertex3f(-0.5f, 0, 0.2f);
    gl.End();
    gl.EndList();
    gl.GenBuffers(1, &buffer);
  }
  void frame(Gl gl, int number) {
    scenes::begin(gl, kSceneWidth, kSceneHeight);
    if (large) backdrop(gl);
    gl.Enable(GL_DEPTH_TEST);
    gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity();
    gl.Color3f(1, 0.1f * static_cast<float>(number % 10), 0);
    // Its first two vertices inherit the current colour; everything after them has the last vertex's.
    gl.CallList(1);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    triangle[0] = -0.5f - 0.03f * static_cast<float>(number % 10);
    const auto bytes = static_cast<GLsizeiptr>(triangle.size() * sizeof(GLfloat));
    switch (number % 3) {
      case 0: gl.BufferData(GL_ARRAY_BUFFER, bytes, triangle.data(), GL_STATIC_DRAW); break;
      case 1: gl.BufferSubData(GL_ARRAY_BUFFER, 0, bytes, triangle.data()); break;
      default:
        if (auto* memory = static_cast<GLfloat*>(gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY)))
          std::copy(triangle.begin(), triangle.end(), memory);
        gl.UnmapBuffer(GL_ARRAY_BUFFER);
    }
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.Translatef(0.9f, -0.5f, 0);
    gl.Begin(GL_QUADS);
    gl.Vertex3f(-0.4f, -0.4f, 0), gl.Vertex3f(0.4f, -0.4f, 0), gl.Color3f(1, 1, 1);
    gl.Vertex3f(0.4f, 0.4f, -0.2f), gl.Vertex3f(-0.4f, 0.4f, -0.2f);
    gl.End();
    gl.Finish();
  }
};

TEST(Engine, ImageIsRightAcrossChangesInBothDirections) {
  const auto real = OsmesaContext::create({kSceneWidth, kSceneHeight});
  Mixture theirs, mine;
  theirs.inherits = mine.inherits = listsInherit(real->real());
  theirs.setUp(real->real());
  TracedContext ours({kSceneWidth, kSceneHeight}, withEngine(Engine::automatic));
  mine.setUp(ours.gl());
  const gl::Statistics& s = ours.context().counts.statistics;
  int changes = 0, checked = 0;
  bool direct = false;
  for (int i = 0; i < 400; ++i) {
    mine.large = theirs.large = i % 200 >= 100 && i % 200 < 110;
    const bool before = direct;
    direct = ours.context().clock.passesThrough();
    real->makeCurrent();
    theirs.frame(real->real(), i);
    const DrawnImage expected = readImage(real->real(), kSceneWidth, kSceneHeight);
    ours.makeCurrent();
    mine.frame(ours.gl(), i);
    const DrawnImage got = ours.read();
    changes += direct != before;
    const Comparison c = compare(expected, got, {2, 0.004, 1e-5f, "few pixels, many edges"});
    ASSERT_TRUE(c.accepted) << "frame " << i << (direct ? ", direct: " : ": ") << c.text;
    ++checked;
    EXPECT_EQ(ours.gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
  EXPECT_EQ(checked, 400);
  EXPECT_GE(changes, 4) << "direct twice, and not direct twice";
  EXPECT_GT(s.framesPassedThrough, 100u);
  EXPECT_GT(s.drawsTraced, 10u);
  EXPECT_GT(uint64_t{s.rasterisedBecause[kSmall]}, 100u);
}

/// They take long to build, and most programs with a small scene never need them.
TEST(Engine, ShadersOfImagesAreBuiltForTheFirstLargeDraw) {
  TracedContext ours({kSceneWidth, kSceneHeight}, withEngine(Engine::automatic));
  for (const char* name : {"directional-light", "nested-lists"})
    if (const scenes::Scene* scene = scenes::findScene(name))
      scene->draw(ours.gl(), kSceneWidth, kSceneHeight);
  const gl::Context& context = ours.context();
  EXPECT_GT(uint64_t{context.counts.statistics.rasterisedBecause[kSmall]}, 0u);
  EXPECT_FALSE(context.pending.knowsSupport());
  scenes::begin(ours.gl(), kSceneWidth, kSceneHeight);
  backdrop(ours.gl());
  ours.gl().Finish();
  EXPECT_TRUE(context.pending.knowsSupport());
  EXPECT_GT(context.counts.statistics.drawsTraced, 0u);
}

/// Current colours after lists that end with the last vertex's colour or another, in frames of every kind.
TEST(Engine, ListsLeaveTheirLastColourToTheBit) {
  const auto real = OsmesaContext::create({kSceneWidth, kSceneHeight});
  TracedContext ours({kSceneWidth, kSceneHeight}, withEngine(Engine::automatic));
  const auto compile = [](Gl gl) {
    for (GLuint list = 1; list <= 3; ++list) {
      gl.NewList(list, GL_COMPILE);
      gl.Begin(GL_TRIANGLES);
      for (GLubyte i = 0; i < 9; ++i) {
        if (list < 3) gl.Color4ub(i, static_cast<GLubyte>(3 * i + 7), static_cast<GLubyte>(251 - i), 255);
        gl.Normal3f(0.1f * i, 0, 1);
        gl.Vertex3f(0.1f * i, i % 3 ? 0.5f : -0.5f, 0.01f * i);
      }
      gl.End();
      if (list == 2) gl.Color4ub(1, 2, 3, 255), gl.Normal3f(0, 0.3f, 0.7f);
      gl.EndList();
    }
  };
  const auto frame = [](Gl gl) {
    std::vector<GLfloat> values;
    scenes::begin(gl, kSceneWidth, kSceneHeight);
    for (GLuint list = 1; list <= 3; ++list) {
      gl.Color4f(0.1f, 0.2f, 0.3f, 1);
      gl.CallList(list);
      GLfloat v[4] = {};
      gl.GetFloatv(GL_CURRENT_COLOR, v), values.insert(values.end(), v, v + 4);
      gl.GetFloatv(GL_CURRENT_NORMAL, v), values.insert(values.end(), v, v + 3);
    }
    gl.Finish();
    return values;
  };
  real->makeCurrent();
  compile(real->real());
  ours.makeCurrent();
  compile(ours.gl());
  for (int i = 0; i < 4; ++i) {
    real->makeCurrent();
    const std::vector<GLfloat> expected = frame(real->real());
    ours.makeCurrent();
    EXPECT_EQ(frame(ours.gl()), expected) << "frame " << i;
    EXPECT_TRUE(ours.context().clock.passesThrough()) << "after frame " << i;
  }
}

TEST(Engine, ProgramsThatNeverSwapHaveFramesByTheirClears) {
  TracedContext ours({kSceneWidth, kSceneHeight}, withEngine(Engine::automatic));
  const scenes::Scene& scene = *scenes::findScene("directional-light");
  scene.draw(ours.gl(), kSceneWidth, kSceneHeight);
  EXPECT_FALSE(ours.context().clock.passesThrough());
  scene.draw(ours.gl(), kSceneWidth, kSceneHeight);  // begins with a clear
  EXPECT_TRUE(ours.context().clock.passesThrough());
}

TEST(Engine, TracesEverythingIfSet) {
  TracedContext ours({kSceneWidth, kSceneHeight}, withEngine(Engine::always));
  const scenes::Scene& scene = *scenes::findScene("directional-light");
  for (int i = 0; i < 5; ++i) scene.draw(ours.gl(), kSceneWidth, kSceneHeight), ours.gl().Finish();
  EXPECT_GT(ours.context().counts.statistics.drawsTraced, 0u);
  EXPECT_EQ(uint64_t{ours.context().counts.statistics.rasterisedBecause[kSmall]}, 0u);
}

}  // namespace
}  // namespace gluray::test
