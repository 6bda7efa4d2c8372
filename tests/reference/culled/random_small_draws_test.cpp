// Random draws of small meshes among random commands that change depths and state: images are those of all
// draws to the bit, and no draw that was left out would have shown.
#include "tests/reference/culled/small_scene.h"
#include "tests/reference/culled/timed_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <string>

namespace gluray::test {
namespace {

using namespace culled;

class RandomFrame {
 public:
  RandomFrame(Gl gl, const SmallScene& scene, unsigned seed) : gl_(gl), scene_(scene), random_(seed) {}

  void draw() {
    reset();
    scene_.begin(gl_);
    if (oneIn(2)) scene_.wall(gl_, number(1.5f, 7), number(0.4f, 3));
    for (int i = 0; i < 60; ++i) {
      if (oneIn(6)) changeState();
      if (oneIn(25)) changeDepths();
      thing();
    }
    reset();
  }

 private:
  bool oneIn(unsigned n) { return random_() % n == 0; }
  float number(float low, float high) {
    return low + (high - low) * static_cast<float>(random_()) / 4294967296.0f;
  }
  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }

  void thing() {
    if (oneIn(20)) return scene_.wall(gl_, number(0.6f, 9), number(0.3f, 4));
    if (oneIn(12)) return scene_.board(gl_, number(0.6f, 9), number(0.3f, 4));
    const float radius = oneIn(5) ? number(0.5f, 5) : number(0.02f, 0.5f);
    scene_.ballAt(gl_, {number(-3, 3), number(-3, 3), number(-10, 1)}, radius);
  }
  void changeState() {
    constexpr std::array kFuncs{GL_LESS,   GL_LESS,    GL_LEQUAL, GL_LESS,     GL_EQUAL,
                                GL_ALWAYS, GL_GREATER, GL_GEQUAL, GL_NOTEQUAL, GL_NEVER};
    switch (below(10)) {
      case 0:
        return gl_.DepthFunc(static_cast<GLenum>(kFuncs[static_cast<size_t>(below(int(kFuncs.size())))]));
      case 1: return gl_.DepthFunc(GL_LESS);
      case 2: return gl_.DepthMask(oneIn(3) ? GL_FALSE : GL_TRUE);
      case 3: return toggle(GL_BLEND, 2), gl_.BlendFunc(GL_ONE, GL_ONE);
      case 4: return gl_.DepthRange(number(0, 0.3f), number(0.7f, 1));
      case 5:
        return gl_.Viewport(below(60) - 30, below(60) - 30, kSide + below(60) - 30, kSide + below(60) - 30);
      case 6:
        return toggle(GL_SCISSOR_TEST, 3), gl_.Scissor(below(90), below(90), 40 + below(90), 40 + below(90));
      case 7: return toggle(GL_POLYGON_OFFSET_FILL, 3), gl_.PolygonOffset(number(-4, 4), number(-500, 500));
      case 8: return toggle(GL_CULL_FACE, 2), toggle(GL_DEPTH_CLAMP, 4);
      default: return toggle(GL_DEPTH_TEST, 6, true);
    }
  }
  void changeDepths() {
    switch (below(4)) {
      case 0: return gl_.ClearDepth(number(0.4f, 1)), gl_.Clear(GL_DEPTH_BUFFER_BIT);
      case 1: return gl_.Clear(GL_COLOR_BUFFER_BIT);
      case 2: {
        const GLfloat depth = number(0.5f, 1);
        return gl_.ClearBufferfv(GL_DEPTH, 0, &depth);
      }
      default: gl_.UseProgram(0), gl_.WindowPos2i(below(100), below(100));
    }
    gl_.CopyPixels(below(50), below(50), 90, 90, GL_DEPTH), gl_.UseProgram(scene_.program);
  }
  void toggle(GLenum what, unsigned odds, bool otherwise = false) {
    oneIn(odds) != otherwise ? gl_.Enable(what) : gl_.Disable(what);
  }
  void reset() {
    for (const GLenum off : {GL_BLEND, GL_SCISSOR_TEST, GL_POLYGON_OFFSET_FILL, GL_CULL_FACE, GL_DEPTH_CLAMP})
      gl_.Disable(off);
    gl_.DepthMask(GL_TRUE), gl_.DepthRange(0, 1);
  }

  Gl gl_;
  const SmallScene& scene_;
  std::mt19937 random_;
};

unsigned seeds() {
  const char* const wanted = std::getenv("GLURAY_RANDOM_SMALL_DRAWS");
  return wanted ? static_cast<unsigned>(std::atoi(wanted)) : 12;
}

TEST(RandomSmallDraws, AreTheSame) {
  uint64_t culled = 0;
  for (unsigned seed = 1; seed <= seeds(); ++seed) {
    SmallScene scene;
    Settings settings = smallDraws();
    settings.cull.verify = seed % 3 == 0 ? 1 : 0;
    const gl::Statistics counts = compareFrames(
        "random_small_" + std::to_string(seed), 3, [&](Gl gl) { scene.prepare(gl); },
        [&](Gl gl, int frame) { RandomFrame(gl, scene, 100 * seed + static_cast<unsigned>(frame)).draw(); },
        &settings, kCompatible);
    culled += counts.drawsCulled;
  }
  EXPECT_GT(culled, 20 * seeds());
}

TEST(RandomSmallDraws, AreTheSameWhileTrialsBeginAndEnd) {
  uint64_t culled = 0;
  const unsigned most = std::max(seeds() / 3, 1u);
  for (unsigned seed = 1; seed <= most; ++seed) {
    std::mt19937 random(seed);
    const double slowest = 0.3 * (seed % 4) + 0.01;
    const auto leftOut = compareTimedFrames(
        "random_small_trials_" + std::to_string(seed), 24,
        [&](Gl gl, const SmallScene& scene, int frame) {
          for (const unsigned part : {0u, 50u})
            RandomFrame(gl, scene, 100 * seed + static_cast<unsigned>(frame) + part).draw();
        },
        [&] { return slowest * static_cast<double>(random()) / 4294967296.0; }, seed % 3 == 0 ? 1 : 0);
    for (const uint64_t count : leftOut) culled += count;
  }
  EXPECT_GT(culled, 20 * most);
}

}  // namespace
}  // namespace gluray::test
