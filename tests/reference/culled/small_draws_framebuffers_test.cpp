// Small draws among depths that are copied between framebuffers, and among several framebuffers in a frame:
// images of all of them are those of all draws to the bit.
#include "tests/reference/culled/small_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

using namespace culled;

/// Framebuffer objects with colours and depths of their own, and one that shares the depths of the first.
class Framebuffers {
 public:
  enum Which : size_t { first, second, sharing, kCount };

  void prepare(Gl gl) {
    gl.GenFramebuffers(kCount, names_.data()), gl.GenTextures(2, depths_.data());
    std::array<GLuint, kCount> colors{};
    gl.GenRenderbuffers(kCount, colors.data());
    for (const GLuint texture : depths_) {
      gl.BindTexture(GL_TEXTURE_2D, texture);
      gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, kSide, kSide, 0, GL_DEPTH_STENCIL,
                    GL_UNSIGNED_INT_24_8, nullptr);
      gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    }
    gl.BindTexture(GL_TEXTURE_2D, 0);
    for (size_t i = 0; i < kCount; ++i) {
      bind(gl, static_cast<Which>(i));
      gl.BindRenderbuffer(GL_RENDERBUFFER, colors[i]);
      gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kSide, kSide);
      gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colors[i]);
      attachDepths(gl, i == second ? second : first);
      EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    }
    gl.BindRenderbuffer(GL_RENDERBUFFER, 0);
    window(gl);
  }
  void bind(Gl gl, Which which) const { gl.BindFramebuffer(GL_FRAMEBUFFER, names_[which]); }
  static void window(Gl gl) { gl.BindFramebuffer(GL_FRAMEBUFFER, 0); }
  /// To the framebuffer that is bound.
  void attachDepths(Gl gl, Which of) const {
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, depths(of), 0);
  }
  GLuint name(Which which) const { return names_[which]; }
  GLuint depths(Which which) const { return depths_[which == second ? 1 : 0]; }
  /// All of them hold nothing, at the far plane.
  void clearAll(Gl gl) const {
    for (const GLuint name : names_) gl.BindFramebuffer(GL_FRAMEBUFFER, name), clear(gl);
    window(gl), clear(gl);
  }
  /// Copies depths in a box of pixels. 0: the window.
  static void copyDepths(Gl gl, GLuint from, GLuint to, const std::array<GLint, 4>& box) {
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, from), gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    gl.BlitFramebuffer(box[0], box[1], box[2], box[3], box[0], box[1], box[2], box[3], GL_DEPTH_BUFFER_BIT,
                       GL_NEAREST);
  }
  /// The window and all objects, one above the other.
  DrawnImage read(Gl gl) const {
    DrawnImage all{kSide, kSide * (int(kCount) + 1), {}, {}};
    std::vector<GLuint> names(names_.begin(), names_.end());
    names.push_back(0);
    for (const GLuint name : names) {
      gl.BindFramebuffer(GL_READ_FRAMEBUFFER, name);
      const DrawnImage one = readImage(gl, kSide, kSide);
      all.colors.insert(all.colors.end(), one.colors.begin(), one.colors.end());
      all.depths.insert(all.depths.end(), one.depths.begin(), one.depths.end());
    }
    window(gl);
    return all;
  }

 private:
  std::array<GLuint, kCount> names_{};
  std::array<GLuint, 2> depths_{};
};

constexpr std::array<GLint, 4> kAll{0, 0, kSide, kSide}, kMiddle{60, 50, 130, 170};

struct FramebufferCase {
  std::string name;
  /// All is clear; the scene's program is in use, the window is bound.
  std::function<void(Gl, const SmallScene&, const Framebuffers&)> draw;
};

gl::Statistics compareFramebuffers(const FramebufferCase& of) {
  SmallScene scene;
  Framebuffers framebuffers;
  const Settings settings = smallDraws();
  return compareFrames(
      "small_framebuffers_" + of.name, 3, [&](Gl gl) { scene.prepare(gl), framebuffers.prepare(gl); },
      [&](Gl gl, int) {
        framebuffers.clearAll(gl), scene.begin(gl);
        of.draw(gl, scene, framebuffers);
        Framebuffers::window(gl);
      },
      &settings, kCompatible, [&](Gl gl) { return framebuffers.read(gl); });
}

