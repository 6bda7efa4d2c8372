// Surfaces that write only some channels: glColorMask, and blending that keeps the framebuffer's alpha.
#include "scenes/stage.h"
#include "tests/reference/framebuffer.h"
#include "tests/support/gl_state.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>

namespace gluray::test {
namespace {

using namespace scenes;

constexpr int kChannelsWidth = 120, kChannelsHeight = 90;
constexpr Color kBackground = {0.4f, 0.6f, 0.2f, 0.5f};

void coloredBall(Gl gl, float x, float z, Color color) {
  paint(gl, color[0], color[1], color[2]);
  material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, color);
  sendAt(gl, sphere(16, 24), x, 0, z, 0.8f);
}

void setStage(Gl gl) {
  begin(gl, kChannelsWidth, kChannelsHeight, kBackground);
  camera(gl, kChannelsWidth, kChannelsHeight);
  keyLight(gl);
}

using Draw = std::function<void(Gl)>;

struct SeenChannels {
  DrawnImage image;
  GlState state;
};

SeenChannels seenBy(Gl gl, const Draw& draw) {
  setStage(gl);
  draw(gl);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
  GlState state = queryState(gl);
  return {readImage(gl, kChannelsWidth, kChannelsHeight), std::move(state)};
}

/// Draws with and without GLuRay and expects equal images, alpha included, and equal state. Returns how
/// many draws were traced.
uint64_t compareBoth(const std::string& name, const Draw& draw) {
  SCOPED_TRACE(name);
  SeenChannels expected;
  {
    const auto real = OsmesaContext::create({kChannelsWidth, kChannelsHeight});
    expected = seenBy(real->real(), draw);
  }
  TracedContext ours({kChannelsWidth, kChannelsHeight});
  const SeenChannels got = seenBy(ours.gl(), draw);
  for (const std::string& line : differences(expected.state, got.state)) ADD_FAILURE() << line;
  const Comparison c = compare(expected.image, got.image, {});
  EXPECT_TRUE(c.accepted) << c.text;
  if (!c.accepted) writeFailure(TEST_OUTPUT "/channels", name, expected.image, got.image);
  return ours.context().counts.statistics.drawsTraced;
}

void expectEqual(const std::string& name, const Draw& draw, uint64_t traced) {
  EXPECT_EQ(compareBoth(name, draw), traced) << name;
}

struct Mask {
  GLboolean red, green, blue, alpha;
};

void setMask(Gl gl, const Mask& m) { gl.ColorMask(m.red, m.green, m.blue, m.alpha); }

TEST(Channels, ThatAreMaskedKeepTheirValues) {
  const Mask masks[] = {{1, 1, 1, 0}, {1, 0, 0, 0}, {0, 1, 1, 1}, {0, 0, 0, 1}, {1, 0, 1, 0}};
  for (const Mask& mask : masks) {
    const std::string name = std::to_string(mask.red) + std::to_string(mask.green) +
                             std::to_string(mask.blue) + std::to_string(mask.alpha);
    const auto draw = [&](Gl gl) {
      setMask(gl, mask);
      coloredBall(gl, -0.3f, 0, {0.9f, 0.3f, 0.2f, 1});
      coloredBall(gl, 0.4f, 0.5f, {0.1f, 0.4f, 0.9f, 1});
    };
    expectEqual(name, draw, 2);
  }
}

TEST(Channels, ThatNobodyWritesLeaveDepthAlone) {
  const auto draw = [](Gl gl) {
    setMask(gl, {0, 0, 0, 0});
    coloredBall(gl, 0, 0, {0.9f, 0.3f, 0.2f, 1});
    setMask(gl, {1, 1, 1, 1});
    coloredBall(gl, 0.4f, -0.5f, {0.1f, 0.4f, 0.9f, 1});
  };
  expectEqual("depth", draw, 1);
}

TEST(Channels, OfTwoEyesMeetInOneImage) {
  const auto draw = [](Gl gl) {
    setMask(gl, {1, 0, 0, 1});
    coloredBall(gl, -0.2f, 0, {0.9f, 0.9f, 0.8f, 1});
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    setMask(gl, {0, 1, 1, 1});
    coloredBall(gl, 0.2f, 0, {0.9f, 0.9f, 0.8f, 1});
  };
  expectEqual("eyes", draw, 2);
}

TEST(Channels, ThatDifferFromDrawToDrawKeepTheirOrder) {
  // Near and red first; then far and all; then near and blue.
  const auto draw = [](Gl gl) {
    setMask(gl, {1, 0, 0, 0});
    coloredBall(gl, -0.3f, 0.6f, {1, 0.9f, 0.8f, 1});
    setMask(gl, {1, 1, 1, 1});
    coloredBall(gl, 0, 0, {0.2f, 0.8f, 0.3f, 1});
    setMask(gl, {0, 0, 1, 0});
    coloredBall(gl, 0.3f, 0.6f, {0.5f, 0.9f, 0.9f, 1});
  };
  expectEqual("order", draw, 3);
}

TEST(Channels, OfRasterisedDrawsKeepTheirOrderToo) {
  const auto rasterised = [](Gl gl, float x, float z, const Mask& mask) {
    setMask(gl, mask);
    gl.Enable(GL_POLYGON_STIPPLE);
    coloredBall(gl, x, z, {0.9f, 0.8f, 0.1f, 1});
    gl.Disable(GL_POLYGON_STIPPLE);
  };
  const auto behind = [&](Gl gl) {
    setMask(gl, {1, 0, 0, 1});
    coloredBall(gl, 0, 0.4f, {1, 0.9f, 0.8f, 1});
    rasterised(gl, 0.3f, -0.3f, {1, 1, 1, 1});
  };
  const auto before = [&](Gl gl) {
    coloredBall(gl, 0, 0, {0.3f, 0.9f, 0.8f, 1});
    rasterised(gl, 0.3f, 0.6f, {0, 0, 1, 0});
  };
  expectEqual("behind", behind, 1);
  expectEqual("before", before, 1);
}

/// Blended so that alpha is kept; the second ball has this one.
void blended(Gl gl, float alpha) {
  gl.Enable(GL_BLEND);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  coloredBall(gl, -0.3f, 0, {0.9f, 0.3f, 0.2f, 1});
  coloredBall(gl, 0.4f, 0.5f, {0.1f, 0.4f, 0.9f, alpha});
}

TEST(Channels, KeepTheirAlphaWhereBlendingKeepsIt) {
  expectEqual(
      "kept alpha", [](Gl gl) { blended(gl, 1); }, 2);
}

TEST(Channels, OfTranslucentSurfacesAreBlended) {
  expectEqual(
      "translucent", [](Gl gl) { blended(gl, 0.5f); }, 2);
}

TEST(Channels, ComeBackWhereTheRealOpenGlDrawsInOurPlace) {
  // The same surface again with another depth function: it is drawn in several passes, by the real OpenGL.
  const auto draw = [](Gl gl) {
    setMask(gl, {1, 1, 0, 0});
    coloredBall(gl, 0, 0, {0.9f, 0.3f, 0.2f, 1});
    gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE), gl.DepthFunc(GL_EQUAL);
    coloredBall(gl, 0, 0, {0.2f, 0.3f, 0.9f, 1});
    gl.Disable(GL_BLEND), gl.DepthFunc(GL_LESS);
  };
  for (const int frames : {1, 2}) {
    const auto several = [&](Gl gl) {
      for (int i = 0; i < frames; ++i) {
        if (i > 0) setMask(gl, {1, 1, 1, 1}), setStage(gl);
        draw(gl);
        gl.Finish();
      }
    };
    compareBoth("passes " + std::to_string(frames), several);
  }
}

