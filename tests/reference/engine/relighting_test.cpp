// Batches whose view turns out to hold other surfaces than they were lit with are lit again (adr/0095).
#include "tests/reference/engine/lit_program.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace gluray::test::lit {
namespace {

TEST(Relighting, WhatComesLaterLightsTheFirstFrameAndIsTakenForGrantedInTheNext) {
  LitProgram program(coarseAo());
  const std::vector<int> whole = floorOf(frameOf({floor, wall})), alone = floorOf(frameOf({floor}));
  ASSERT_NE(whole, alone);
  const auto relit = [&] { return static_cast<uint64_t>(program.statistics().imagesRelit); };
  EXPECT_EQ(floorOf(program.frame({floor, kSplit, wall})), whole);
  EXPECT_EQ(relit(), 1u) << "the floor was traced before the wall was known";
  EXPECT_EQ(floorOf(program.frame({floor, kSplit, wall})), whole);
  const uint64_t repeated = program.statistics().repeated;
  EXPECT_EQ(floorOf(program.frame({floor, kSplit, wall})), whole);
  EXPECT_EQ(program.statistics().repeated, repeated + 2) << "images are used again while nothing changes";
  EXPECT_EQ(relit(), 1u) << "the wall was taken for granted, and came";
  EXPECT_EQ(floorOf(program.frame({floor, kSplit})), alone) << "it did not come";
  EXPECT_EQ(floorOf(program.frame({floor, kSplit})), alone);
  EXPECT_EQ(floorOf(program.frame({floor, kSplit, wall})), whole) << "it comes back";
}

TEST(Relighting, WhatStandsElsewhereThanBeforeIsLitThere) {
  const auto wallAt = [](float x) {
    return Step([x](Gl gl) {
      gl.PushMatrix();
      gl.Translatef(x, 0, 0);
      wall(gl);
      gl.PopMatrix();
    });
  };
  LitProgram program(coarseAo());
  for (const float x : {0.0f, -0.05f, -0.1f, -0.1f}) {
    const std::vector<int> whole = floorOf(frameOf({floor, wallAt(x)}));
    EXPECT_EQ(floorOf(program.frame({floor, kSplit, wallAt(x)})), whole) << x;
  }
}

TEST(Relighting, WhatWasDrawnOverAnImageStaysWhenItIsLitAgain) {
  // The line is drawn in front of the floor without depth, before the wall is known.
  const Step line = [](Gl gl) {
    gl.Disable(GL_DEPTH_TEST);
    gl.Color4f(0, 1, 0, 1);
    gl.Begin(GL_LINES);
    gl.Vertex3f(-1, 0.01f, -0.5f), gl.Vertex3f(0.5f, 0.01f, -0.5f);
    gl.End();
    gl.Enable(GL_DEPTH_TEST);
  };
  const DrawnImage split = frameOf({floor, line, wall}), plain = frameOf({floor, wall});
  int green = 0;
  for (size_t i = 0; i < split.colors.size(); ++i) {
    const bool isLine = (split.colors[i] & 0xffffffu) == 0x00ff00u;
    green += isLine;
    EXPECT_TRUE(isLine || split.colors[i] == plain.colors[i]) << i;
  }
  EXPECT_GE(green, kLitViewSize / 2);
}

TEST(Relighting, EdgesOfLaterImagesShowTheNewLightOfWhatIsBelow) {
  const Step card = [](Gl gl) {
    gl.Color4f(1, 0.2f, 0.2f, 1);
    quad(gl, {-0.5f, -0.45f, -0.3f}, {0.8f, -0.6f, -0.3f}, {0.7f, 0.55f, -0.3f}, {-0.6f, 0.6f, -0.3f});
  };
  Settings settings = coarseAo();
  settings.spp = 4;
  LitProgram program(settings);
  const DrawnImage first = program.frame({floor, kSplit, card, kSplit, wall});
  EXPECT_GT(program.statistics().imagesRelit, 0u) << "the floor was traced before the card was known";
  const DrawnImage known = program.frame({floor, kSplit, card, kSplit, wall});
  for (size_t i = 0; i < first.colors.size(); ++i)
    for (const int shift : {0, 8, 16})
      EXPECT_NEAR(static_cast<int>(first.colors[i] >> shift & 255),
                  static_cast<int>(known.colors[i] >> shift & 255), 1)
          << i << ": blends round";
}

TEST(Relighting, AnErasedSurfaceGivesNoShade) {
  // The program removes the wall, which lies in the right half, and draws the floor there again.
  const Step erase = [](Gl gl) {
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(kLitViewSize / 2, 0, kLitViewSize / 2, kLitViewSize);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    floor(gl);
    gl.Disable(GL_SCISSOR_TEST);
  };
  const Step half = [](Gl gl) { gl.LoadIdentity(), gl.Scalef(1, 0.9f, 1); };  // inside the window
  const std::vector<int> alone = floorOf(frameOf({half, floor}));
  EXPECT_NE(floorOf(frameOf({half, floor, kSplit, wall})), alone);
  EXPECT_EQ(floorOf(frameOf({half, floor, kSplit, wall, erase})), alone);
  LitProgram program(coarseAo());
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_EQ(floorOf(program.frame({half, floor, kSplit, wall, erase})), alone) << frame;
    EXPECT_EQ(program.statistics().drawsTraced, 3u * (static_cast<unsigned>(frame) + 1));
  }
}