/// The wall hides the balls until depths of a clear are copied over its own.
std::vector<FramebufferCase> copiesOfDepths() {
  using F = Framebuffers;
  const auto between = [](F::Which from, F::Which to, const std::array<GLint, 4>& box) {
    return [=](Gl gl, const SmallScene& s, const F& f) {
      f.bind(gl, to), s.wallSeen(gl);
      F::copyDepths(gl, f.name(from), f.name(to), box);
      s.balls(gl, 6);
    };
  };
  return {
      {"blit", between(F::second, F::first, kAll)},
      {"blit_part", between(F::second, F::first, kMiddle)},
      {"blit_back", between(F::first, F::second, kMiddle)},
      {"blit_to_window",
       [](Gl gl, const SmallScene& s, const F& f) {
         s.wallSeen(gl), F::copyDepths(gl, f.name(F::first), 0, kMiddle), s.balls(gl, 6);
       }},
      {"blit_named",
       [](Gl gl, const SmallScene& s, const F& f) {
         f.bind(gl, F::first), s.wallSeen(gl);
         gl.BlitNamedFramebuffer(f.name(F::second), f.name(F::first), 0, 0, kSide, kSide, 0, 0, kSide, kSide,
                                 GL_DEPTH_BUFFER_BIT, GL_NEAREST);
         s.balls(gl, 6);
       }},
      {"blit_scissored",
       [](Gl gl, const SmallScene& s, const F& f) {
         f.bind(gl, F::first), s.wallSeen(gl);
         gl.Enable(GL_SCISSOR_TEST), gl.Scissor(90, 90, 40, 30);
         F::copyDepths(gl, f.name(F::second), f.name(F::first), kAll);
         gl.Disable(GL_SCISSOR_TEST), s.balls(gl, 6);
       }},
      {"copy_image",
       [](Gl gl, const SmallScene& s, const F& f) {
         f.bind(gl, F::first), s.wallSeen(gl);
         gl.CopyImageSubData(f.depths(F::second), GL_TEXTURE_2D, 0, 40, 40, 0, f.depths(F::first),
                             GL_TEXTURE_2D, 0, 40, 40, 0, 120, 120, 1);
         s.balls(gl, 6);
       }},
      {"tex_sub_image",
       [](Gl gl, const SmallScene& s, const F& f) {
         f.bind(gl, F::first), s.wallSeen(gl);
         const std::vector<GLuint> far(size_t{100} * 100, 0xFFFFFF00u);
         gl.BindTexture(GL_TEXTURE_2D, f.depths(F::first));
         gl.TexSubImage2D(GL_TEXTURE_2D, 0, 50, 50, 100, 100, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                          far.data());
         gl.BindTexture(GL_TEXTURE_2D, 0), s.balls(gl, 6);
       }},
      {"texture_sub_image",
       [](Gl gl, const SmallScene& s, const F& f) {
         f.bind(gl, F::first), s.wallSeen(gl);
         const std::vector<GLuint> far(size_t{100} * 100, 0xFFFFFF00u);
         gl.TextureSubImage2D(f.depths(F::first), 0, 50, 50, 100, 100, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                              far.data());
         s.balls(gl, 6);
       }},
      {"clear_texture",
       [](Gl gl, const SmallScene& s, const F& f) {
         f.bind(gl, F::first), s.wallSeen(gl);
         const GLuint far = 0xFFFFFF00u;
         gl.ClearTexImage(f.depths(F::first), 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, &far);
         s.balls(gl, 6);
       }},
      {"clear_named",
       [](Gl gl, const SmallScene& s, const F& f) {
         f.bind(gl, F::first), s.wallSeen(gl);
         gl.ClearNamedFramebufferfi(f.name(F::first), GL_DEPTH_STENCIL, 0, 1, 0);
         s.balls(gl, 6);
       }},
  };
}

