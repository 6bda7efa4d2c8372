// Textures of one and two dimensions: filters, wraps, environments, formats, matrix, sub-uploads.
#include "scenes/families.h"
#include "scenes/stage.h"
#include "scenes/texels.h"

#include <cstdint>
#include <vector>

namespace gluray::scenes {
namespace {

void litTexture(Gl gl, int width, int height, GLint filter) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.9f, 0.9f, 0.9f);
  gl.Enable(GL_TEXTURE_2D);
  upload(gl, GL_RGB, 16, filter, GL_REPEAT);
  gl.Rotatef(-40, 1, 0, 0);
  gl.MatrixMode(GL_TEXTURE);
  gl.Scalef(6, 3, 1);
  gl.MatrixMode(GL_MODELVIEW);
  send(gl, torus(0.9f, 0.4f, 60, 30), kNormals | kTexcoords);
}
void textureNearest(Gl gl, int width, int height) { litTexture(gl, width, height, GL_NEAREST); }
void textureLinear(Gl gl, int width, int height) { litTexture(gl, width, height, GL_LINEAR); }

/// Colour map along one coordinate, as scalar fields are shown.
void colorMap1d(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 1, 1, 1);
  uint8_t map[32][3];
  for (int i = 0; i < 32; ++i)
    map[i][0] = static_cast<uint8_t>(i * 8), map[i][1] = static_cast<uint8_t>(128 + (i % 8) * 12),
    map[i][2] = static_cast<uint8_t>(255 - i * 8);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 32, 0, GL_RGB, GL_UNSIGNED_BYTE, map);
  for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_1D, filter, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.Enable(GL_TEXTURE_1D);
  const Model m = sheet(40);
  gl.Rotatef(-50, 1, 0, 0);
  gl.Begin(GL_TRIANGLES);
  for (const uint32_t i : m.indices) {
    gl.TexCoord1f(m.positions[i * 3 + 2] * 2.5f + 0.5f);
    gl.Normal3fv(&m.normals[i * 3]);
    gl.Vertex3fv(&m.positions[i * 3]);
  }
  gl.End();
}

void wraps(Gl gl, int width, int height, GLint filter) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  const float border[] = {1, 0.8f, 0, 1};
  gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
  const GLint modes[] = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT};
  for (int i = 0; i < 5; ++i) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    upload(gl, GL_RGBA, 8, filter, modes[i]);
    gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    quad(gl, -0.8f + 0.8f * static_cast<float>(i % 3), i < 3 ? 0.45f : -0.45f, 0.36f, -0.8f, 1.7f);
  }
}
void wrapsNearest(Gl gl, int width, int height) { wraps(gl, width, height, GL_NEAREST); }
void wrapsLinear(Gl gl, int width, int height) { wraps(gl, width, height, GL_LINEAR); }

/// Every environment with every base format.
void environments(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  const GLint formats[] = {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA};
  const GLint environments[] = {GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD};
  const float color[] = {0.9f, 0.3f, 0.1f, 0.6f};
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
  for (int f = 0; f < 6; ++f) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    upload(gl, formats[f], 16, GL_NEAREST, GL_REPEAT);
    for (int e = 0; e < 5; ++e) {
      const bool decal = environments[e] == GL_DECAL && formats[f] != GL_RGB && formats[f] != GL_RGBA;
      if (decal) continue;  // undefined
      gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, environments[e]);
      gl.Color4f(0.4f, 0.7f, 0.5f, 1);
      quad(gl, -1.0f + 0.4f * static_cast<float>(f), -0.75f + 0.37f * static_cast<float>(e), 0.17f, 0, 1);
    }
  }
}

/// Specular light added after the texture, and before it.
void separateSpecular(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.8f, 0.8f, 0.8f);
  material(gl, GL_FRONT, GL_SPECULAR, {1, 1, 1, 1});
  gl.Materialf(GL_FRONT, GL_SHININESS, 25);
  gl.Enable(GL_TEXTURE_2D);
  gl.Enable(GL_NORMALIZE);
  upload(gl, GL_RGB, 8, GL_NEAREST, GL_REPEAT);
  const Model ball = sphere(40, 60);
  sendAt(gl, ball, -0.9f, 0, 0, 0.8f, kNormals | kTexcoords);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  sendAt(gl, ball, 0.9f, 0, 0, 0.8f, kNormals | kTexcoords);
}

