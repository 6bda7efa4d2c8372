// Memory fails at every n-th allocation of ours: the program's picture stays what the real OpenGL would have
// drawn. Allocations are told apart by who asks: only those made from this program's own code fail, never
// OpenGL's or Embree's.
#include "tests/reference/traced_context.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

extern "C" char __executable_start, etext;  // by the linker: where our code begins and ends

namespace {

std::atomic<long> g_countdown{-1};  // allocations of ours until one fails; negative: none does
std::atomic<bool> g_failed{false};

bool isOurs(const void* caller) { return caller >= &__executable_start && caller < &etext; }

void* allocate(std::size_t size, const void* caller) {
  if (isOurs(caller) && g_countdown >= 0 && g_countdown-- == 0) {
    g_failed = true;
    return nullptr;
  }
  return std::malloc(size ? size : 1);
}

}  // namespace

void* operator new(std::size_t size) {
  if (void* p = allocate(size, __builtin_return_address(0))) return p;
  throw std::bad_alloc();
}
void* operator new[](std::size_t size) {
  if (void* p = allocate(size, __builtin_return_address(0))) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;
constexpr int kSize = 32;

// Static data and no containers: the program under test allocates nothing itself.
constexpr GLfloat kPositions[] = {-0.9f, -0.9f, 0.1f, 0.1f, -0.9f, 0.2f,
                                  -0.4f, 0.9f,  0.4f, 0.9f, 0.5f,  -0.2f};
constexpr GLubyte kColors[] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
constexpr GLuint kIndices[] = {0, 1, 2, 2, 1, 3};

void immediate(Gl gl) {
  gl.Begin(GL_TRIANGLES);
  for (const GLuint i : kIndices) gl.Color4ubv(kColors + 4 * i), gl.Vertex3fv(kPositions + 3 * i);
  gl.End();
}

void drawAll(Gl gl) {
  gl.Viewport(0, 0, kSize, kSize), gl.Enable(GL_DEPTH_TEST), gl.ClearColor(0.1f, 0.2f, 0.3f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.ShadeModel(GL_FLAT);
  immediate(gl);
  gl.NewList(1, GL_COMPILE), gl.Scalef(0.5f, 0.5f, 0.5f), immediate(gl), gl.EndList();
  gl.PushMatrix(), gl.Translatef(0.3f, 0.3f, -0.5f), gl.CallList(1), gl.PopMatrix();
  gl.NewList(2, GL_COMPILE_AND_EXECUTE), gl.Translatef(-0.2f, 0, -0.1f), immediate(gl), gl.EndList();
  gl.EnableClientState(GL_VERTEX_ARRAY), gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, kPositions), gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, kColors);
  gl.Translatef(0.1f, -0.3f, -0.2f), gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, kIndices);
  gl.Begin(GL_LINES), gl.Vertex3f(-1, -1, -0.9f), gl.Vertex3f(1, 1, -0.9f), gl.End();
  gl.Finish();
}

/// Whether a colour stands at (x, y) of `picture` or beside it: edges of traced and rasterised triangles may
/// differ by a pixel.
bool isNear(const Picture& picture, int x, int y, uint32_t color) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const int px = x + dx, py = y + dy;
      if (px < 0 || py < 0 || px >= kSize || py >= kSize) continue;
      if (picture.colors[static_cast<size_t>(py * kSize + px)] == color) return true;
    }
  return false;
}

TEST(Anomaly, EveryAllocationMayFailOnce) {
  const auto real = OsmesaContext::create({kSize, kSize});
  drawAll(real->real());
  const Picture expected = readPicture(real->real(), kSize, kSize);
  long n = 0;
  for (;; ++n) {
    TracedContext context({kSize, kSize});
    Gl gl = context.gl();
    g_failed = false;
    g_countdown = n;
    drawAll(gl);
    g_countdown = -1;
    if (!g_failed) break;  // fewer than n allocations: all have had their turn
    const Picture got = context.read();
    int wrong = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        wrong += !isNear(expected, x, y, got.colors[static_cast<size_t>(y * kSize + x)]);
    EXPECT_EQ(wrong, 0) << "pixels, when allocation " << n << " failed";
  }
  EXPECT_GT(n, 50) << "allocations of ours in the whole picture";
}

}  // namespace
}  // namespace gluray::test
