// Light between a volume and surfaces of fixed function: what the settings ask for reaches both.
#include "gl/families/family.h"
#include "tests/reference/programs/volumes/volume_stage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::test {
namespace {

constexpr double kDegrees = 0;

/// A floor below the volume, which the view shows in its lower part.
void drawFloor(Gl gl) {
  const View view = perspectiveView(kDegrees);
  gl.UseProgram(0);
  gl.MatrixMode(GL_PROJECTION), gl.LoadMatrixd(&view.clipFromEye[0][0]);
  gl.MatrixMode(GL_MODELVIEW), gl.LoadMatrixd(&view.eyeFromObject[0][0]);
  gl.Disable(GL_BLEND), gl.Disable(GL_CULL_FACE), gl.DepthMask(GL_TRUE), gl.DepthFunc(GL_LESS);
  gl.Color3f(1, 1, 1);
  gl.Begin(GL_QUADS);
  gl.Vertex3f(-4, -1.2f, 3), gl.Vertex3f(4, -1.2f, 3), gl.Vertex3f(4, -1.2f, -4), gl.Vertex3f(-4, -1.2f, -4);
  gl.End();
  gl.Enable(GL_BLEND);
}

struct LitVolume {
  Settings settings = TracedContext::vertexShading();
  bool floor = true, volume = true;
  int frames = 1;
  uint64_t relit = 0;  // of the last image()

  DrawnImage image() {
    TracedContext ours(
        {kProgramWidth, kProgramHeight}, settings, nullptr, nullptr,

        std::make_shared<const gl::FamilyList>(gl::parseFamilies(casterFamily(), "test.toml")));
    Gl gl = ours.gl();
    const GLuint program = makeCaster(gl);
    const CastBox box(gl, program);
    makeVoxels(gl, {});
    for (int frame = 0; frame < frames; ++frame) {
      gl.DepthMask(GL_TRUE);
      beginFrame(gl);
      if (floor) drawFloor(gl);
      if (volume) {
        box.begin(gl, perspectiveView(kDegrees), 0, 1);  // the same opacity everywhere
        box.draw(gl);
      }
      gl.Finish();
    }
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    relit = ours.context().counts.statistics.imagesRelit;
    return ours.read();
  }
};

/// Mean of a channel in a rectangle; `bits`: how many lie before it.
double meanIn(const DrawnImage& image, int bits, int x0, int y0, int x1, int y1) {
  double sum = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
      sum += image.colors[static_cast<size_t>(y * kProgramWidth + x)] >> bits & 255;
  return sum / ((x1 - x0) * (y1 - y0));
}
/// The floor in front of the volume.
double floorIn(const DrawnImage& image) { return meanIn(image, 8, 90, 0, 110, 4); }

LitVolume occluded() {
  LitVolume scene;
  scene.settings.ao.enabled = true, scene.settings.ao.distance = 3, scene.settings.ao.samples = 64;
  return scene;
}

TEST(ProgramVolumeLight, VolumesOccludeSurfaces) {
  LitVolume scene = occluded();
  const double both = floorIn(scene.image());
  scene.volume = false;
  const double alone = floorIn(scene.image());
  EXPECT_NEAR(alone, 255, 1);
  EXPECT_LT(both, alone - 5);
}

TEST(ProgramVolumeLight, SurfacesAndTheVolumeItselfOccludeVolumes) {
  LitVolume scene = occluded();
  scene.settings.ao.strength = 0;
  const DrawnImage plain = scene.image();
  scene.settings.ao.strength = 1;
  const DrawnImage lit = scene.image();
  const auto middle = [](const DrawnImage& image) { return meanIn(image, 0, 85, 60, 115, 90); };
  EXPECT_LE(middle(lit), middle(plain) + 1);
  EXPECT_GT(middle(lit), 0.5 * middle(plain));
}

TEST(ProgramVolumeLight, WhatComesAgainIsTakenForGranted) {
  LitVolume scene = occluded();
  const DrawnImage first = scene.image();
  EXPECT_EQ(scene.relit, 1u) << "the volume comes after the floor";
  scene.frames = 3;
  const DrawnImage third = scene.image();
  EXPECT_EQ(scene.relit, 1u);
  EXPECT_NEAR(floorIn(first), floorIn(third), 3);
}

// Some of our questions about state are errors there.
TEST(ProgramVolumeLight, CoreProfilesGetNoErrors) {
  Settings settings = occluded().settings;
  auto families = std::make_shared<gl::FamilyList>(gl::builtInFamilies());
  families->append(gl::parseFamilies(casterFamily(), "test.toml"));
  TracedContext ours(coreWish(), settings, nullptr, nullptr, families);
  Gl gl = ours.gl();
  const Surface surface;
  const GLuint program = makeProgram(gl, surface), caster = makeCaster(gl);
  const ProgramMesh mesh = sheet(8);
  const Upload up = upload(gl, mesh, program);
  const CastBox box(gl, caster);
  makeVoxels(gl, {});
  for (int frame = 0; frame < 2; ++frame) {
    gl.DepthMask(GL_TRUE);
    beginFrame(gl);
    gl.Disable(GL_BLEND), gl.Disable(GL_CULL_FACE);
    drawSurface(gl, program, up, mesh, perspectiveView(70), surface);
    gl.Enable(GL_BLEND);
    box.begin(gl, perspectiveView(kDegrees), 0, 1);
    box.draw(gl);
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR)) << frame;
  }
  EXPECT_EQ(ours.context().counts.statistics.imagesRelit, 1u);
}

TEST(ProgramVolumeLight, OffChangesNoBit) {
  LitVolume scene;
  const DrawnImage off = scene.image();
  scene.settings.ao.enabled = true, scene.settings.ao.strength = 0;
  EXPECT_EQ(scene.image().colors, off.colors);
  EXPECT_EQ(scene.relit, 0u);
}

}  // namespace
}  // namespace gluray::test
