// Light on surfaces that the real OpenGL draws (setting light.rasterised): by programs of no family, it is
// that of the same surfaces traced; depth stays to the bit; and what is not known stays as the program draws
// it.
#include "tests/reference/culled/drawn_triangles.h"
#include "tests/reference/framebuffer.h"
#include "tests/support/gl_state.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace gluray::test::raster_light {
namespace {

constexpr int kSize = 128, kBlock = 8;  // pixels
const glm::vec3 kTint(0.8f, 0.6f, 0.4f);

const char* const kFlatVertex = R"(#version 120
attribute vec3 position;
uniform mat4 clipFromEye, eyeFromObject;
void main() { gl_Position = clipFromEye * (eyeFromObject * vec4(position, 1.0)); })";
const char* const kFlatFragment = R"(#version 120
uniform vec3 tint;
void main() { gl_FragColor = vec4(tint, 1.0); })";
const char* const kHoles = R"(#version 120
uniform vec3 tint;
void main() {
  if (fract(gl_FragCoord.x / 16.0) < 0.5) discard;
  gl_FragColor = vec4(tint, 1.0);
})";

Settings lit(bool on) {
  Settings settings = TracedContext::tracing();
  settings.light.rasterised = on;
  settings.ao.enabled = true, settings.ao.samples = 256, settings.ao.radius = 1;
  return settings;
}

Triangles square(float y, float half) {
  Triangles all;
  addQuad(all, {-half, y, half}, {half, y, half}, {half, y, -half}, {-half, y, -half});
  return all;
}

/// A floor and two walls that stand on it.
Triangles corner() {
  Triangles all = square(0, 1);
  addQuad(all, {-1, 0, -1}, {1, 0, -1}, {1, 1, -1}, {-1, 1, -1});
  addQuad(all, {-1, 0, 1}, {-1, 0, -1}, {-1, 1, -1}, {-1, 1, 1});
  return all;
}

glm::mat4 camera() { return glm::perspective(glm::radians(45.0f), 1.0f, 0.5f, 20.0f); }
glm::mat4 view() { return glm::lookAt(glm::vec3(2, 2, 3), glm::vec3(0, 0.3f, 0), glm::vec3(0, 1, 0)); }

void begin(Gl gl) {
  gl.Viewport(0, 0, kSize, kSize);
  gl.ClearColor(0.1f, 0.2f, 0.3f, 1), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST), gl.DepthFunc(GL_LESS);
}

void draw(Gl gl, GLuint program, const Triangles& triangles, const glm::mat4& eyeFromObject = view(),
          const glm::vec3& tint = kTint, GLsizei indices = 0) {
  drawTriangles(gl, program, triangles, {camera(), eyeFromObject, tint, indices});
}

/// Draws by fixed function, which is traced.
void drawTraced(Gl gl, const Triangles& triangles, const glm::vec3& tint = kTint) {
  const glm::mat4 clip = camera(), eye = view();
  gl.MatrixMode(GL_PROJECTION), gl.LoadMatrixf(glm::value_ptr(clip));
  gl.MatrixMode(GL_MODELVIEW), gl.LoadMatrixf(glm::value_ptr(eye));
  gl.Color3f(tint.x, tint.y, tint.z);
  gl.Begin(GL_TRIANGLES);
  for (const glm::vec3& p : triangles) gl.Vertex3f(p.x, p.y, p.z);
  gl.End();
}

CountedPicture seen(const Settings& settings, const std::function<void(Gl)>& frame) {
  return seenThrough(settings, kSize, [&](Gl gl) {
    begin(gl);
    frame(gl);
  });
}

CountedPicture byProgram(const Settings& settings, const char* fragment = kFlatFragment) {
  return seen(settings, [&](Gl gl) { draw(gl, makeProgram(gl, kFlatVertex, fragment), corner()); });
}

int channel(uint32_t color, int c) { return static_cast<int>(color >> (8 * c) & 255); }

uint32_t at(const Picture& p, int x, int y) { return p.colors[static_cast<size_t>(y * kSize + x)]; }

/// The pixel that shows a point.
uint32_t at(const Picture& p, const glm::vec3& point) {
  return p.colors[pixelOf(p, camera() * view(), point)];
}

