// Textures of other kinds and formats: 3D, cube, rectangle, borders, precision, sRGB, compressed, depth.
#include "scenes/families.h"
#include "scenes/stage.h"
#include "scenes/texels.h"

#include <cmath>

namespace gluray::scenes {
namespace {

constexpr Tolerance kFaceEdges{
    3, 0.005, 1e-5f,
    "derivatives of a cube map's coordinates jump where quads of pixels reach over "
    "an edge of a face or a silhouette"};

void replaceStage(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

std::vector<uint8_t> volume(int size) {
  std::vector<uint8_t> texels;
  for (int z = 0; z < size; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        texels.push_back(static_cast<uint8_t>(x * 255 / (size - 1)));
        texels.push_back(static_cast<uint8_t>((x / 2 + y / 2 + z / 2) % 2 ? 220 : 60));
        texels.push_back(static_cast<uint8_t>(z * 255 / (size - 1)));
        texels.push_back(255);
      }
  return texels;
}

/// A ball cut out of a volume, by every filter; wraps of r.
void volumes(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Enable(GL_TEXTURE_3D);
  const auto texels = volume(8);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGB, 8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  const GLint wraps[] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT};
  const Model ball = sphere(24, 36);
  for (int i = 0; i < 4; ++i) {
    sampling(gl, GL_TEXTURE_3D, i % 2 ? GL_LINEAR : GL_NEAREST, wraps[i]);
    const float x = i % 2 ? 0.6f : -0.6f, y = i < 2 ? 0.5f : -0.5f;
    gl.Begin(GL_TRIANGLES);
    for (const uint32_t v : ball.indices) {
      const float* p = &ball.positions[v * 3];
      gl.TexCoord3f(p[0] * 0.8f + 0.5f, p[1] * 0.8f + 0.5f, p[2] * 0.8f + 0.5f);
      gl.Vertex3f(x + 0.48f * p[0], y + 0.48f * p[1], 0.48f * p[2]);
    }
    gl.End();
  }
}

void volumeLevels(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Enable(GL_TEXTURE_3D);
  const auto texels = volume(16);
  gl.TexParameteri(GL_TEXTURE_3D, GL_GENERATE_MIPMAP, GL_TRUE);
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGB, 16, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.MatrixMode(GL_TEXTURE);
  gl.Rotatef(40, 1, 1, 0);
  gl.MatrixMode(GL_MODELVIEW);
  ground(gl, 0.4f);
}

void cubeFaces(Gl gl, int size, GLint level) {
  for (GLenum face = 0; face < 6; ++face) {
    auto texels = pattern(size);
    for (size_t i = 2; i < texels.size(); i += 4) texels[i] = static_cast<uint8_t>(40 * face + texels[i] / 6);
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, GL_RGB, size, size, 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, texels.data());
  }
}

/// Positions of a ball as directions.
void cubeBall(Gl gl, float x, float stretch) {
  const Model ball = sphere(24, 36);
  gl.Begin(GL_TRIANGLES);
  for (const uint32_t v : ball.indices) {
    const float* p = &ball.positions[v * 3];
    gl.TexCoord3f(p[0], p[1] * stretch, p[2]);
    gl.Vertex3f(x + 0.8f * p[0], 0.8f * p[1], 0.8f * p[2]);
  }
  gl.End();
}

void cube(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Enable(GL_TEXTURE_CUBE_MAP);
  cubeFaces(gl, 8, 0);
  sampling(gl, GL_TEXTURE_CUBE_MAP, GL_NEAREST, GL_CLAMP_TO_EDGE);
  gl.Rotatef(30, 1, 1, 0);
  cubeBall(gl, -0.9f, 1);
  sampling(gl, GL_TEXTURE_CUBE_MAP, GL_LINEAR, GL_CLAMP_TO_EDGE);
  cubeBall(gl, 0.9f, 0.4f);
}

void cubeLevels(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Enable(GL_TEXTURE_CUBE_MAP);
  GLint level = 0;
  for (int side = 64; side >= 1; side /= 2) cubeFaces(gl, side, level++);
  sampling(gl, GL_TEXTURE_CUBE_MAP, GL_LINEAR, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.Rotatef(30, 1, 1, 0);
  cubeBall(gl, -0.9f, 1);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  cubeBall(gl, 0.9f, 2);
}

/// Coordinates in texels, sizes that are no powers of two.
void rectangle(Gl gl, int width, int height) {
  replaceStage(gl, width, height);
  gl.Enable(GL_TEXTURE_RECTANGLE);
  const auto texels = pattern(20, 12);
  const float border[] = {1, 0.8f, 0, 1};
  const GLint wraps[] = {GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER};
  gl.TexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_RGBA, 20, 12, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.TexParameterfv(GL_TEXTURE_RECTANGLE, GL_TEXTURE_BORDER_COLOR, border);
  for (int i = 0; i < 6; ++i) {
    sampling(gl, GL_TEXTURE_RECTANGLE, i < 3 ? GL_NEAREST : GL_LINEAR, wraps[i % 3]);
    quad(gl, -0.8f + 0.8f * static_cast<float>(i % 3), i < 3 ? 0.45f : -0.45f, 0.36f, -4, 19);
  }
}

void border(Gl gl, int width, int height) {
  replaceStage(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  const auto texels = pattern(10);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 10, 10, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  const GLint wraps[] = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_BORDER};
  for (int i = 0; i < 6; ++i) {
    sampling(gl, GL_TEXTURE_2D, i < 3 ? GL_NEAREST : GL_LINEAR, wraps[i % 3]);
    quad(gl, -0.8f + 0.8f * static_cast<float>(i % 3), i < 3 ? 0.45f : -0.45f, 0.36f, -0.4f, 1.3f);
  }
}

void mirrorClamps(Gl gl, int width, int height) {
  replaceStage(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  upload(gl, GL_RGBA, 8, GL_NEAREST, GL_REPEAT);
  const float border[] = {1, 0.8f, 0, 1};
  gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
  const GLint wraps[] = {GL_MIRROR_CLAMP_EXT, GL_MIRROR_CLAMP_TO_EDGE, GL_MIRROR_CLAMP_TO_BORDER_EXT};
  for (int i = 0; i < 6; ++i) {
    sampling(gl, GL_TEXTURE_2D, i < 3 ? GL_NEAREST : GL_LINEAR, wraps[i % 3]);
    quad(gl, -0.8f + 0.8f * static_cast<float>(i % 3), i < 3 ? 0.45f : -0.45f, 0.36f, -1.4f, 1.3f);
  }
}

/// Formats beyond eight bits, or below; values that a later unit brings back into range.
void precise(Gl gl, int width, int height) {
  replaceStage(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  std::vector<float> texels;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      for (int k = 0; k < 4; ++k)
        texels.push_back(k == 0   ? static_cast<float>(x) / 15.0f
                         : k == 1 ? 0.5f + 0.5f * std::sin(static_cast<float>(x * y) * 0.1f)
                         : k == 2 ? static_cast<float>(y) / 15.0f
                                  : 0.8f);
  const GLint formats[] = {GL_RGBA16,
                           GL_LUMINANCE16,
                           GL_LUMINANCE16_ALPHA16,
                           GL_INTENSITY16,
                           GL_RGBA32F,
                           GL_RGB16F,
                           GL_LUMINANCE32F_ARB,
                           GL_RGB10_A2,
                           GL_R3_G3_B2,
                           GL_RGBA4,
                           GL_RGB5_A1,
                           GL_ALPHA16};
  for (int i = 0; i < 12; ++i) {
    bindFresh(gl, GL_TEXTURE_2D);
    gl.TexImage2D(GL_TEXTURE_2D, 0, formats[i], 16, 16, 0, GL_RGBA, GL_FLOAT, texels.data());
    sampling(gl, GL_TEXTURE_2D, GL_LINEAR, GL_CLAMP_TO_EDGE);
    quad(gl, -0.9f + 0.6f * static_cast<float>(i % 4), -0.65f + 0.65f * static_cast<float>(i / 4), 0.28f, 0,
         1);
  }
}

void srgb(Gl gl, int width, int height) {
  replaceStage(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  const GLint formats[] = {GL_SRGB8, GL_SRGB8_ALPHA8, GL_SLUMINANCE8, GL_SLUMINANCE8_ALPHA8};
  for (int i = 0; i < 4; ++i) {
    bindFresh(gl, GL_TEXTURE_2D);
    upload(gl, formats[i], 16, i % 2 ? GL_LINEAR : GL_NEAREST, GL_REPEAT);
    quad(gl, i % 2 ? 0.5f : -0.5f, i < 2 ? 0.5f : -0.5f, 0.45f, 0, 1);
  }
}

/// Images that the real OpenGL compresses and those that come compressed.
void compressed(Gl gl, int width, int height) {
  replaceStage(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  const GLint formats[] = {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT,
                           GL_COMPRESSED_RGB};
  for (int i = 0; i < 3; ++i) {
    bindFresh(gl, GL_TEXTURE_2D);
    upload(gl, formats[i], 16, GL_LINEAR, GL_REPEAT);
    quad(gl, -0.8f + 0.8f * static_cast<float>(i), 0.4f, 0.36f, 0, 1);
  }
  // Four texels by four: white and blue ends, indices in steps.
  const uint8_t block[] = {0xff, 0xff, 0x1f, 0x00, 0xe4, 0x1b, 0xe4, 0x1b};
  bindFresh(gl, GL_TEXTURE_2D);
  gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 0, sizeof block, block);
  sampling(gl, GL_TEXTURE_2D, GL_NEAREST, GL_REPEAT);
  quad(gl, 0, -0.4f, 0.36f, 0, 1);
}

/// Depth shown as luminance, intensity and alpha.
void depthShown(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  std::vector<float> depths;
  for (int i = 0; i < 256; ++i) depths.push_back(static_cast<float>(i) / 255.0f);
  const GLint modes[] = {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA};
  for (int i = 0; i < 3; ++i) {
    bindFresh(gl, GL_TEXTURE_2D);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 16, 16, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                  depths.data());
    sampling(gl, GL_TEXTURE_2D, GL_LINEAR, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, modes[i]);
    gl.Color4f(0.9f, 0.8f, 0.4f, 1);
    quad(gl, -0.8f + 0.8f * static_cast<float>(i), 0, 0.36f, 0, 1);
  }
}

/// Scale, bias and maps change what is loaded, not what is drawn; they stay set throughout.
void pixelTransfer(Gl gl, int width, int height) {
  replaceStage(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  upload(gl, GL_RGBA, 16, GL_NEAREST, GL_REPEAT);
  gl.PixelTransferf(GL_RED_SCALE, 0.5f), gl.PixelTransferf(GL_GREEN_BIAS, 0.3f);
  quad(gl, -0.8f, 0, 0.36f, 0, 1);
  bindFresh(gl, GL_TEXTURE_2D);
  upload(gl, GL_RGBA, 16, GL_NEAREST, GL_REPEAT);
  quad(gl, 0, 0, 0.36f, 0, 1);
  bindFresh(gl, GL_TEXTURE_2D);  // here, because the map makes what is drawn so far be written
  const float inverse[] = {1, 0};
  gl.PixelMapfv(GL_PIXEL_MAP_B_TO_B, 2, inverse);
  gl.PixelTransferi(GL_MAP_COLOR, GL_TRUE);
  upload(gl, GL_RGB, 16, GL_NEAREST, GL_REPEAT);
  quad(gl, 0.8f, 0, 0.36f, 0, 1);
  gl.PixelTransferi(GL_MAP_COLOR, GL_FALSE);  // the harness reads the image back
  gl.PixelTransferf(GL_RED_SCALE, 1), gl.PixelTransferf(GL_GREEN_BIAS, 0);
}

constexpr Scene kTextureKindScenes[] = {
    {"texture-3d", volumes, true, kTexelEdges},
    {"texture-3d-levels", volumeLevels, true, kTexelEdges},
    {"texture-cube", cube, true, kTexelEdges},
    {"texture-cube-levels", cubeLevels, true, kFaceEdges},
    {"texture-rectangle", rectangle, true, kTexelEdges},
    {"texture-border", border, true, kTexelEdges},
    {"texture-mirror-clamp", mirrorClamps, true, kTexelEdges},
    {"texture-precise", precise, true, kTexelEdges},
    {"texture-srgb", srgb, true, kTexelEdges},
    {"texture-compressed", compressed, true, kTexelEdges},
    {"texture-depth", depthShown, true, kTexelEdges},
    {"texture-pixel-transfer", pixelTransfer, true, kTexelEdges},
};

}  // namespace

std::span<const Scene> textureKindScenes() { return kTextureKindScenes; }

}  // namespace gluray::scenes
