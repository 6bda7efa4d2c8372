// A program that makes and deletes lists, buffers, textures, framebuffers, client arrays and
// contexts; each frame has new geometry, traced at a small size. The memory in use must not grow. Resident
// memory is printed only: it follows the pages of freed blocks that the heap touches again, which depends on
// the threads' order.
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
constexpr double kMaxHeapGrowth = 0.002;      ///< of the bytes that blocks of the heap hold
constexpr double kMaxMappedGrowth = 4 << 20;  ///< bytes that are mapped past the heap

/// What the process holds, in bytes.
struct Memory {
  double heap = 0;    ///< in blocks of the heap that are not freed
  double mapped = 0;  ///< address space beside the heap's: structures' own mappings, stacks, libraries
  double resident = 0;
};

Memory memoryNow() {
  long pages = 0, resident = 0;
  if (FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2) pages = resident = 0;
    std::fclose(file);
  }
  const auto pageBytes = static_cast<double>(sysconf(_SC_PAGESIZE));
  const struct mallinfo2 heap = mallinfo2();
  return {static_cast<double>(heap.uordblks + heap.hblkhd),
          static_cast<double>(pages) * pageBytes - static_cast<double>(heap.arena + heap.hblkhd),
          static_cast<double>(resident) * pageBytes};
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

/// The largest value of a part of the run. Caches fill and are emptied every 2,000 frames or so: a part holds
/// several such rounds.
double largest(const std::vector<Memory>& values, size_t from, size_t to, double Memory::*part) {
  double result = 0;
  for (size_t i = from; i < to; ++i) result = std::max(result, values[i].*part);
  return result;
}

int run(int frames, const std::function<void(int, int)>& draw) {
  constexpr size_t kSteps = 100, kWarm = 20, kHalf = 60;
  std::vector<Memory> memory;
  for (size_t step = 0; step < kSteps; ++step) {
    const auto first = [&](size_t s) { return static_cast<int>(static_cast<size_t>(frames) * s / kSteps); };
    draw(first(step), first(step + 1));
    memory.push_back(memoryNow());
  }
  const double heap = largest(memory, kWarm, kHalf, &Memory::heap);
  const double heapGrowth = largest(memory, kHalf, kSteps, &Memory::heap) / heap - 1;
  const double mappedGrowth =
      largest(memory, kHalf, kSteps, &Memory::mapped) - largest(memory, kWarm, kHalf, &Memory::mapped);
  std::printf(
      "leak: %d frames, %.2f MB of the heap in use, growth %+.2f %%; mapped beside it %+.2f MB; resident "
      "%.2f MB\n",
      frames, heap / 1e6, 100 * heapGrowth, mappedGrowth / 1e6, memory.back().resident / 1e6);
  if (heapGrowth < kMaxHeapGrowth && mappedGrowth < kMaxMappedGrowth) return 0;
  for (size_t step = 0; step < kSteps; step += 2)
    std::printf("  after %3zu %%: heap %.2f MB, mapped %.2f MB, resident %.2f MB\n", step + 1,
                memory[step].heap / 1e6, memory[step].mapped / 1e6, memory[step].resident / 1e6);
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
