#include "scenes/texels.h"

#include <algorithm>

namespace gluray::scenes {

std::vector<uint8_t> pattern(int width, int height) {
  std::vector<uint8_t> texels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool check = ((x * 4 / width) + (y * 4 / height)) % 2 == 0;
      texels.push_back(static_cast<uint8_t>(x * 255 / std::max(width - 1, 1)));
      texels.push_back(static_cast<uint8_t>(y * 255 / std::max(height - 1, 1)));
      texels.push_back(check ? 230 : 40);
      texels.push_back(check ? 255 : 90);
    }
  return texels;
}

void sampling(Gl gl, GLenum target, GLint filter, GLint wrap) {
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_S, wrap);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_T, wrap);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_R, wrap);
}

GLuint bindFresh(Gl gl, GLenum target) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(target, name);
  return name;
}

void upload(Gl gl, GLint internalFormat, int size, GLint filter, GLint wrap) {
  const auto texels = pattern(size);
  gl.TexImage2D(GL_TEXTURE_2D, 0, internalFormat, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  sampling(gl, GL_TEXTURE_2D, filter, wrap);
}

void tintedLevels(Gl gl, int size) {
  constexpr uint8_t kTints[][3] = {{250, 240, 230}, {240, 60, 40}, {40, 220, 60},
                                   {60, 80, 250},   {250, 220, 0}, {220, 0, 230}};
  GLint level = 0;
  for (int side = size; side >= 1; side /= 2, ++level) {
    const auto& tint = kTints[level % 6];
    std::vector<uint8_t> texels;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        for (int k = 0; k < 4; ++k)
          texels.push_back(k == 3 ? 255 : static_cast<uint8_t>((x / 2 + y / 2) % 2 ? tint[k] / 2 : tint[k]));
    gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  }
}

void quad(Gl gl, float x, float y, float half, float low, float high) {
  gl.Begin(GL_QUADS);
  gl.Normal3f(0, 0, 1);
  gl.TexCoord2f(low, low), gl.Vertex2f(x - half, y - half);
  gl.TexCoord2f(high, low), gl.Vertex2f(x + half, y - half);
  gl.TexCoord2f(high, high), gl.Vertex2f(x + half, y + half);
  gl.TexCoord2f(low, high), gl.Vertex2f(x - half, y + half);
  gl.End();
}

void ground(Gl gl, float repeats) {
  const float end = 12 * repeats;
  gl.Begin(GL_QUADS);
  gl.Normal3f(0, 1, 0);
  gl.TexCoord2f(0, 0), gl.Vertex3f(-6, -0.6f, 3);
  gl.TexCoord2f(end, 0), gl.Vertex3f(6, -0.6f, 3);
  gl.TexCoord2f(end, end), gl.Vertex3f(6, -0.6f, -9);
  gl.TexCoord2f(0, end), gl.Vertex3f(-6, -0.6f, -9);
  gl.End();
}

}  // namespace gluray::scenes
