// Multisampled framebuffers that are cleared, traced into and resolved: GLuRay computes the pixels without
// them (quirk software-resolve); any other use of the samples finds them.
#include "tests/reference/framebuffers/resolve_stage.h"

#include <gtest/gtest.h>

namespace gluray::test::resolve {
namespace {

TEST(Resolve, ByBlitsOfColorsAndDepths) {
  expectResolves("blit", 1, 1, [](const Stage& s) { s.frame(), s.blit(); });
  expectResolves("blits", 2, 1, [](const Stage& s) { s.frame(), s.blit(kColor), s.blit(kDepth); });
  expectResolves(
      "renderbuffers", 1, 1, [](const Stage& s) { s.frame(), s.blit(); }, false);
}

TEST(Resolve, ByVtksPass) {
  expectResolves("pass", 2, 1, [](const Stage& s) { s.frame(), s.resolve(), s.blit(kDepth); });
}

TEST(Resolve, ByTheTextOfNewerVtk) {
  expectResolves("newer", 2, 1, [](Stage& s) {
    s.averageBy(resolveText(-1, "sampleValue"));
    s.frame(), s.resolve(), s.blit(kDepth);
  });
}

TEST(Resolve, ProgramsThatComputeSomethingElseAreNotVtks) {
  expectResolves("darker", 0, 1, [](Stage& s) {
    std::string text = resolveText();
    text.insert(text.find("  fragOutput0"), "  accumulate *= 0.5;\n");
    s.averageBy(text);
    s.frame(), s.resolve();
  });
}

TEST(Resolve, FrameAfterFrame) {
  expectResolves("frames", 6, 3, [](const Stage& s) {
    for (int i = 0; i < 3; ++i) s.frame(20 * i), s.resolve(), s.blit(kDepth);
  });
}

TEST(Resolve, IntoTwoFramebuffers) {
  expectResolves("two", 2, 1, [](const Stage& s) {
    const GLuint other = s.framebuffer();
    s.attachPixels(true);
    s.frame();
    s.blit(kColor, other);
    s.blit();
  });
}

TEST(Resolve, DepthFunctionsAgainstExistingDepth) {
  expectResolves("less", 1, 1, [](const Stage& s) {
    s.open();
    beginFrame(s.gl);
    s.gl.DepthFunc(GL_LESS);
    s.drawBall();
    s.close(), s.blit();
  });
  expectResolves("nearer", 0, 1, [](const Stage& s) {
    s.open();
    s.gl.ClearDepth(0.9f);
    beginFrame(s.gl);
    s.gl.ClearDepth(1);
    s.drawBall();
    s.close(), s.blit();
  });
}

TEST(Resolve, DrawsRasterisedInBetweenAreKept) {
  expectResolves("line_before", 0, 1, [](const Stage& s) {
    s.open(), beginFrame(s.gl), s.line(), s.drawBall(), s.close(), s.blit();
  });
  expectResolves("line_after", 0, 1, [](const Stage& s) {
    s.open(), beginFrame(s.gl), s.drawBall(), s.line(), s.close(), s.blit();
  });
  expectResolves("line_later", 0, 1, [](const Stage& s) { s.frame(), s.open(), s.line(), s.blit(); });
  expectResolves("line_elsewhere", 1, 1, [](const Stage& s) {
    s.frame();
    s.gl.BindFramebuffer(GL_FRAMEBUFFER, 0), s.line();
    s.blit();
  });
}

TEST(Resolve, DrawsTracedLaterAreKept) {
  expectResolves("more", 0, 2, [](const Stage& s) { s.frame(), s.open(), s.drawBall(70), s.blit(); });
}

TEST(Resolve, DrawsTracedElsewhereAreUnderThem) {
  const auto both = [](const Stage& s) {
    s.open(), beginFrame(s.gl), s.drawBall();
    s.gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, s.plain), beginFrame(s.gl), s.drawBall(70);
  };
  expectResolves("over_blit", 0, 2, [&](const Stage& s) {
    both(s), s.gl.BlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight, kColor, GL_NEAREST);
  });
  expectResolves("over_pass", 1, 2, [&](const Stage& s) { both(s), s.resolve(); });
}

TEST(Resolve, BlitsBeyondTheFramebufferLeaveTheRest) {
  for (const bool textures : {true, false})
    expectResolves(
        "beyond", 0, 1,
        [](const Stage& s) {
          GLuint wide = 0;
          s.gl.GenTextures(1, &wide), s.gl.BindTexture(GL_TEXTURE_2D, wide);
          s.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2 * kWidth, 2 * kHeight, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          nullptr);
          const GLuint other = s.framebuffer();
          s.gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, wide, 0);
          s.gl.ClearColor(0, 1, 0, 1), s.gl.Clear(kColor);
          s.frame();
          s.gl.BindFramebuffer(GL_READ_FRAMEBUFFER, s.many), s.gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, other);
          s.gl.BlitFramebuffer(0, 0, 2 * kWidth, 2 * kHeight, 0, 0, 2 * kWidth, 2 * kHeight, kColor,
                               GL_NEAREST);
          s.gl.BindFramebuffer(GL_READ_FRAMEBUFFER, other),
              s.gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, s.plain);
          s.gl.BlitFramebuffer(kWidth / 2, kHeight / 2, kWidth / 2 + kWidth, kHeight / 2 + kHeight, 0, 0,
                               kWidth, kHeight, kColor, GL_NEAREST);
        },
        textures);
}