/// Mean of the channels in a block of pixels.
std::array<double, 3> meanOf(const Picture& p, int x0, int y0) {
  std::array<double, 3> mean{};
  for (int y = y0; y < y0 + kBlock; ++y)
    for (int x = x0; x < x0 + kBlock; ++x)
      for (int c = 0; c < 3; ++c) mean[static_cast<size_t>(c)] += channel(at(p, x, y), c);
  for (double& m : mean) m /= kBlock * kBlock;
  return mean;
}

void expectAlike(const Picture& a, const Picture& b, double most) {
  for (int y = 0; y < kSize; y += kBlock)
    for (int x = 0; x < kSize; x += kBlock) {
      const auto one = meanOf(a, x, y), other = meanOf(b, x, y);
      for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(one[c], other[c], most) << x << ", " << y << ", " << c;
    }
}

TEST(RasterLight, OccludesAsIfTheSurfacesWereTraced) {
  const CountedPicture traced = seen(lit(false), [](Gl gl) { drawTraced(gl, corner()); });
  const CountedPicture drawn = byProgram(lit(true)), plain = byProgram(lit(false));
  ASSERT_EQ(traced.counts.drawsTraced, 1u);
  ASSERT_EQ(drawn.counts.drawsTraced, 0u);
  EXPECT_EQ(drawn.counts.drawsLit, 1u);
  // Noise is 0.01 of white at most; eight pixels beside each other share an edge of the silhouette.
  expectAlike(traced.picture, drawn.picture, 3);
  EXPECT_LT(channel(at(drawn.picture, {-0.95f, 0.02f, -0.95f}), 0), 140) << "most of the sky is hidden";
  EXPECT_EQ(drawn.picture.depths, plain.picture.depths);
}

/// Text and captions are flattened by a matrix without inverse: they stay as drawn, and the rest stays lit.
TEST(RasterLight, AMatrixWithoutInverseCostsItsOwnDrawAlone) {
  const auto frames = [](Gl gl, bool flattened) {
    const GLuint program = makeProgram(gl, kFlatVertex, kFlatFragment);
    glm::mat4 flat(1);
    flat[2][2] = 0, flat[3] = {0.6f, 0.6f, -2, 1};
    for (int frame = 0; frame < 2; ++frame) {
      begin(gl);
      draw(gl, program, corner());
      if (flattened) draw(gl, program, square(0, 0.01f), flat);
      draw(gl, program, square(0.4f, 0.2f));
    }
  };
  for (const LightIntegrator integrator : {LightIntegrator::local, LightIntegrator::path}) {
    Settings settings = lit(true);
    settings.integrator = integrator;
    const CountedPicture with = seen(settings, [&](Gl gl) { frames(gl, true); });
    const CountedPicture without = seen(settings, [&](Gl gl) { frames(gl, false); });
    EXPECT_EQ(with.counts.drawsLit, 4u) << "two in each frame";
    EXPECT_EQ(with.counts.rasterisedBecause[static_cast<size_t>(gl::Reason::failure)], 0u);
    size_t different = 0;
    for (size_t i = 0; i < with.picture.colors.size(); ++i)
      different += with.picture.colors[i] != without.picture.colors[i];
    if (integrator == LightIntegrator::local) { EXPECT_LT(different, 30u) << "the text's own"; }
  }
}

TEST(RasterLight, SwitchedOffChangesNoBit) {
  const Settings none = TracedContext::tracing();
  Settings noEffect = none;
  noEffect.light.rasterised = true;
  const Picture expected = byProgram(none).picture;
  for (const Settings& settings : {lit(false), noEffect}) {
    const CountedPicture got = byProgram(settings);
    EXPECT_EQ(got.counts.drawsLit, 0u);
    EXPECT_EQ(got.picture.colors, expected.colors);
    EXPECT_EQ(got.picture.depths, expected.depths);
  }
}

TEST(RasterLight, KeepsStateAndShowsNoErrors) {
  const auto stateAfter = [](const Settings& settings) {
    TracedContext context({kSize, kSize}, settings);
    Gl gl = context.gl();
    begin(gl);
    draw(gl, makeProgram(gl, kFlatVertex, kFlatFragment), corner());
    gl.Flush();
    return queryState(gl);
  };
  for (const std::string& line : differences(stateAfter(lit(false)), stateAfter(lit(true))))
    ADD_FAILURE() << line;
}

