// Framebuffer objects of textures into which images may be sent, and what is drawn into them.
#pragma once
#include "gl/real/real.h"

#include <GL/glext.h>

#include <cmath>

namespace gluray::test::texture_upload {

using Gl = const gl::RealGl&;
constexpr int kUploadSize = 64;  // pixels of the textures, and of the window

struct Canvas {
  GLuint framebuffer = 0, color = 0, depth = 0;
};

inline GLuint uploadTarget(Gl gl, GLenum internalFormat, GLenum format, GLenum type) {
  GLuint name = 0;
  gl.GenTextures(1, &name), gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), kUploadSize, kUploadSize, 0, format,
                type, nullptr);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return name;
}

/// Makes and binds the framebuffer of the two textures.
inline void attach(Gl gl, Canvas& c) {
  gl.GenFramebuffers(1, &c.framebuffer), gl.BindFramebuffer(GL_FRAMEBUFFER, c.framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, c.color, 0);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, c.depth, 0);
}

inline Canvas makeCanvas(Gl gl) {
  Canvas c;
  c.color = uploadTarget(gl, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
  c.depth = uploadTarget(gl, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
  attach(gl, c);
  return c;
}

inline void clear(Gl gl) {
  gl.ClearColor(0.1f, 0.33f, 0.77f, 0.25f);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// A wavy sheet, seen from above, with gaps around it.
inline void flatSheet(Gl gl, float lift = 0) {
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 20; ++k) {
      const auto at = [&](int x, int y) {
        const float u = 0.08f * static_cast<float>(x) - 0.8f, v = 0.08f * static_cast<float>(y) - 0.8f;
        gl.Color4f(0.5f + 0.5f * u, 0.5f + 0.5f * v, 0.3f, 1);
        gl.Vertex3f(u, v, 0.4f * std::sin(4 * u + 3 * v) + lift);
      };
      at(i, k), at(i + 1, k), at(i + 1, k + 1);
      at(i, k), at(i + 1, k + 1), at(i, k + 1);
    }
  gl.End();
}

inline void crossingLine(Gl gl) {
  gl.Begin(GL_LINES);
  gl.Color3f(1, 1, 1), gl.Vertex3f(-1, -0.9f, 0.9f), gl.Vertex3f(1, 0.8f, -0.9f);
  gl.End();
}

}  // namespace gluray::test::texture_upload
