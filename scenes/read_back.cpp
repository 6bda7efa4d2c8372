// Answers from OpenGL in mid-frame: selection, feedback, pixels, depth, copies. What was answered is drawn.
#include "scenes/families.h"
#include "scenes/stage.h"

#include <algorithm>
#include <vector>

namespace gluray::scenes {
namespace {

/// Bars along the lower edge, one for each value in [0, 1].
void bars(Gl gl, int width, int height, const std::vector<float>& values) {
  gl.PushAttrib(GL_ENABLE_BIT);
  gl.Disable(GL_LIGHTING);
  gl.Disable(GL_DEPTH_TEST);
  flatCamera(gl, width, height);
  for (size_t i = 0; i < values.size(); ++i) {
    const float x = -1.2f + 0.12f * static_cast<float>(i);
    gl.Color3f(1, values[i], 0);
    gl.Rectf(x, -0.95f, x + 0.1f, -0.95f + 0.4f * values[i]);
  }
  gl.PopAttrib();
}

void balls(Gl gl, const Model& ball) {
  for (GLuint i = 0; i < 5; ++i) {
    gl.LoadName(i + 1);  // ignored outside selection
    paint(gl, 0.2f * static_cast<float>(i), 0.8f, 0.5f);
    sendAt(gl, ball, -1.6f + 0.8f * static_cast<float>(i), 0.3f, 0, 0.4f);
  }
}

/// The names hit in the middle of the window, and their depths, become bars.
void selection(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height, 5);
  keyLight(gl);
  gl.Enable(GL_NORMALIZE);
  const Model ball = sphere(12, 18);
  balls(gl, ball);
  GLuint buffer[64] = {};
  gl.SelectBuffer(64, buffer);
  gl.RenderMode(GL_SELECT);
  gl.InitNames();
  gl.PushName(0);
  gl.MatrixMode(GL_PROJECTION);
  gl.PushMatrix();
  GLdouble projection[16];
  gl.GetDoublev(GL_PROJECTION_MATRIX, projection);
  gl.LoadIdentity();
  gl.Scalef(4, 4, 1);
  gl.MultMatrixd(projection);
  gl.MatrixMode(GL_MODELVIEW);
  balls(gl, ball);
  gl.MatrixMode(GL_PROJECTION);
  gl.PopMatrix();
  gl.MatrixMode(GL_MODELVIEW);
  const GLint hits = gl.RenderMode(GL_RENDER);
  std::vector<float> values{static_cast<float>(hits) / 8.0f};
  for (GLint i = 0; i < hits && i < 8; ++i) {
    values.push_back(static_cast<float>(buffer[i * 4 + 1]) / 4294967295.0f);  // nearest depth
    values.push_back(static_cast<float>(buffer[i * 4 + 3]) / 8.0f);           // name
  }
  bars(gl, width, height, values);
}

void feedback(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height, 5);
  keyLight(gl);
  gl.Enable(GL_NORMALIZE);
  const Model ball = sphere(6, 8);
  balls(gl, ball);
  std::vector<GLfloat> buffer(20000);
  gl.FeedbackBuffer(static_cast<GLsizei>(buffer.size()), GL_3D_COLOR, buffer.data());
  gl.RenderMode(GL_FEEDBACK);
  gl.PassThrough(42);
  send(gl, ball);
  const GLint count = gl.RenderMode(GL_RENDER);
  std::vector<float> values{static_cast<float>(count % 1000) / 1000.0f};
  for (GLint i = 0; i < std::min(count, 20); ++i)
    values.push_back(std::clamp(buffer[static_cast<size_t>(i)] / static_cast<float>(width), 0.0f, 1.0f));
  bars(gl, width, height, values);
}

/// Depth is read back in mid-frame, and things are put where it says: what a pivot under the cursor does.
void depthInMidFrame(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.7f, 0.5f, 0.8f);
  send(gl, torus(0.9f, 0.4f, 50, 24));
  gl.MatrixMode(GL_PROJECTION), gl.PushMatrix(), gl.LoadIdentity();
  gl.MatrixMode(GL_MODELVIEW), gl.PushMatrix(), gl.LoadIdentity();
  gl.Disable(GL_LIGHTING);
  const float half = 0.04f;
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 5; ++k) {
      const int px = width * (2 * i + 1) / 12, py = height * (2 * k + 1) / 10;
      GLfloat depth = 0;
      gl.ReadPixels(px, py, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
      const float x = 2 * static_cast<float>(px) / static_cast<float>(width) - 1;
      const float y = 2 * static_cast<float>(py) / static_cast<float>(height) - 1;
      gl.Color3f(depth < 1 ? 1.0f : 0.0f, 0.8f, 0.2f);
      gl.Begin(GL_QUADS);
      const float z = std::min(2 * depth - 1, 0.999f) - 0.01f;
      gl.Vertex3f(x - half, y - half, z), gl.Vertex3f(x + half, y - half, z);
      gl.Vertex3f(x + half, y + half, z), gl.Vertex3f(x - half, y + half, z);
      gl.End();
    }
  gl.MatrixMode(GL_PROJECTION), gl.PopMatrix();
  gl.MatrixMode(GL_MODELVIEW), gl.PopMatrix();
}

/// The image so far becomes a texture of the rest of it.
void copyTexture(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.3f, 0.7f, 0.9f);
  send(gl, torus(0.9f, 0.4f, 50, 24));
  gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, width, height, 0);
  for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  gl.Enable(GL_TEXTURE_2D);
  gl.Disable(GL_LIGHTING);
  gl.Color3f(1, 1, 1);
  flatCamera(gl, width, height);
  gl.Translatef(0, 0, 9);
  gl.Begin(GL_QUADS);
  gl.TexCoord2f(0, 0), gl.Vertex2f(-0.3f, -0.3f);
  gl.TexCoord2f(1, 0), gl.Vertex2f(0.3f, -0.3f);
  gl.TexCoord2f(1, 1), gl.Vertex2f(0.3f, 0.3f);
  gl.TexCoord2f(0, 1), gl.Vertex2f(-0.3f, 0.3f);
  gl.End();
}

/// glReadPixels, glDrawPixels with zoom, glCopyPixels.
void pixelCopies(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.9f, 0.6f, 0.3f);
  send(gl, sphere(24, 36));
  const int w = width / 4, h = height / 4;
  std::vector<GLubyte> pixels(static_cast<size_t>(w * h * 4));
  gl.ReadPixels(width / 2 - w / 2, height / 2 - h / 2, w, h, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  gl.Disable(GL_LIGHTING);
  gl.Disable(GL_DEPTH_TEST);
  gl.WindowPos2i(w, 5);
  gl.PixelZoom(-1, 1);
  gl.DrawPixels(w, h, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  gl.PixelZoom(1, 1);
  gl.WindowPos2i(width - w - 4, 5);
  gl.CopyPixels(width / 2 - w / 2, height / 2, w, h, GL_COLOR);
}

constexpr Scene kReadBackScenes[] = {
    {"selection", selection},      {"feedback", feedback},        {"depth-in-mid-frame", depthInMidFrame},
    {"copy-texture", copyTexture}, {"pixel-copies", pixelCopies},
};

}  // namespace

std::span<const Scene> readBackScenes() { return kReadBackScenes; }

}  // namespace gluray::scenes
