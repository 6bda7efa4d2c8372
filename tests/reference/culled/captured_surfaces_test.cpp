// Surfaces that the real OpenGL draws, as mirrors and paths of light meet them (setting light.rasterised,
// docs/adr/0074): by programs of no family, they have the colours that were drawn.
#include "tests/reference/culled/drawn_triangles.h"
#include "tests/reference/framebuffer.h"
#include "tests/support/gl_state.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace gluray::test::captured {
namespace {

constexpr int kSize = 128;  // pixels
const glm::vec3 kRed(1, 0, 0);

const char* const kVertex = R"(#version 120
attribute vec3 position;
uniform mat4 clipFromEye, eyeFromObject;
varying vec3 at;
void main() {
  at = position;
  gl_Position = clipFromEye * (eyeFromObject * vec4(position, 1.0));
})";
const char* const kFlat = R"(#version 120
uniform vec3 tint;
void main() { gl_FragColor = vec4(tint, 1.0); })";
/// Smooth colours by the place on the surface.
const char* const kPlaces = R"(#version 120
varying vec3 at;
void main() { gl_FragColor = vec4(0.5 + 0.4 * at.x, at.y, 0.2, 1.0); })";
/// Two halves of different colours.
const char* const kHalves = R"(#version 120
varying vec3 at;
void main() { gl_FragColor = at.x < 0.0 ? vec4(1.0, 0.0, 0.0, 1.0) : vec4(0.0, 0.0, 1.0, 1.0); })";

/// An upright board above the floor at this z.
Triangles board(float z = -1, float height = 1) {
  Triangles all;
  addQuad(all, {-1, 0.1f, z}, {1, 0.1f, z}, {1, 0.1f + height, z}, {-1, 0.1f + height, z});
  return all;
}

/// A level board, of which the viewer sees the upper side and the floor the lower one.
Triangles lid() {
  Triangles all;
  addQuad(all, {-1, 0.5f, 0.5f}, {1, 0.5f, 0.5f}, {1, 0.5f, -0.5f}, {-1, 0.5f, -0.5f});
  return all;
}

glm::mat4 camera() { return glm::perspective(glm::radians(50.0f), 1.0f, 0.5f, 20.0f); }
glm::mat4 view() { return glm::lookAt(glm::vec3(0, 1.2f, 3.5f), glm::vec3(0, 0.1f, 0), glm::vec3(0, 1, 0)); }

void drawBoard(Gl gl, GLuint program, const Triangles& triangles, const glm::mat4& eyeFromObject = view()) {
  drawTriangles(gl, program, triangles, {camera(), eyeFromObject, kRed});
}

/// By fixed function, lit and white: traced.
void drawFloor(Gl gl) {
  const glm::mat4 clip = camera(), eye = view();
  gl.MatrixMode(GL_PROJECTION), gl.LoadMatrixf(glm::value_ptr(clip));
  gl.MatrixMode(GL_MODELVIEW), gl.LoadMatrixf(glm::value_ptr(eye));
  gl.Enable(GL_LIGHTING);
  const float white[] = {1, 1, 1, 1};
  gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, white);
  gl.Normal3f(0, 1, 0);
  gl.Begin(GL_QUADS);
  for (const glm::vec2& p : {glm::vec2(-4, 3), {4, 3}, {4, -4}, {-4, -4}}) gl.Vertex3f(p.x, 0, p.y);
  gl.End();
  gl.Disable(GL_LIGHTING);
}

Settings mirrors(bool rasterised) {
  Settings settings = TracedContext::tracing();
  settings.light.rasterised = rasterised;
  settings.integrator = LightIntegrator::whitted;
  settings.material.kind = SurfaceMaterial::mirror;
  settings.environment.strength = 0;
  settings.path.samples = 1;
  settings.noise = 0;
  return settings;
}

CountedImage seen(const Settings& settings, const std::function<void(Gl)>& frame, int frames = 1) {
  const auto whole = [&](Gl gl) {
    gl.Viewport(0, 0, kSize, kSize);
    gl.ClearColor(0, 0, 0, 1), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Enable(GL_DEPTH_TEST), gl.DepthFunc(GL_LESS);
    frame(gl);
  };
  return seenThrough(settings, kSize, whole, frames);
}

CountedImage aboveFloor(const Settings& settings, const char* fragment, const Triangles& triangles) {
  return seen(settings, [&](Gl gl) {
    drawBoard(gl, makeProgram(gl, kVertex, fragment), triangles);
    drawFloor(gl);
  });
}

glm::ivec3 at(const DrawnImage& p, const glm::vec3& point) {
  const uint32_t color = p.colors[pixelOf(p, camera() * view(), point)];
  return {color & 255, color >> 8 & 255, color >> 16 & 255};
}