TEST(SmallDrawsOfFramebuffers, SeeThatDepthsWereCopied) {
  for (const FramebufferCase& of : copiesOfDepths())
    EXPECT_GE(compareFramebuffers(of).drawsCulled, 3u) << of.name << ": the ball before the copy";
}

/// Depths of one framebuffer say nothing of another one, and change in the meantime.
std::vector<FramebufferCase> switches() {
  using F = Framebuffers;
  return {
      {"back_and_forth",
       [](Gl gl, const SmallScene& s, const F& f) {
         s.wallSeen(gl);
         f.bind(gl, F::first), s.balls(gl, 6);
         F::window(gl), s.balls(gl, 6);
         f.bind(gl, F::second), s.wallSeen(gl), s.balls(gl, 6);
         f.bind(gl, F::first), s.balls(gl, 5.5f, 0.2f);
       }},
      {"shared_depths",
       [](Gl gl, const SmallScene& s, const F& f) {
         f.bind(gl, F::first), s.wallSeen(gl);
         f.bind(gl, F::sharing), gl.Clear(GL_DEPTH_BUFFER_BIT);
         f.bind(gl, F::first), s.balls(gl, 6), s.wallSeen(gl);
         f.bind(gl, F::sharing), s.balls(gl, 6);
       }},
      {"other_attachment",
       [](Gl gl, const SmallScene& s, const F& f) {
         f.bind(gl, F::first), s.wallSeen(gl);
         f.attachDepths(gl, F::second), s.balls(gl, 6);
         f.attachDepths(gl, F::first), s.balls(gl, 6.5f);
       }},
      {"named_attachment",
       [](Gl gl, const SmallScene& s, const F& f) {
         f.bind(gl, F::first), s.wallSeen(gl);
         gl.NamedFramebufferTexture(f.name(F::first), GL_DEPTH_STENCIL_ATTACHMENT, f.depths(F::second), 0);
         s.balls(gl, 6);
         gl.NamedFramebufferTexture(f.name(F::first), GL_DEPTH_STENCIL_ATTACHMENT, f.depths(F::first), 0);
       }},
      {"no_depths",
       [](Gl gl, const SmallScene& s, const F& f) {
         f.bind(gl, F::first), s.wallSeen(gl);
         gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
         s.balls(gl, 6), f.attachDepths(gl, F::first), s.balls(gl, 6.5f);
       }},
      {"draw_alone",
       [](Gl gl, const SmallScene& s, const F& f) {
         s.wallSeen(gl);
         gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, f.name(F::second)), s.balls(gl, 6);
         gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0), s.balls(gl, 6);
         gl.BindFramebuffer(GL_READ_FRAMEBUFFER, f.name(F::second)), s.balls(gl, 5.8f), s.wallSeen(gl);
         s.balls(gl, 6.2f, 0.1f);
       }},
      {"reallocated",
       [](Gl gl, const SmallScene& s, const F& f) {
         f.bind(gl, F::second), s.wallSeen(gl);
         const std::vector<GLuint> far(size_t{kSide} * kSide, 0xFFFFFF00u);
         gl.BindTexture(GL_TEXTURE_2D, f.depths(F::second));
         gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, kSide, kSide, 0, GL_DEPTH_STENCIL,
                       GL_UNSIGNED_INT_24_8, far.data());
         gl.BindTexture(GL_TEXTURE_2D, 0), s.balls(gl, 6);
       }},
  };
}

TEST(SmallDrawsOfFramebuffers, FollowSwitches) {
  for (const FramebufferCase& of : switches()) EXPECT_GE(compareFramebuffers(of).drawsCulled, 3u) << of.name;
}

/// Without a switch, draws into framebuffer objects are left out as those into windows are.
TEST(SmallDrawsOfFramebuffers, AreLeftOut) {
  const auto hidden = [](Gl gl, const SmallScene& s, const Framebuffers& f) {
    f.bind(gl, Framebuffers::first), s.wallSeen(gl), s.balls(gl, 6), s.balls(gl, 3.2f);
  };
  EXPECT_EQ(compareFramebuffers({"hidden", hidden}).drawsCulled, 3 * 8u);
}

}  // namespace
}  // namespace gluray::test
