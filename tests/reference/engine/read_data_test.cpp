// Programs draw the numbers of objects as colours and read them: no setting may change these.
#include "tests/reference/engine/quad.h"
#include "tests/reference/framebuffer.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace gluray::test {
namespace {

constexpr int kNumbersSize = 64;

struct NumbersDrawn {
  bool dither = false, lit = false, ownFramebuffer = false, depthOnly = false;
  int samples = 0;  // of ownFramebuffer
};

void drawNumbers(const gl::RealGl& gl, const NumbersDrawn& how) {
  if (how.ownFramebuffer)
    bindNewFramebuffer(gl, {kNumbersSize, kNumbersSize}, GL_RGBA8, GL_DEPTH_COMPONENT24, how.samples);
  (how.dither ? gl.Enable : gl.Disable)(GL_DITHER);
  gl.Enable(GL_DEPTH_TEST);
  gl.ClearColor(0, 0, 0, 0), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (how.lit) gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0), gl.Enable(GL_COLOR_MATERIAL);
  GLubyte number = 0;
  const auto next = [&] { number += 37, gl.Color4ub(number, static_cast<GLubyte>(number * 3), 7, 255); };
  next(), quad(gl, {-1, -1, 0.5f}, {1, -1, 0.51f}, {1, 1, 0.51f}, {-1, 1, 0.5f});
  next(), quad(gl, {0.5f, -1, 0.51f}, {0.6f, -1, -0.9f}, {0.6f, 1, -0.9f}, {0.5f, 1, 0.51f});
  for (int i = 0; i < 8; ++i) {
    const float x = -0.9f + 0.15f * static_cast<float>(i);
    next(), quad(gl, {x, -0.3f, 0.2f}, {x + 0.1f, -0.35f, 0.2f}, {x + 0.12f, 0.4f, 0.1f}, {x, 0.3f, 0.2f});
  }
}

std::vector<uint32_t> numbersRead(const Settings& settings, const NumbersDrawn& how) {
  TracedContext context({kNumbersSize, kNumbersSize}, settings);
  context.setDoubleBuffered(true);
  const gl::RealGl& gl = context.gl();
  drawNumbers(gl, how);
  std::vector<uint32_t> pixels(kNumbersSize * kNumbersSize);
  if (how.depthOnly)
    gl.ReadPixels(0, 0, kNumbersSize, kNumbersSize, GL_DEPTH_COMPONENT, GL_FLOAT, pixels.data());
  else
    gl.ReadPixels(0, 0, kNumbersSize, kNumbersSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  EXPECT_GT(context.context().counts.statistics.drawsTraced, 0u);
  return pixels;
}

std::vector<Settings> settingsThatChangeImages() {
  std::vector<Settings> all(5, TracedContext::tracing());
  all[0].ao.enabled = true;
  all[1].spp = 4;
  all[2].exposure = 1;
  all[3].integrator = LightIntegrator::path;
  all[4].shadows.enabled = true, all[4].ao.enabled = true, all[4].spp = 8;
  return all;
}

TEST(ReadData, IsWhatTheProgramDrewWhateverTheSettings) {
  for (const Settings& settings : settingsThatChangeImages())
    for (const bool ownFramebuffer : {false, true})
      for (const bool depthOnly : {false, true}) {
        const NumbersDrawn how{.ownFramebuffer = ownFramebuffer, .depthOnly = depthOnly};
        EXPECT_EQ(numbersRead(settings, how), numbersRead(TracedContext::tracing(), how));
      }
}

TEST(ReadData, UnderAScissorIsWhatTheProgramDrew) {
  const auto pixel = [](const Settings& settings) {
    TracedContext context({kNumbersSize, kNumbersSize}, settings);
    context.setDoubleBuffered(true);
    const gl::RealGl& gl = context.gl();
    gl.Enable(GL_SCISSOR_TEST), gl.Scissor(34, 30, 1, 1);
    drawNumbers(gl, {});
    uint32_t read = 0;
    gl.ReadPixels(34, 30, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &read);
    return read;
  };
  const uint32_t plain = pixel(TracedContext::tracing());
  for (const Settings& settings : settingsThatChangeImages()) EXPECT_EQ(pixel(settings), plain);
}

TEST(ReadData, ImagesHaveLight) {
  Settings lit = TracedContext::tracing();
  lit.ao.enabled = true;
  for (const NumbersDrawn how : {NumbersDrawn{.dither = true}, NumbersDrawn{.lit = true}})
    EXPECT_NE(numbersRead(lit, how), numbersRead(TracedContext::tracing(), how));
}

}  // namespace
}  // namespace gluray::test
