// The n-th allocation of GLuRay fails, for every n: the program's image must stay the real OpenGL's. Only
// allocations by this program's own code fail (judged by the caller's address), not OpenGL's or Embree's.
#include "tests/anomaly/image_by_programs.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

extern "C" char __executable_start, etext;  // from the linker: begin and end of our code

namespace {

std::atomic<long> g_countdown{-1};  // our allocations until one fails; negative: none fails
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

using namespace anomaly;
using Gl = const gl::RealGl&;

TEST(Anomaly, EveryAllocationMayFailOnce) {
  const DrawnImage expected = expectedImage();
  long n = 0;
  for (;; ++n) {
    TracedContext context({kSize, kSize});
    Gl gl = context.gl();
    g_failed = false;
    g_countdown = n;
    drawAll(gl);
    g_countdown = -1;
    if (!g_failed) break;  // fewer than n allocations: each has failed once
    EXPECT_EQ(wrongPixels(expected, context.read()), 0) << "pixels, when allocation " << n << " failed";
  }
  EXPECT_GT(n, 50) << "allocations of ours in the whole image";
}

TEST(Anomaly, AnyAllocationMayFailWhileShaderProgramsDraw) {
  const ContextWish wish{kSize, kSize, true, 3, 2};
  DrawnImage expected;
  {
    const auto real = OsmesaContext::create(wish);
    drawByPrograms(real->real());
    expected = readImage(real->real(), kSize, kSize);
  }
  // Recognising programs allocates thousands of times, in the same few places.
  constexpr long kEach = 500, kStep = 13;
  long n = 0;
  for (;; n += n < kEach ? 1 : kStep) {
    TracedContext context(wish, TracedContext::vertexShading(), nullptr, nullptr, nullptr);
    Gl gl = context.gl();
    g_failed = false;
    g_countdown = n;
    drawByPrograms(gl);
    g_countdown = -1;
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR)) << "when allocation " << n << " failed";
    EXPECT_EQ(wrongPixels(expected, context.read()), 0) << "pixels, when allocation " << n << " failed";
    if (g_failed) continue;
    EXPECT_EQ(context.context().counts.statistics.drawsTraced, 5u);
    break;  // fewer than n allocations
  }
  EXPECT_GT(n, 50) << "allocations of ours in the whole image";
}

}  // namespace
}  // namespace gluray::test