/// What shows through them is not lit as if they were closed.
TEST(RasterLight, LeavesHolesAlone) {
  const CountedPicture plain = byProgram(lit(false), kHoles), got = byProgram(lit(true), kHoles),
                       closed = byProgram(lit(true));
  EXPECT_EQ(got.counts.drawsLit, 1u);
  size_t holes = 0, wrong = 0;
  for (size_t i = 0; i < plain.picture.colors.size(); ++i) {
    const bool hole = plain.picture.depths[i] == plain.picture.depths[0];  // that of the clear
    holes += hole;
    wrong += got.picture.colors[i] != (hole ? plain : closed).picture.colors[i];
  }
  EXPECT_GT(holes, 1000u);
  EXPECT_EQ(wrong, 0u);
}

/// A lid over a floor, with holes: through them the floor shows, with the light that reaches it.
TEST(RasterLight, LightsWhatShowsThroughHoles) {
  const char* const lidWithHoles = R"(#version 120
uniform vec3 tint;
varying float height;
void main() {
  if (height > 0.05 && fract(gl_FragCoord.x / 16.0) < 0.5) discard;
  gl_FragColor = vec4(tint, 1.0);
})";
  const std::string vertex = std::string(kFlatVertex)
                                 .replace(std::string(kFlatVertex).find("void main() {"), 13,
                                          "varying float height;\nvoid main() { height = position.y;");
  const auto picture = [&](bool on) {
    return seen(lit(on),
                [&](Gl gl) {
                  Triangles both = square(0, 1);
                  const Triangles lid = square(0.1f, 0.8f);
                  both.insert(both.end(), lid.begin(), lid.end());
                  draw(gl, makeProgram(gl, vertex, lidWithHoles), both);
                })
        .picture;
  };
  const Picture plain = picture(false), got = picture(true);
  const auto depthOf = [](const glm::vec3& point) {
    const glm::vec4 clip = camera() * view() * glm::vec4(point, 1);
    return 0.5f + 0.5f * clip.z / clip.w;
  };
  int dark = 0, holes = 0;
  for (float x = -0.4f; x < 0.4f; x += 0.02f) {  // below the middle of the lid
    const glm::vec3 point(x, 0, 0.2f);
    const float depth = plain.depths[pixelOf(plain, camera() * view(), point)];
    if (std::abs(depth - depthOf(point)) > 0.002f) continue;
    ++holes, dark += channel(at(got, point), 0) < channel(at(plain, point), 0) / 2;
  }
  EXPECT_GT(holes, 10);
  EXPECT_EQ(dark, holes);
  EXPECT_EQ(got.depths, plain.depths);
}

/// Their depths in the framebuffer lie elsewhere than the surfaces.
TEST(RasterLight, LightsSurfacesWithAPolygonOffset) {
  const CountedPicture got = seen(lit(true), [](Gl gl) {
    gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(1, 40);
    draw(gl, makeProgram(gl, kFlatVertex, kFlatFragment), corner());
    gl.Disable(GL_POLYGON_OFFSET_FILL);
  });
  EXPECT_EQ(got.counts.drawsLit, 1u);
  expectAlike(got.picture, byProgram(lit(true)).picture, 3);
}

/// Indices that begin primitives anew are no vertices.
TEST(RasterLight, LeavesRestartedPrimitivesAlone) {
  const auto picture = [](bool on) {
    const CountedPicture got = seen(lit(on), [](Gl gl) {
      const GLuint program = makeProgram(gl, kFlatVertex, kFlatFragment);
      const std::vector<GLuint> indices{0, 1, 2, ~0u, 3, 4, 5};
      GLuint buffer = 0;
      gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
      gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)),
                    indices.data(), GL_STATIC_DRAW);
      gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(~0u);
      draw(gl, program, corner(), view(), kTint, static_cast<GLsizei>(indices.size()));
      gl.Disable(GL_PRIMITIVE_RESTART);
    });
    EXPECT_EQ(got.counts.drawsLit, 0u);
    return got.picture.colors;
  };
  EXPECT_EQ(picture(true), picture(false));
}

TEST(RasterLight, LightsMultisampledFramebuffers) {
  const auto resolved = [](const char* fragment, gl::Statistics* counts) {
    const CountedPicture got = seen(lit(true), [&](Gl gl) {
      bindNewFramebuffer(gl, {kSize, kSize}, GL_RGBA8, GL_DEPTH_COMPONENT24, 4);
      begin(gl);
      draw(gl, makeProgram(gl, kFlatVertex, fragment), corner());
      gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
      gl.BlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
      gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    });
    *counts = got.counts;
    return got.picture;
  };
  gl::Statistics counts;
  const Picture sampled = resolved(kFlatFragment, &counts), single = byProgram(lit(true)).picture;
  EXPECT_EQ(counts.drawsLit, 1u);
  expectAlike(sampled, single, 5);  // edges: blocks of eight pixels, one of which is half covered
  // Where holes are is not known.
  resolved(kHoles, &counts);
  EXPECT_EQ(counts.drawsLit, 0u);
}