/// A texture changed between two draws of the same frame, whole and in part, from a larger image.
void subImage(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  upload(gl, GL_RGBA, 16, GL_NEAREST, GL_REPEAT);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  quad(gl, -0.9f, 0, 0.4f, 0, 1);
  const auto large = pattern(32);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 32);
  gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 10);
  gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 7);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 4, 5, 9, 6, GL_RGBA, GL_UNSIGNED_BYTE, large.data());
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 0);
  gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
  quad(gl, 0, 0, 0.4f, 0, 1);
  const uint16_t stripes[] = {0xf800, 0x07e0, 0x001f, 0xffff};
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 1, 0, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, stripes);
  quad(gl, 0.9f, 0, 0.4f, 0, 1);
}

/// Two textures in turn, one of which changes: by level, by name given back, by the cube map's face.
void changedAmongOthers(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.Enable(GL_TEXTURE_2D);
  const GLuint first = bindFresh(gl, GL_TEXTURE_2D);
  upload(gl, GL_RGBA, 16, GL_NEAREST, GL_REPEAT);
  const GLuint second = bindFresh(gl, GL_TEXTURE_2D);
  upload(gl, GL_LUMINANCE, 16, GL_NEAREST, GL_REPEAT);
  const auto both = [&](float y) {
    gl.BindTexture(GL_TEXTURE_2D, first), quad(gl, -0.9f, y, 0.28f, 0, 1);
    gl.BindTexture(GL_TEXTURE_2D, second), quad(gl, -0.2f, y, 0.28f, 0, 1);
  };
  both(-0.65f);
  const std::vector<uint8_t> gray(8 * 8 * 4, 130);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, gray.data());
  both(0);
  gl.DeleteTextures(1, &first);
  gl.BindTexture(GL_TEXTURE_2D, first);
  upload(gl, GL_RGB, 8, GL_NEAREST, GL_REPEAT);
  both(0.65f);
  gl.Disable(GL_TEXTURE_2D), gl.Enable(GL_TEXTURE_CUBE_MAP);
  for (GLenum face = 0; face < 6; ++face)
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  gray.data());
  sampling(gl, GL_TEXTURE_CUBE_MAP, GL_NEAREST, GL_CLAMP_TO_EDGE);
  quad(gl, 0.6f, -0.4f, 0.35f, 0, 1);
  const auto texels = pattern(8);
  gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Y, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                texels.data());
  quad(gl, 0.6f, 0.4f, 0.35f, 0, 1);
}

/// Texture coordinates with q, in perspective, turned by the texture matrix.
void projectedTexture(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height, 3);
  gl.Enable(GL_TEXTURE_2D);
  upload(gl, GL_RGB, 16, GL_NEAREST, GL_REPEAT);
  gl.MatrixMode(GL_TEXTURE);
  gl.Translatef(0.5f, 0.5f, 0);
  gl.Rotatef(30, 0, 0, 1);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Rotatef(-55, 1, 0, 0);
  gl.Begin(GL_TRIANGLE_FAN);
  gl.TexCoord4f(0, 0.4f, 0, 1.4f), gl.Vertex2f(0, 0);
  for (const float x : {-1.0f, 1.0f}) gl.TexCoord4f(x, -1, 0, 1), gl.Vertex2f(x, -1);
  for (const float x : {1.0f, -1.0f}) gl.TexCoord4f(2 * x, 2, 0, 2), gl.Vertex2f(x, 1);
  gl.TexCoord4f(-1, -1, 0, 1), gl.Vertex2f(-1, -1);
  gl.End();
}

/// Texturing enabled for everything, as viewers do, with nothing loaded into the texture.
void textureWithoutImage(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.9f, 0.6f, 0.2f);
  gl.Enable(GL_TEXTURE_2D);
  send(gl, torus(0.9f, 0.4f, 60, 30), kNormals | kTexcoords);
}

constexpr Scene kTextureScenes[] = {
    {"texture-nearest", textureNearest},
    {"texture-linear", textureLinear},
    {"color-map-1d", colorMap1d},
    {"wraps-nearest", wrapsNearest},
    {"wraps-linear", wrapsLinear},
    {"texture-environments", environments, true, kTexelEdges},
    {"separate-specular", separateSpecular},
    {"texture-sub-image", subImage},
    {"texture-changed-among-others", changedAmongOthers, true, kTexelEdges},
    {"projected-texture", projectedTexture},
    {"texture-without-image", textureWithoutImage},
};

}  // namespace

std::span<const Scene> textureScenes() { return kTextureScenes; }

}  // namespace gluray::scenes
