// Mipmapped minification: filters, bias, limits, generated levels, incomplete textures.
#include "scenes/families.h"
#include "scenes/stage.h"
#include "scenes/texels.h"

namespace gluray::scenes {
namespace {

constexpr Tolerance kLevelEdges{2, 0.001, 1e-5f,
                                "where the level changes, a quad of pixels may fall to either side"};

void mipmapStage(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

/// A floor to the horizon, on it a ball: steps and slopes of every size.
void filtered(Gl gl, int width, int height, GLint minFilter, GLint magFilter = GL_LINEAR) {
  mipmapStage(gl, width, height);
  tintedLevels(gl, 32);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minFilter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magFilter);
  ground(gl, 1);
  gl.MatrixMode(GL_TEXTURE);
  gl.Scalef(3, 2, 1);
  gl.MatrixMode(GL_MODELVIEW);
  sendAt(gl, sphere(24, 36), -0.4f, 0.2f, 0.5f, 0.7f, kTexcoords);
}
void nearestNearest(Gl gl, int w, int h) { filtered(gl, w, h, GL_NEAREST_MIPMAP_NEAREST); }
void linearNearest(Gl gl, int w, int h) { filtered(gl, w, h, GL_LINEAR_MIPMAP_NEAREST); }
void nearestLinear(Gl gl, int w, int h) { filtered(gl, w, h, GL_NEAREST_MIPMAP_LINEAR); }
void linearLinear(Gl gl, int w, int h) { filtered(gl, w, h, GL_LINEAR_MIPMAP_LINEAR); }
void sharpMagnified(Gl gl, int w, int h) { filtered(gl, w, h, GL_LINEAR_MIPMAP_LINEAR, GL_NEAREST); }
void minMagApart(Gl gl, int w, int h) { filtered(gl, w, h, GL_LINEAR, GL_NEAREST); }

/// Bias of the texture on the left, of the unit on the right, of both in the middle.
void bias(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  tintedLevels(gl, 32);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 3; ++column) {
      const float amount = -1.1f + 0.9f * static_cast<float>(row);
      gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, column < 2 ? amount : 0);
      gl.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, column > 0 ? amount : 0);
      quad(gl, -0.8f + 0.8f * static_cast<float>(column), -0.72f + 0.48f * static_cast<float>(row), 0.22f, 0,
           3.1f);
    }
}

void limits(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  const struct {
    float minLod, maxLod;
    GLint base, most;
  } rows[] = {{-1000, 1000, 0, 1000}, {2.3f, 1000, 0, 1000}, {-1000, 0.8f, 0, 1000}, {1, 1, 0, 1000},
              {-1000, 1000, 2, 1000}, {-1000, 1000, 0, 1},   {-1000, 1000, 1, 2},    {0.6f, 1.4f, 1, 4}};
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 2; ++k) {
      bindFresh(gl, GL_TEXTURE_2D);
      tintedLevels(gl, 32);
      gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                       k ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
      gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, rows[i].minLod);
      gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, rows[i].maxLod);
      gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, rows[i].base);
      gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, rows[i].most);
      quad(gl, -0.9f + 0.6f * static_cast<float>(i % 4), -0.7f + 0.46f * static_cast<float>(i / 4 * 2 + k),
           0.21f, 0, 3.3f);
    }
}

/// Levels that OpenGL makes: with every change of the image, and on demand.
void generated(Gl gl, int width, int height) {
  mipmapStage(gl, width, height);
  const auto texels = pattern(64);
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  ground(gl, 0.7f);
  const std::vector<uint8_t> red(16 * 16 * 4, 255);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 20, 20, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, red.data());
  sendAt(gl, sphere(24, 36), -0.8f, 0.2f, 0.5f, 0.5f, kTexcoords);
  bindFresh(gl, GL_TEXTURE_2D);
  const auto wide = pattern(48, 20);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 48, 20, 0, GL_RGBA, GL_UNSIGNED_BYTE, wide.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  gl.GenerateMipmap(GL_TEXTURE_2D);
  sendAt(gl, torus(0.6f, 0.3f, 40, 24), 0.8f, 0.2f, 0.3f, 0.8f, kTexcoords);
}

/// Into a framebuffer object, whose rows are counted from the bottom, of odd height; read from there.
void intoFramebufferObject(Gl gl, int width, int height) {
  GLuint framebuffer = 0, buffers[2];
  gl.GenFramebuffers(1, &framebuffer), gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.GenRenderbuffers(2, buffers);
  const GLenum formats[] = {GL_RGBA8, GL_DEPTH_COMPONENT24},
               places[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  for (int i = 0; i < 2; ++i) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, formats[i], width, height + 1);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, buffers[i]);
  }
  filtered(gl, width, height + 1, GL_LINEAR_MIPMAP_LINEAR);
}

void oneDimensional(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Enable(GL_TEXTURE_1D);
  GLint level = 0;
  for (int side = 64; side >= 1; side /= 2, ++level) {
    std::vector<uint8_t> stripes;
    for (int i = 0; i < side; ++i)
      for (int k = 0; k < 4; ++k)
        stripes.push_back(static_cast<uint8_t>(k == level % 3 ? 255 : (i % 4 < 2 ? 40 : 160)));
    gl.TexImage1D(GL_TEXTURE_1D, level, GL_RGB, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, stripes.data());
  }
  gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  ground(gl, 1);
}

/// The default filter needs levels that nobody loaded: texturing is as if disabled.
void incomplete(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.4f, 0.9f, 0.6f);
  gl.Enable(GL_TEXTURE_2D);
  const auto texels = pattern(16);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  sendAt(gl, sphere(24, 36), -0.9f, 0, 0, 0.7f, kNormals | kTexcoords);
  gl.TexImage2D(GL_TEXTURE_2D, 1, GL_RGB, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  sendAt(gl, sphere(24, 36), 0.9f, 0.5f, 0, 0.4f, kNormals | kTexcoords);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  sendAt(gl, sphere(24, 36), 0.9f, -0.5f, 0, 0.4f, kNormals | kTexcoords);
}

/// Traced where the renderer knows the real OpenGL's filter.
void anisotropic(Gl gl, int width, int height) {
  mipmapStage(gl, width, height);
  tintedLevels(gl, 32);
  gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 4);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  ground(gl, 1);
}

constexpr Scene kMipmapScenes[] = {
    {"mipmap-nearest-nearest", nearestNearest, true, kLevelEdges},
    {"mipmap-linear-nearest", linearNearest, true, kLevelEdges},
    {"mipmap-nearest-linear", nearestLinear, true, kLevelEdges},
    {"mipmap-linear-linear", linearLinear, true, kLevelEdges},
    {"mipmap-sharp-magnified", sharpMagnified, true, kLevelEdges},
    {"min-mag-apart", minMagApart, true, kLevelEdges},
    {"mipmap-bias", bias, true, kLevelEdges},
    {"mipmap-limits", limits, true, kLevelEdges},
    {"mipmap-generated", generated, true, kLevelEdges},
    {"mipmap-into-framebuffer-object", intoFramebufferObject, true, kLevelEdges},
    {"mipmap-1d", oneDimensional, true, kLevelEdges},
    {"mipmap-incomplete", incomplete},
    {"anisotropic-filter", anisotropic, false, kLevelEdges},
};

}  // namespace

std::span<const Scene> mipmapScenes() { return kMipmapScenes; }

}  // namespace gluray::scenes
