// Blended fixed-function surfaces whose alpha comes from textures, among them opaque ones.
#include "tests/reference/layers/drawn_layers_stage.h"

#include <cstdint>
#include <vector>

namespace gluray::test::drawn_layers {
namespace {

constexpr GLsizei kTexels = 16;

/// A disc with an opaque middle, a different colour in each texel, and transparent surroundings.
std::vector<uint32_t> disc(bool opaque) {
  std::vector<uint32_t> texels;
  for (int y = 0; y < kTexels; ++y) {
    for (int x = 0; x < kTexels; ++x) {
      const int dx = 2 * x - kTexels + 1, dy = 2 * y - kTexels + 1, far = dx * dx + dy * dy;
      const int alpha = opaque ? 255 : far < 60 ? 255 : far < 180 ? 120 : 0;
      texels.push_back(static_cast<uint32_t>(15 * x + 20) | static_cast<uint32_t>(12 * y + 30) << 8 |
                       90u << 16 | static_cast<uint32_t>(alpha) << 24);
    }
  }
  return texels;
}

void layerTexture(Gl gl, GLenum kept, GLenum mode, bool opaque = false) {
  gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(kept), kTexels, kTexels, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                disc(opaque).data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  const Color blue = {0.1f, 0.2f, 0.9f, 0.6f};
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, blue.data());
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(mode));
  gl.Enable(GL_TEXTURE_2D);
}

/// Intersecting rectangles, nearest first and farthest first.
void cards(Gl gl, float alpha) {
  gl.Disable(GL_LIGHTING);
  for (const float z : {0.5f, -0.5f, 0.1f}) {
    gl.Color4f(1, 0.8f, 0.9f, alpha);
    gl.Begin(GL_QUADS);
    gl.TexCoord2f(0, 0), gl.Vertex3f(-1, -0.9f, z - 0.3f);
    gl.TexCoord2f(1, 0), gl.Vertex3f(0.9f, -1, z + 0.3f);
    gl.TexCoord2f(1, 1), gl.Vertex3f(1, 0.9f, z + 0.3f);
    gl.TexCoord2f(0, 1), gl.Vertex3f(-0.9f, 1, z - 0.3f);
    gl.End();
    gl.Translatef(0.2f, -0.1f, 0), gl.Rotatef(25, 0, 1, 0);
  }
}

TEST(DrawnTextures, BringTheirAlphaInEveryEnvironment) {
  for (const GLenum mode : {GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD}) {
    for (const GLenum kept : {GL_RGBA8, GL_ALPHA8, GL_LUMINANCE8_ALPHA8, GL_INTENSITY8}) {
      if (mode == GL_DECAL && kept != GL_RGBA8) continue;  // undefined
      for (const bool writes : {true, false}) {
        const auto draw = [&](Gl gl) {
          layerTexture(gl, kept, mode);
          blendOver(gl);
          gl.DepthMask(writes);
          cards(gl, 0.7f);
        };
        const std::string name =
            "mode " + std::to_string(mode) + " of " + std::to_string(kept) + (writes ? " writing" : "");
        EXPECT_EQ(compareBoth(theStage(), name, draw).drawsTraced, 3u) << name;
      }
    }
  }
}

/// Like foliage.
TEST(DrawnTextures, AreCutOutAndBlended) {
  const auto draw = [](Gl gl) {
    layerTexture(gl, GL_RGBA8, GL_MODULATE);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    blendOver(gl);
    gl.Enable(GL_ALPHA_TEST), gl.AlphaFunc(GL_GREATER, 0.3f);
    cards(gl, 1);
  };
  expectTraced("cut out", draw, 3);
}

TEST(DrawnTextures, OfTwoUnits) {
  const auto draw = [](Gl gl) {
    layerTexture(gl, GL_RGBA8, GL_MODULATE);
    gl.ActiveTexture(GL_TEXTURE1);
    GLuint second = 0;
    gl.GenTextures(1, &second), gl.BindTexture(GL_TEXTURE_2D, second);
    layerTexture(gl, GL_LUMINANCE8_ALPHA8, GL_MODULATE);
    gl.MultiTexCoord2f(GL_TEXTURE1, 0.6f, 0.5f);
    blendOver(gl);
    cards(gl, 0.9f);
    gl.ActiveTexture(GL_TEXTURE0);
  };
  expectTraced("two units", draw, 3);
}

/// As in programs that leave blending on for everything: opaque surfaces are traced in one image.
TEST(BlendedOpaque, IsTracedInOneBatch) {
  const struct {
    const char* name;
    void (*prepare)(Gl gl);
  } kinds[] = {
      {"material", [](Gl) {}},
      {"a texture of alpha 1", [](Gl gl) { layerTexture(gl, GL_RGBA8, GL_MODULATE, true); }},
      {"a texture without alpha", [](Gl gl) { layerTexture(gl, GL_RGB8, GL_REPLACE); }},
      {"a texture put on as decal", [](Gl gl) { layerTexture(gl, GL_RGBA8, GL_DECAL); }},
      {"unlit", [](Gl gl) { gl.Disable(GL_LIGHTING), gl.Color3f(0.2f, 0.9f, 0.4f); }},
      {"colour material", [](Gl gl) { gl.Enable(GL_COLOR_MATERIAL), gl.Color3f(0.2f, 0.9f, 0.4f); }},
      {"fog", [](Gl gl) { gl.Enable(GL_FOG), gl.Fogi(GL_FOG_MODE, GL_LINEAR), gl.Fogf(GL_FOG_END, 5); }},
  };
  for (const auto& kind : kinds) {
    const auto draw = [&](Gl gl) {
      kind.prepare(gl);
      blendOver(gl);
      for (const Ball& b : kBalls) ball(gl, {b.x, b.z, {b.color[0], b.color[1], b.color[2], 1}});
    };
    const gl::Statistics counted = compareBoth(theStage(), kind.name, draw);
    EXPECT_EQ(counted.drawsTraced, 3u) << kind.name;
    EXPECT_EQ(counted.flushes, 1u) << kind.name;
  }
}

/// Byte colours, as in VisIt's meshes: surfaces with alpha 255 are opaque, others layers.
TEST(BlendedOpaque, IsKnownByTheColorsOfItsVertices) {
  const Model model = torus(0.8f, 0.3f, 30, 16);
  for (const GLubyte alpha : {GLubyte{255}, GLubyte{254}, GLubyte{100}}) {
    std::vector<uint32_t> colors(model.positions.size(), 0x0040a0e0u | static_cast<uint32_t>(alpha) << 24);
    for (size_t i = 0; i < colors.size(); ++i) colors[i] += static_cast<uint32_t>(i % 16);
    const auto draw = [&](Gl gl) {
      blendOver(gl);
      gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE), gl.Enable(GL_COLOR_MATERIAL);
      gl.EnableClientState(GL_VERTEX_ARRAY), gl.EnableClientState(GL_NORMAL_ARRAY);
      gl.EnableClientState(GL_COLOR_ARRAY), gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, colors.data());
      gl.VertexPointer(3, GL_FLOAT, 0, model.positions.data());
      gl.NormalPointer(GL_FLOAT, 0, model.normals.data());
      for (int i = 0; i < 3; ++i) {
        gl.Rotatef(35, 1, 0.4f, 0);
        gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(model.indices.size()), GL_UNSIGNED_INT,
                        model.indices.data());
      }
      gl.DisableClientState(GL_COLOR_ARRAY);
      gl.Disable(GL_COLOR_MATERIAL);
    };
    expectTraced("alpha " + std::to_string(alpha), draw, 3);
  }
}

}  // namespace
}  // namespace gluray::test::drawn_layers