TEST(Channels, AreEncodedAsTheFramebufferHasIt) {
  for (const GLenum format : {GL_SRGB8_ALPHA8, GL_RGBA8}) {
    const auto draw = [&](Gl gl) {
      bindNewFramebuffer(gl, {kChannelsWidth, kChannelsHeight}, format, GL_DEPTH_COMPONENT24);
      gl.Enable(GL_FRAMEBUFFER_SRGB);
      setStage(gl);
      coloredBall(gl, -0.3f, 0, {0.9f, 0.3f, 0.2f, 1});
      coloredBall(gl, 0.4f, 0.5f, {0.1f, 0.4f, 0.9f, 1});
    };
    expectEqual(format == GL_RGBA8 ? "linear" : "srgb", draw, 2);
  }
}

TEST(Channels, AreEncodedAsItWasWhenTheyWereDrawn) {
  for (const bool first : {false, true}) {
    const auto draw = [&](Gl gl) {
      bindNewFramebuffer(gl, {kChannelsWidth, kChannelsHeight}, GL_SRGB8_ALPHA8, GL_DEPTH_COMPONENT24);
      setStage(gl);
      const auto encode = [&](bool on) {
        on ? gl.Enable(GL_FRAMEBUFFER_SRGB) : gl.Disable(GL_FRAMEBUFFER_SRGB);
      };
      encode(first);
      coloredBall(gl, -0.3f, 0, {0.9f, 0.3f, 0.2f, 1});
      encode(!first);
      coloredBall(gl, 0.4f, 0.5f, {0.1f, 0.4f, 0.9f, 1});
      encode(first);
    };
    expectEqual(first ? "encoded first" : "encoded second", draw, 2);
  }
}

TEST(Channels, AreEncodedAsThePoppedStateHasIt) {
  for (const GLbitfield group :
       {GLbitfield{GL_ENABLE_BIT}, GLbitfield{GL_COLOR_BUFFER_BIT}, GLbitfield{GL_ALL_ATTRIB_BITS}}) {
    const auto draw = [&](Gl gl) {
      bindNewFramebuffer(gl, {kChannelsWidth, kChannelsHeight}, GL_SRGB8_ALPHA8, GL_DEPTH_COMPONENT24);
      setStage(gl);
      gl.PushAttrib(group);
      gl.Enable(GL_FRAMEBUFFER_SRGB);
      coloredBall(gl, -0.3f, 0, {0.9f, 0.3f, 0.2f, 1});
      gl.PopAttrib();
      coloredBall(gl, 0.4f, 0.5f, {0.1f, 0.4f, 0.9f, 1});
    };
    expectEqual("popped " + std::to_string(group), draw, 2);
  }
}

}  // namespace
}  // namespace gluray::test
