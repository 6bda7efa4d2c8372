// A program that makes and deletes lists, buffers, textures, framebuffers, client arrays and
// contexts; each frame has new geometry, traced at a small size. Resident memory must not grow.
//   gluray_leak FRAMES [plain]     plain: the real OpenGL alone, to measure its own leaks
#include "tests/support/traced_context.h"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;
constexpr int kSize = 32, kTriangles = 60;
constexpr double kMaxGrowth = 0.01;

/// Resident memory of the process, bytes.
double residentBytes() {
  long pages = 0, resident = 0;
  if (FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2) resident = 0;
    std::fclose(file);
  }
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// Triangles that no other frame has.
std::vector<GLfloat> positions(int frame) {
  std::vector<GLfloat> values;
  for (int i = 0; i < 3 * kTriangles; ++i) {
    const auto t = static_cast<float>(i + frame * 0.37);
    values.insert(values.end(), {0.9f * std::cos(1.7f * t), 0.9f * std::sin(2.3f * t), 0.8f * std::cos(t)});
  }
  return values;
}

void immediate(Gl gl, const std::vector<GLfloat>& p) {
  gl.Begin(GL_TRIANGLES);
  for (size_t i = 0; i < p.size(); i += 3) gl.Color3f(p[i], p[i + 1], 1), gl.Vertex3fv(&p[i]);
  gl.End();
}

void lists(Gl gl, const std::vector<GLfloat>& p) {
  const GLuint first = gl.GenLists(2);
  gl.NewList(first, GL_COMPILE), immediate(gl, p), gl.EndList();
  gl.NewList(first + 1, GL_COMPILE);
  gl.PushMatrix(), gl.Translatef(0.1f, 0, 0.1f), gl.CallList(first), gl.PopMatrix();
  gl.Begin(GL_LINES), gl.Vertex3fv(&p[0]), gl.Vertex3fv(&p[3]), gl.End();
  gl.EndList();
  gl.CallList(first + 1);
  gl.DeleteLists(first, 2);
}

void arrays(Gl gl, const std::vector<GLfloat>& p) {
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, p.data());
  gl.DrawArrays(GL_TRIANGLES, 0, 3 * kTriangles);
  GLuint buffers[2];
  gl.GenBuffers(2, buffers);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(p.size() * 4), p.data(), GL_STATIC_DRAW);
  GLushort indices[3 * kTriangles];
  for (int i = 0; i < 3 * kTriangles; ++i) indices[i] = static_cast<GLushort>(3 * kTriangles - 1 - i);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
  gl.DrawElements(GL_TRIANGLES, 3 * kTriangles, GL_UNSIGNED_SHORT, nullptr);
  gl.DisableClientState(GL_VERTEX_ARRAY);
  gl.DeleteBuffers(2, buffers);
}

void textures(Gl gl, const std::vector<GLfloat>& p) {
  GLuint names[2];
  gl.GenTextures(2, names);
  gl.BindTexture(GL_TEXTURE_2D, names[0]);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, p.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D), immediate(gl, p), gl.Disable(GL_TEXTURE_2D);
  gl.BindTexture(GL_TEXTURE_2D, names[1]);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, names[1], 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.DeleteFramebuffers(1, &framebuffer);
  gl.DeleteTextures(2, names);
}

void frame(Gl gl, int number) {
  const std::vector<GLfloat> p = positions(number);
  gl.Viewport(0, 0, kSize, kSize), gl.Enable(GL_DEPTH_TEST);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  immediate(gl, p), lists(gl, p), arrays(gl, p), textures(gl, p);
  uint32_t pixel = 0;
  gl.ReadPixels(kSize / 2, kSize / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  gl.Finish();
}

/// Every hundredth frame is drawn by a context of its own.
constexpr int kContextEvery = 100;

void plainFrames(int from, int to) {
  static const auto main = OsmesaContext::create({kSize, kSize});
  for (int i = from; i < to; ++i) {
    if (i % kContextEvery == 0) {
      const auto other = OsmesaContext::create({kSize, kSize}, main.get());
      frame(other->real(), i);
    }
    main->makeCurrent();
    frame(main->real(), i);
  }
}

void tracedFrames(int from, int to) {
  static TracedContext main({kSize, kSize});
  for (int i = from; i < to; ++i) {
    if (i % kContextEvery == 0) {
      TracedContext other({kSize, kSize}, TracedContext::vertexShading(), nullptr, &main);
      other.makeCurrent();
      frame(other.gl(), i);
    }
    main.makeCurrent();
    frame(main.gl(), i);
    if (main.context().counts.statistics.trianglesTraced == 0)
      std::printf("leak: nothing is traced\n"), std::exit(1);
  }
}

/// Median of a tenth of the run's measurements: single ones vary, because the heap returns memory late.
double middle(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

int run(int frames, const std::function<void(int, int)>& draw) {
  constexpr int kSteps = 100;
  std::vector<double> resident;
  for (int step = 0; step < kSteps; ++step) {
    draw(frames * step / kSteps, frames * (step + 1) / kSteps);
    resident.push_back(residentBytes());
  }
  const double warm = middle({resident.begin() + 40, resident.begin() + 50});
  const double last = middle({resident.end() - 10, resident.end()});
  const double growth = last / warm - 1;
  std::printf("leak: %d frames, %.2f MB after warming up, %.2f MB at the end, growth %+.2f %%\n", frames,
              warm / 1e6, last / 1e6, 100 * growth);
  if (growth < kMaxGrowth) return 0;
  for (int step = 0; step < kSteps; step += 5)
    std::printf("  frame %7d: %.2f MB\n", frames * step / kSteps, resident[static_cast<size_t>(step)] / 1e6);
  return 1;
}

}  // namespace
}  // namespace gluray::test

int main(int argc, char** argv) {
  using namespace gluray::test;
  const int frames = argc > 1 ? std::atoi(argv[1]) : 0;
  if (frames < 1000) return std::fprintf(stderr, "usage: gluray_leak FRAMES [plain], at least 1000\n"), 2;
  setenv("GALLIUM_DRIVER", "softpipe", 0);  // llvmpipe's compiled shaders would change the memory in use
  const bool plain = argc > 2 && std::strcmp(argv[2], "plain") == 0;
  return run(frames, plain ? plainFrames : tracedFrames);
}