TEST(Resolve, ClearsOfPartsHideNothingElse) {
  expectResolves("depth_cleared", 0, 2, [](const Stage& s) {
    s.frame(), s.open(), s.gl.Clear(kDepth), s.drawBall(70), s.close(), s.blit();
  });
  expectResolves("part_cleared", 0, 1, [](const Stage& s) {
    s.frame(), s.open();
    s.gl.Enable(GL_SCISSOR_TEST), s.gl.Scissor(0, 0, kWidth / 2, kHeight);
    s.gl.Clear(kColor | kDepth);
    s.gl.Disable(GL_SCISSOR_TEST);
    s.close(), s.blit();
  });
  expectResolves("red_cleared", 0, 1, [](const Stage& s) {
    s.frame(), s.open();
    s.gl.ColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_FALSE);
    s.gl.Clear(kColor | kDepth);
    s.gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    s.close(), s.blit();
  });
  expectResolves("begun_in_part", 1, 2, [](const Stage& s) {
    s.frame(), s.blit(kColor), s.open();
    s.gl.Enable(GL_SCISSOR_TEST), s.gl.Scissor(0, 0, kWidth / 2, kHeight);
    beginFrame(s.gl);
    s.gl.Disable(GL_SCISSOR_TEST);
    s.drawBall(70), s.close(), s.blit();
  });
}

TEST(Resolve, SingleSamplesCanBeRead) {
  // Nothing is averaged: on triangles seen edge-on, a sample is lit differently from the centre.
  constexpr scenes::Tolerance kSample = {16, 0.001, 1e-5f, "lighting at samples, not at centres"};
  expectResolves(
      "sample", 0, 1, [](const Stage& s) { s.frame(), s.resolve(true); }, true, kSample);
  expectResolves(
      "sample_later", 1, 1, [](const Stage& s) { s.frame(), s.blit(), s.resolve(true); }, true, kSample);
}

TEST(Resolve, BlitsOfParts) {
  expectResolves("part", 1, 1, [](const Stage& s) {
    s.frame();
    s.blit();
    s.gl.BindFramebuffer(GL_READ_FRAMEBUFFER, s.many);
    s.gl.BlitFramebuffer(10, 10, 90, 90, 20, 20, 100, 100, kColor, GL_NEAREST);
  });
  expectResolves("scissor", 0, 1, [](const Stage& s) {
    s.gl.BindFramebuffer(GL_FRAMEBUFFER, s.plain), beginFrame(s.gl);
    s.frame();
    s.gl.Enable(GL_SCISSOR_TEST), s.gl.Scissor(0, 0, kWidth / 2, kHeight);
    s.blit();
    s.gl.Disable(GL_SCISSOR_TEST);
  });
}

TEST(Resolve, AnotherFramebufferOfTheSameSamples) {
  const auto alias = [](const Stage& s) {
    const GLuint name = s.framebuffer();
    s.gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, s.samples, 0);
    s.gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D_MULTISAMPLE, s.sampleDepths,
                              0);
    return name;
  };
  expectResolves("alias_read", 0, 1, [&](const Stage& s) {
    const GLuint name = alias(s);
    s.frame();
    s.gl.BindFramebuffer(GL_READ_FRAMEBUFFER, name), s.gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, s.plain);
    s.gl.BlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight, kColor | kDepth, GL_NEAREST);
  });
  expectResolves("alias_drawn", 0, 1, [&](const Stage& s) {
    const GLuint name = alias(s);
    s.frame();
    s.gl.BindFramebuffer(GL_FRAMEBUFFER, name), s.line();
    s.blit();
  });
}

TEST(Resolve, AttachmentsThatChangeMeanwhile) {
  expectResolves("detached", 0, 1, [](const Stage& s) {
    s.frame(), s.open();
    s.gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, 0, 0);
    s.gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, s.samples, 0);
    s.close(), s.blit();
  });
  expectResolves("deleted", 0, 1, [](const Stage& s) {
    s.frame();
    s.gl.DeleteTextures(1, &s.samples);  // lives on in the framebuffer object
    s.blit();
  });
}

TEST(Resolve, QueriesCountNothingOfIt) {
  expectResolves("query", 0, 1, [](const Stage& s) {
    s.frame();
    GLuint query = 0, passed = 7;
    s.gl.GenQueries(1, &query);
    s.gl.BeginQuery(GL_SAMPLES_PASSED, query);
    s.blit();
    s.gl.EndQuery(GL_SAMPLES_PASSED);
    s.gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
    EXPECT_EQ(passed, 0u);
  });
}

/// With and without the quirk.
Comparison switched(const std::function<void(const Stage&)>& draw, int channel) {
  const auto image = [&](bool on) {
    Settings settings = TracedContext::tracing();
    EXPECT_TRUE(settings.quirks.set("software-resolve", on));
    const uint64_t before = useCount(Quirk::softwareResolve);
    const TracedContext context(coreWish(), settings);
    const Stage stage(context.gl());
    draw(stage);
    DrawnImage result = readImage(context.gl(), kWidth, kHeight);
    EXPECT_EQ(useCount(Quirk::softwareResolve) - before, on ? 2u : 0u);
    return result;
  };
  return compare(image(false), image(true), {channel, 0, 0, "the real OpenGL's powers are rounded"});
}

TEST(Resolve, SwitchedOffItIsTheSameImage) {
  const Comparison pass = switched([](const Stage& s) { s.frame(), s.resolve(), s.blit(kDepth); }, 1);
  EXPECT_TRUE(pass.accepted) << pass.text;
  EXPECT_EQ(pass.depthMax, 0) << pass.text;
  const Comparison blit = switched([](const Stage& s) { s.frame(), s.blit(kColor), s.blit(kDepth); }, 0);
  EXPECT_TRUE(blit.accepted) << blit.text;
  EXPECT_EQ(blit.depthMax, 0) << blit.text;
}

}  // namespace
}  // namespace gluray::test::resolve