/// What is drawn after the surfaces and in front of them shows no light of theirs.
TEST(RasterLight, StaysBelowWhatIsDrawnLater) {
  const glm::vec3 red(1, 0, 0);
  const Triangles front = square(0.5f, 0.3f);
  for (const bool tested : {true, false}) {
    const CountedPicture got = seen(lit(true), [&](Gl gl) {
      const GLuint program = makeProgram(gl, kFlatVertex, kFlatFragment);
      draw(gl, program, corner());
      if (!tested) gl.Disable(GL_DEPTH_TEST);
      draw(gl, program, front, view(), red);
    });
    const uint32_t color = at(got.picture, {0, 0.5f, 0});
    EXPECT_EQ(channel(color, 1), 0);
    if (!tested) { EXPECT_EQ(channel(color, 0), 255) << "it has no depth: it takes no light"; }
  }
}

/// Surfaces of several draws occlude each other, each with a matrix of its own, and so do traced ones.
TEST(RasterLight, JoinsDrawsOfAllKinds) {
  const Triangles floor = square(0, 1), lid = square(0.1f, 0.5f);
  const glm::vec3 below(0.53f, 0, 0.3f), away(0.9f, 0, -0.9f);  // beside the lid's edge, and far from it
  const auto share = [&](const std::function<void(Gl)>& frame) {
    const CountedPicture got = seen(lit(true), frame);
    EXPECT_GT(got.counts.drawsLit, 0u);
    EXPECT_GT(channel(at(got.picture, away), 0), 190);
    return channel(at(got.picture, below), 0) / 204.0;
  };
  const glm::mat4 raised = view() * glm::translate(glm::mat4(1), glm::vec3(0, 0.1f, 0));
  const double oneDraw = share([&](Gl gl) {
    Triangles both = floor;
    both.insert(both.end(), lid.begin(), lid.end());
    draw(gl, makeProgram(gl, kFlatVertex, kFlatFragment), both);
  });
  const double twoDraws = share([&](Gl gl) {
    const GLuint program = makeProgram(gl, kFlatVertex, kFlatFragment);
    draw(gl, program, floor);
    draw(gl, program, square(0, 0.5f), raised);
  });
  const double tracedLid = share([&](Gl gl) {
    drawTraced(gl, lid);
    draw(gl, makeProgram(gl, kFlatVertex, kFlatFragment), floor);
  });
  EXPECT_LT(oneDraw, 0.8);
  EXPECT_NEAR(twoDraws, oneDraw, 0.03);
  EXPECT_NEAR(tracedLid, oneDraw, 0.06) << "bounds, and with them the radius, are those of both";
}

TEST(RasterLight, ShadowsAreThoseOfARig) {
  Settings settings = TracedContext::tracing();
  settings.light.rasterised = true;
  settings.shadows.enabled = true;
  const auto picture = [&](LightRig rig, bool rasterised) {
    settings.lights.rig = rig, settings.light.rasterised = rasterised;
    return seen(settings,
                [](Gl gl) {
                  const GLuint program = makeProgram(gl, kFlatVertex, kFlatFragment);
                  draw(gl, program, square(0, 1));
                  draw(gl, program, square(0.4f, 0.3f));
                })
        .picture;
  };
  const Picture none = picture(LightRig::program, true), sun = picture(LightRig::sun, true);
  size_t darker = 0, brighter = 0;
  for (size_t i = 0; i < none.colors.size(); ++i) {
    darker += channel(sun.colors[i], 0) < channel(none.colors[i], 0) - 20;
    brighter += channel(sun.colors[i], 0) > channel(none.colors[i], 0);
  }
  EXPECT_GT(darker, 50u);
  EXPECT_LT(darker, none.colors.size() / 4);
  EXPECT_EQ(brighter, 0u);
  EXPECT_EQ(none.colors, picture(LightRig::program, false).colors) << "no light is known";
}

}  // namespace
}  // namespace gluray::test::raster_light