/// Where the floor shows the point.
glm::vec3 mirrored(const glm::vec3& point) { return {point.x, -point.y, point.z}; }

void expectNear(const glm::ivec3& got, const glm::ivec3& expected, int most, const std::string& where) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], expected[c], most) << where << ", channel " << c;
}

TEST(CapturedSurfaces, ARedBoardIsRedInAMirror) {
  const CountedImage on = aboveFloor(mirrors(true), kFlat, board()),
                     off = aboveFloor(mirrors(false), kFlat, board());
  EXPECT_EQ(on.counts.drawsLit, 1u);
  EXPECT_EQ(off.counts.drawsLit, 0u);
  ASSERT_EQ(on.counts.drawsTraced, 1u);
  for (const float x : {-0.8f, 0.0f, 0.8f})
    for (const float y : {0.2f, 0.6f, 0.95f}) {
      const glm::vec3 point(x, y, -1);
      EXPECT_EQ(at(on.image, point), glm::ivec3(255, 0, 0)) << "as drawn";
      EXPECT_EQ(at(on.image, mirrored(point)), glm::ivec3(255, 0, 0)) << x << ", " << y;
      EXPECT_EQ(at(off.image, mirrored(point)), glm::ivec3(0)) << x << ", " << y;
    }
  EXPECT_EQ(at(on.image, {0, 0, 1.5f}), glm::ivec3(0)) << "beside it the mirror shows nothing";
  EXPECT_EQ(on.image.depths, off.image.depths);
}

/// Where the viewer sees the surface, mirrors show its colour there.
TEST(CapturedSurfaces, MirrorsShowWhatIsDrawnPointByPoint) {
  const CountedImage places = aboveFloor(mirrors(true), kPlaces, board()),
                     halves = aboveFloor(mirrors(true), kHalves, board());
  for (const float x : {-0.9f, -0.5f, -0.1f, 0.1f, 0.5f, 0.9f})
    for (const float y : {0.2f, 0.5f, 0.9f}) {
      const glm::vec3 point(x, y, -1);
      const std::string where = std::to_string(x) + ", " + std::to_string(y);
      expectNear(at(places.image, mirrored(point)), glm::ivec3(255 * (0.5f + 0.4f * x), 255 * y, 51), 6,
                 where);
      EXPECT_EQ(at(halves.image, mirrored(point)), x < 0 ? glm::ivec3(255, 0, 0) : glm::ivec3(0, 0, 255))
          << where;
    }
}

/// The lower side of a board is not seen: mirrors show it as its upper side at the same place.
TEST(CapturedSurfaces, SidesThatAreNotSeenHaveTheColorsNearby) {
  const CountedImage got = aboveFloor(mirrors(true), kPlaces, lid());
  for (const float x : {-0.8f, 0.0f, 0.8f}) {
    const glm::vec3 point(x, 0.5f, 0);
    expectNear(at(got.image, mirrored(point)), glm::ivec3(255 * (0.5f + 0.4f * x), 127, 51), 6,
               std::to_string(x));
  }
}

/// What reaches beyond the window has the colours of what is inside.
TEST(CapturedSurfaces, WhatIsOutsideTheWindowHasTheColorsNearby) {
  const glm::vec3 above(0, 2.4f, -1);
  const CountedImage got = aboveFloor(mirrors(true), kFlat, board(-1, 3));
  ASSERT_GT((camera() * view() * glm::vec4(above, 1)).y, (camera() * view() * glm::vec4(above, 1)).w);
  EXPECT_EQ(at(got.image, mirrored(above)), glm::ivec3(255, 0, 0));
}

TEST(CapturedSurfaces, TheOrderOfDrawingDoesNotCount) {
  const DrawnImage first = aboveFloor(mirrors(true), kPlaces, board()).image;
  const CountedImage last = seen(mirrors(true), [](Gl gl) {
    const GLuint program = makeProgram(gl, kVertex, kPlaces);  // a flush point
    drawFloor(gl);
    drawBoard(gl, program, board());
  });
  EXPECT_EQ(first.depths, last.image.depths);
  size_t differ = 0;  // eye space is factored out in another way: roundings
  for (size_t i = 0; i < first.colors.size(); ++i) differ += first.colors[i] != last.image.colors[i];
  EXPECT_LT(differ, first.colors.size() / 1000);
  // Where the floor has to be traced before the board is drawn, the next frame knows the board.
  const CountedImage later = seen(
      mirrors(true),
      [](Gl gl) {
        drawFloor(gl);
        gl.Enable(GL_BLEND);  // a flush point
        gl.BlendFunc(GL_ZERO, GL_ONE);
        drawBoard(gl, makeProgram(gl, kVertex, kFlat), lid());
        gl.Disable(GL_BLEND);
        drawBoard(gl, makeProgram(gl, kVertex, kPlaces), board());
      },
      2);
  expectNear(at(later.image, {0.5f, -0.6f, -1}), at(first, {0.5f, -0.6f, -1}), 1, "in the next frame");
}

