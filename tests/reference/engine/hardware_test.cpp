// Above an OpenGL in hardware, the real OpenGL draws scenes of any size. A stand-in answers at once, renders
// nothing, and has the name of a graphics card.
#include "gl/context/context.h"
#include "gl/real/extensions.h"
#include "intercept/tracing/make_presenter.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace gluray::test {
namespace {

const GLubyte* APIENTRY nameOfHardware(GLenum) {
  return reinterpret_cast<const GLubyte*>("NVIDIA GeForce RTX 4090/PCIe/SSE2");
}
void APIENTRY drawNothing(GLenum, GLint, GLsizei) {}

/// A context over the stand-in.
class StandIn {
 public:
  explicit StandIn(const Settings& settings)
      : real_(below_->real()), presenter_(intercept::makePresenter(settings)) {
    real_.DrawArrays = drawNothing;
    gl::ContextInfo info;
    info.version = gl::versionOf(real_);
    info.doubleBuffered = false;
    real_.GetString = nameOfHardware;
    info.software = gl::rendersInSoftware(real_);
    real_.GetString = below_->real().GetString;
    info.settings = settings;
    info.families = familiesOfTests();
    info.drawableSize = [] { return glm::ivec2(kSide); };
    context_ = gl::Context::create(real_, std::make_shared<gl::ShareGroup>(), info, *presenter_);
    context_->makeCurrent();
  }
  ~StandIn() { context_->loseCurrent(); }
  StandIn(const StandIn&) = delete;
  StandIn& operator=(const StandIn&) = delete;

  /// Draws frames of 400,000 triangles.
  gl::Statistics draw(int frames) {
    const gl::RealGl& gl = TracedContext::stubs();
    std::vector<float> positions;
    constexpr GLsizei kTriangles = 400000;
    for (GLsizei i = 0; i < kTriangles; ++i) {
      const float x = static_cast<float>(i % 1000) / 500 - 1, y = static_cast<float>(i / 1000) / 200 - 1;
      // Not in one plane of the view: drawing order decides there.
      positions.insert(positions.end(), {x, y, 0.3f * x, x + 0.002f, y, 0, x, y + 0.005f, 0.1f});
    }
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(positions.size() * sizeof(float)),
                  positions.data(), GL_STATIC_DRAW);
    gl.VertexPointer(3, GL_FLOAT, 0, nullptr), gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.Enable(GL_DEPTH_TEST);
    for (int i = 0; i < frames; ++i) {
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      gl.Rotatef(1, 0, 0, 1);
      gl.DrawArrays(GL_TRIANGLES, 0, 3 * kTriangles);
      gl.Finish();
    }
    return context_->counts.statistics;
  }

 private:
  static constexpr int kSide = 128;
  std::shared_ptr<OsmesaContext> below_ = OsmesaContext::create({kSide, kSide});
  gl::RealGl real_;
  std::unique_ptr<gl::Presenter> presenter_;
  std::shared_ptr<gl::Context> context_;
};

TEST(Hardware, DrawsLargeScenesItself) {
  Settings settings;
  settings.engine = Engine::automatic;
  const gl::Statistics s = StandIn(settings).draw(60);
  EXPECT_EQ(s.drawsTraced, 0u);
  EXPECT_GT(s.framesPassedThrough, 50u);
}

TEST(Hardware, LeavesFramesWithLightToTheRayTracer) {
  Settings settings;
  settings.engine = Engine::automatic;
  settings.ao.enabled = true;
  const gl::Statistics s = StandIn(settings).draw(3);
  EXPECT_EQ(s.drawsTraced, 3u);
  for (int i = 0; i < gl::kReasonCount; ++i)
    EXPECT_EQ(s.rasterisedBecause[static_cast<size_t>(i)], 0u) << describe(static_cast<gl::Reason>(i));
}

TEST(Hardware, IsWhatHasNoNameOfASoftwareRenderer) {
  for (const char* const name :
       {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Software Rasterizer", "Gallium 0.4 on SWR"})
    EXPECT_TRUE(gl::isSoftwareRenderer(name)) << name;
  for (const char* const name :
       {"Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "AMD Radeon RX 7900 XTX (radeonsi, navi31)",
        "NVIDIA GeForce RTX 4090/PCIe/SSE2", "virgl", "zink Vulkan 1.3 (NVIDIA)", ""})
    EXPECT_FALSE(gl::isSoftwareRenderer(name)) << name;
}

}  // namespace
}  // namespace gluray::test
