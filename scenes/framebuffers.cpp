// Drawing into the front buffer, framebuffer objects, multisampled ones.
#include "scenes/families.h"
#include "scenes/stage.h"

namespace gluray::scenes {
namespace {

void model(Gl gl, int width, int height) {
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.6f, 0.8f, 0.9f);
  gl.Rotatef(-40, 1, 0, 0);
  send(gl, torus(0.9f, 0.35f, 40, 20));
}

/// Draws to the front, selects another buffer, and finishes without a swap.
void frontBuffer(Gl gl, int width, int height) {
  gl.DrawBuffer(GL_FRONT);
  begin(gl, width, height);
  model(gl, width, height);
  gl.DrawBuffer(GL_NONE);
  gl.Flush();
  gl.ReadBuffer(GL_FRONT);
}

struct Framebuffer {
  GLuint name = 0, color = 0, depth = 0;
};

/// With textures where `samples` is 0, otherwise with multisampled renderbuffers.
Framebuffer makeFramebuffer(Gl gl, int width, int height, int samples, GLenum format = GL_RGBA8) {
  Framebuffer f;
  gl.GenFramebuffers(1, &f.name);
  gl.BindFramebuffer(GL_FRAMEBUFFER, f.name);
  if (samples == 0) {
    gl.GenTextures(1, &f.color);
    gl.BindTexture(GL_TEXTURE_2D, f.color);
    gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  nullptr);
    for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, f.color, 0);
  } else {
    gl.GenRenderbuffers(1, &f.color);
    gl.BindRenderbuffer(GL_RENDERBUFFER, f.color);
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, f.color);
  }
  gl.GenRenderbuffers(1, &f.depth);
  gl.BindRenderbuffer(GL_RENDERBUFFER, f.depth);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, f.depth);
  return f;
}

/// Ten bits a channel and two of alpha, as some windows have.
void tenBits(Gl gl, int width, int height) {
  makeFramebuffer(gl, width, height, 0, GL_RGB10_A2);
  begin(gl, width, height);
  model(gl, width, height);
}

/// A scene in a texture, then that texture on a sheet in the window.
void renderToTexture(Gl gl, int width, int height) {
  const Framebuffer f = makeFramebuffer(gl, 128, 128, 0);
  begin(gl, 128, 128, {0.5f, 0.2f, 0.2f, 1});
  model(gl, 128, 128);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  begin(gl, width, height);
  gl.Disable(GL_LIGHTING);
  gl.Enable(GL_TEXTURE_2D);
  gl.BindTexture(GL_TEXTURE_2D, f.color);
  gl.Color3f(1, 1, 1);
  camera(gl, width, height, 3);
  gl.Rotatef(20, 0, 1, 0);
  send(gl, sheet(20), kTexcoords);
}

/// An image of the window's size in a framebuffer object, copied over whole.
void blitFramebuffer(Gl gl, int width, int height) {
  makeFramebuffer(gl, width, height, 0);
  begin(gl, width, height);
  model(gl, width, height);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

/// Four samples a pixel, resolved: edges as smooth as the real OpenGL's.
void multisampled(Gl gl, int width, int height) {
  makeFramebuffer(gl, width, height, 4);
  begin(gl, width, height);
  model(gl, width, height);
  gl.Disable(GL_LIGHTING);
  gl.Color3f(1, 1, 0);
  gl.Begin(GL_LINES);  // rasterised among the samples
  for (int i = 0; i < 10; ++i)
    gl.Vertex3f(-1, -0.9f + 0.2f * static_cast<float>(i), 0),
        gl.Vertex3f(1, 0.9f - 0.2f * static_cast<float>(i), 0);
  gl.End();
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

constexpr Tolerance kSamples{2, 0.002, 1e-5f, "outlines fall on either side of a sample"};

constexpr Scene kFramebufferScenes[] = {
    {"front-buffer", frontBuffer},
    {"render-to-texture", renderToTexture},
    {"blit-framebuffer", blitFramebuffer},
    {"ten-bits", tenBits},
    {"multisampled", multisampled, true, kSamples},
};

}  // namespace

std::span<const Scene> framebufferScenes() { return kFramebufferScenes; }

}  // namespace gluray::scenes