/// The matrices of programs are one product, from which eye space does not follow; scaled spaces fit none.
TEST(CapturedSurfaces, SurfacesHaveMatricesOfTheirOwn) {
  for (const bool floorFirst : {false, true}) {
    const CountedImage got = seen(mirrors(true), [&](Gl gl) {
      const GLuint program = makeProgram(gl, kVertex, kPlaces), flat = makeProgram(gl, kVertex, kFlat);
      if (floorFirst) drawFloor(gl);
      drawBoard(gl, program, board(), glm::scale(view(), glm::vec3(0.5f, 1, 1)));
      drawBoard(gl, flat, board(), glm::translate(view(), glm::vec3(1.6f, 0, 0)));
      if (!floorFirst) drawFloor(gl);
    });
    expectNear(at(got.image, mirrored({0.25f, 0.5f, -1})), glm::ivec3(255 * 0.7f, 127, 51), 6,
               "scaled, " + std::to_string(floorFirst));
    EXPECT_EQ(at(got.image, mirrored({1, 0.6f, -1})), glm::ivec3(255, 0, 0)) << "moved, " << floorFirst;
    EXPECT_EQ(at(got.image, mirrored({0.55f, 0.6f, -1})), glm::ivec3(0)) << "between them";
  }
}

TEST(CapturedSurfaces, ColorsBleedOntoTracedSurfaces) {
  Settings settings = mirrors(true);
  settings.integrator = LightIntegrator::path;
  settings.material.kind = SurfaceMaterial::matte;
  settings.environment.strength = 0.4f;
  settings.path.samples = 256;
  const DrawnImage on = aboveFloor(settings, kFlat, board()).image;
  settings.light.rasterised = false;
  const DrawnImage off = aboveFloor(settings, kFlat, board()).image;
  const glm::vec3 foot(0, 0, -0.9f), away(0, 0, 1.5f);
  const glm::ivec3 near = at(on, foot), far = at(on, away);
  const glm::ivec3 plain = at(off, foot);
  // It shines, with a radiance of 1, from the share of the sky that it hides.
  const float hidden = 1 - static_cast<float>(near.g) / static_cast<float>(plain.g);
  EXPECT_GT(hidden, 0.15f);
  EXPECT_NEAR(near.r - near.g, 255 * hidden, 6);
  EXPECT_LT(far.r, far.g + 25);
}

TEST(CapturedSurfaces, SwitchedOffChangesNoBit) {
  Settings off = TracedContext::tracing();
  Settings without = off;
  without.light.rasterised = true;
  const DrawnImage expected = aboveFloor(off, kFlat, board()).image,
                   got = aboveFloor(without, kFlat, board()).image;
  EXPECT_EQ(expected.colors, got.colors);
  EXPECT_EQ(expected.depths, got.depths);
  // Without such surfaces mirrors show what they show without the setting.
  const auto floorAlone = [](bool on) { return seen(mirrors(on), [](Gl gl) { drawFloor(gl); }).image; };
  EXPECT_EQ(floorAlone(true).colors, floorAlone(false).colors);
}

TEST(CapturedSurfaces, KeepsStateAndShowsNoErrors) {
  const auto stateAfter = [](bool on) {
    TracedContext context({kSize, kSize}, mirrors(on));
    Gl gl = context.gl();
    gl.Viewport(0, 0, kSize, kSize), gl.Enable(GL_DEPTH_TEST);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawBoard(gl, makeProgram(gl, kVertex, kFlat), board());
    drawFloor(gl);
    gl.Flush();
    return queryState(gl);
  };
  for (const std::string& line : differences(stateAfter(false), stateAfter(true))) ADD_FAILURE() << line;
}

/// In a framebuffer object, too, also with several samples a pixel.
TEST(CapturedSurfaces, FramebufferObjects) {
  for (const int samples : {0, 4}) {
    const CountedImage got = seen(mirrors(true), [samples](Gl gl) {
      bindNewFramebuffer(gl, {kSize, kSize}, GL_RGBA8, GL_DEPTH_COMPONENT24, samples);
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      drawBoard(gl, makeProgram(gl, kVertex, kFlat), board());
      drawFloor(gl);
      gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
      gl.BlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
      gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    });
    EXPECT_EQ(got.counts.drawsLit, 1u);
    for (const float x : {-0.8f, 0.1f, 0.8f})
      EXPECT_EQ(at(got.image, mirrored({x, 0.6f, -1})), glm::ivec3(255, 0, 0)) << samples << ", " << x;
  }
}

}  // namespace
}  // namespace gluray::test::captured