TEST(Relighting, CopiesOfDepthsFinishNoPicture) {
  for (const bool image : {true, false}) {
    LitProgram program(coarseAo());
    GLuint texture = 0;
    program.gl().GenTextures(1, &texture);
    const Step copy = [&](Gl gl) {
      gl.BindTexture(GL_TEXTURE_2D, texture);
      if (image)
        return gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 0, kLitViewSize, kLitViewSize, 0);
      gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kLitViewSize, kLitViewSize, 0, GL_DEPTH_COMPONENT,
                    GL_FLOAT, nullptr);
      gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, kLitViewSize, kLitViewSize);
    };
    for (int frame = 0; frame < 3; ++frame) {
      program.frame({floor, copy, wall});
      EXPECT_EQ(program.statistics().imagesRelit, 1u) << "the wall comes again in frame " << frame;
    }
    EXPECT_EQ(program.gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
}

/// A framebuffer object with a texture or, with several samples, a renderbuffer for its colours.
struct Object {
  GLuint framebuffer = 0, texture = 0, buffers[2] = {};
  Object(Gl gl, GLsizei samples) {
    gl.GenFramebuffers(1, &framebuffer);
    gl.GenRenderbuffers(2, buffers);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (samples == 1) {
      texture = makeTexture(gl);
      gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    }
    const GLenum formats[2] = {GL_DEPTH24_STENCIL8, GL_RGBA8},
                 places[2] = {GL_DEPTH_STENCIL_ATTACHMENT, GL_COLOR_ATTACHMENT0};
    for (int i = 0; i < (samples == 1 ? 1 : 2); ++i) {
      gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
      if (samples == 1)
        gl.RenderbufferStorage(GL_RENDERBUFFER, formats[i], kLitViewSize, kLitViewSize);
      else
        gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, formats[i], kLitViewSize, kLitViewSize);
      gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, buffers[i]);
    }
    EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), unsigned{GL_FRAMEBUFFER_COMPLETE});
  }
  static GLuint makeTexture(Gl gl) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kLitViewSize, kLitViewSize, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    return name;
  }
};

/// Draws the texture over the whole window.
void drawTexture(Gl gl, GLuint texture) {
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_TEXTURE_2D);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.Begin(GL_QUADS);
  for (const glm::vec2 at : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
    gl.TexCoord2f((at.x + 1) / 2, (at.y + 1) / 2), gl.Vertex2f(at.x, at.y);
  gl.End();
  gl.Disable(GL_TEXTURE_2D);
  gl.Enable(GL_DEPTH_TEST);
}

/// How the picture of a framebuffer object comes into the window.
struct PictureEnd {
  const char* name;
  GLsizei samples;
  std::function<void(Gl, const Object&)> show;
};
void PrintTo(const PictureEnd& end, std::ostream* out) { *out << end.name; }

void blit(Gl gl, const Object& object) {
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, object.framebuffer);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl.BlitFramebuffer(0, 0, kLitViewSize, kLitViewSize, 0, 0, kLitViewSize, kLitViewSize, GL_COLOR_BUFFER_BIT,
                     GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

const PictureEnd kPictureEnds[] = {
    {"blit", 1, blit},
    {"resolve", 4, blit},
    {"copy", 1,
     [](Gl gl, const Object&) {
       const GLuint texture = Object::makeTexture(gl);
       gl.BindTexture(GL_TEXTURE_2D, texture);
       gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, kLitViewSize, kLitViewSize);
       gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
       drawTexture(gl, texture);
     }},
    {"sampled", 1,
     [](Gl gl, const Object& object) {
       gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
       drawTexture(gl, object.texture);
     }},
    {"textureRead", 1,
     [](Gl gl, const Object& object) {
       std::vector<uint32_t> pixels(size_t{kLitViewSize} * kLitViewSize);
       gl.BindTexture(GL_TEXTURE_2D, object.texture);
       gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
       gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
       gl.Disable(GL_DEPTH_TEST);
       gl.WindowPos2i(0, 0);
       gl.DrawPixels(kLitViewSize, kLitViewSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
       gl.Enable(GL_DEPTH_TEST);
     }},
};

class PictureEnds : public testing::TestWithParam<PictureEnd> {};

TEST_P(PictureEnds, ShowTheLightOfTheLastDraw) {
  const PictureEnd& end = GetParam();
  const auto frameWith = [&](const Step& split, const Step& last) {
    LitProgram program(coarseAo());
    const Object object(program.gl(), end.samples);
    return program.frame({[&](Gl gl) {
                            gl.BindFramebuffer(GL_FRAMEBUFFER, object.framebuffer);
                            gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
                          },
                          floor, split, last, [&](Gl gl) { end.show(gl, object); }});
  };
  const std::vector<int> alone = floorOf(frameWith(nothing, nothing)),
                         whole = floorOf(frameWith(nothing, wall)), split = floorOf(frameWith(kSplit, wall));
  EXPECT_NE(alone, whole);
  const int rounding = end.samples > 1 ? 1 : 0;  // of means
  for (size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(split[i], whole[i], rounding) << i;
}

INSTANTIATE_TEST_SUITE_P(Relighting, PictureEnds, testing::ValuesIn(kPictureEnds),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test::lit
