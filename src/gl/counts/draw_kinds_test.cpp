#include "gl/counts/draw_kinds.h"

#include "base/clock.h"
#include "gl/programs/match.h"
#include "gl/state/state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <set>
#include <thread>

namespace gluray::gl {
namespace {

std::set<GLenum> g_enabled;
std::map<GLenum, GLint> g_integers;
std::set<GLenum> g_asked;

GLboolean isEnabled(GLenum name) {
  g_asked.insert(name);
  return g_enabled.count(name) != 0;
}
void getIntegerv(GLenum name, GLint* values) {
  g_asked.insert(name);
  if (name == GL_VIEWPORT) {
    const GLint viewport[4] = {10, 20, 300, 200};
    std::copy_n(viewport, 4, values);
  } else {
    values[0] = g_integers[name];
  }
}

/// An OpenGL that has no functions but glIsEnabled and glGetIntegerv.
RealGl questions() {
  g_enabled = {GL_DEPTH_TEST};
  g_integers = {{GL_DEPTH_WRITEMASK, 1}, {GL_SHADE_MODEL, GL_SMOOTH}, {GL_POLYGON_MODE, GL_FILL}};
  const auto nothing = [](void*, const char*) -> void* { return nullptr; };
  RealGl real{};
  loadRealGl(real, nothing, nullptr);
  real.IsEnabled = isEnabled;
  real.GetIntegerv = getIntegerv;
  return real;
}

constexpr uint32_t bit(DrawState state) { return 1u << static_cast<uint32_t>(state); }

class DrawKindsTest : public ::testing::Test {
 protected:
  void draw(Reason reason, DrawPath path, PrimitiveClass primitive, uint64_t triangles) {
    kinds_.record(real_, target_, reason, path, primitive, triangles);
  }
  RealGl real_ = questions();
  TargetState target_;
  DrawKinds kinds_;
};

TEST_F(DrawKindsTest, EqualDrawsAreOneKind) {
  draw(Reason::traced, DrawPath::list, PrimitiveClass::surfaces, 12);
  draw(Reason::traced, DrawPath::list, PrimitiveClass::surfaces, 30);
  draw(Reason::lines, DrawPath::list, PrimitiveClass::lines, 0);
  const KindTable table = kinds_.kinds();
  ASSERT_EQ(table.size(), 2u);
  const DrawCost& traced = table.at({PrimitiveClass::surfaces, DrawPath::list, Reason::traced, 0});
  EXPECT_EQ(traced.count, 2u);
  EXPECT_EQ(traced.triangles, 42u);
  EXPECT_EQ(table.at({PrimitiveClass::lines, DrawPath::list, Reason::lines, 0}).count, 1u);
}

TEST_F(DrawKindsTest, StateDistinguishesKinds) {
  g_enabled = {GL_BLEND, GL_LIGHTING, GL_CLIP_PLANE0 + 3};
  g_integers[GL_DEPTH_WRITEMASK] = 0;
  g_integers[GL_SHADE_MODEL] = GL_FLAT;
  draw(Reason::blend, DrawPath::arrays, PrimitiveClass::surfaces, 1);
  const uint32_t state = kinds_.kinds().begin()->first.state;
  EXPECT_EQ(state, bit(DrawState::blend) | bit(DrawState::lighting) | bit(DrawState::clipPlanes) |
                       bit(DrawState::flat) | bit(DrawState::noDepthTest) | bit(DrawState::noDepthWrites));
  const std::vector<std::string_view> names = {"lighting",        "flat",       "blend", "no depth test",
                                               "no depth writes", "clip planes"};
  EXPECT_EQ(describeStates(state), names);
}

TEST_F(DrawKindsTest, TargetsAreCounted) {
  draw(Reason::traced, DrawPath::arrays, PrimitiveClass::surfaces, 1);
  target_.framebuffer = 7, target_.size = {64, 32}, target_.samples = 4;
  draw(Reason::blend, DrawPath::arrays, PrimitiveClass::surfaces, 1);
  const TargetTable targets = kinds_.targets();
  ASSERT_EQ(targets.size(), 2u);
  EXPECT_EQ(targets.at(0).traced, 1u);
  EXPECT_EQ(targets.at(0).width, 310);
  EXPECT_EQ(targets.at(0).height, 220);
  EXPECT_EQ(targets.at(7).rasterised, 1u);
  EXPECT_EQ(targets.at(7).width, 64);
  EXPECT_EQ(targets.at(7).samples, 4);
}

TEST_F(DrawKindsTest, InnerDrawsAndExcludedTimeAreNotChargedToOuterOnes) {
  const auto sleep = [] { std::this_thread::sleep_for(std::chrono::milliseconds(30)); };
  const double start = nowSeconds();
  {
    const DrawTimer outer(&kinds_);
    {
      const DrawTimer inner(&kinds_);
      draw(Reason::lines, DrawPath::immediate, PrimitiveClass::lines, 0);
      sleep();
    }
    kinds_.exclude(0.030);  // as if 30 ms had been spent tracing
    sleep();
    draw(Reason::traced, DrawPath::arrays, PrimitiveClass::surfaces, 1);
  }
  const double all = nowSeconds() - start;
  const KindTable table = kinds_.kinds();
  const double inner = table.at({PrimitiveClass::lines, DrawPath::immediate, Reason::lines, 0}).seconds;
  const double outer = table.at({PrimitiveClass::surfaces, DrawPath::arrays, Reason::traced, 0}).seconds;
  EXPECT_GE(inner, 0.029);
  EXPECT_GE(outer, 0.0);
  EXPECT_LE(inner + outer, all - 0.029) << "however long the machine took";
}

TEST_F(DrawKindsTest, LateTrianglesBelongToTheDrawRecordedLast) {
  draw(Reason::fog, DrawPath::immediate, PrimitiveClass::surfaces, 0);
  kinds_.addTriangles(5);
  EXPECT_EQ(kinds_.kinds().begin()->second.triangles, 5u);
}

TEST_F(DrawKindsTest, NothingIsRecordedOnceClosed) {
  draw(Reason::fog, DrawPath::immediate, PrimitiveClass::surfaces, 3);
  kinds_.close();
  draw(Reason::fog, DrawPath::immediate, PrimitiveClass::surfaces, 3);
  kinds_.addTriangles(5);
  EXPECT_EQ(kinds_.kinds().begin()->second.triangles, 3u);
  EXPECT_EQ(kinds_.kinds().begin()->second.count, 1u);
}

TEST_F(DrawKindsTest, UnpairedStopsAreHarmless) {
  kinds_.stop();
  for (int i = 0; i < 1000; ++i) kinds_.start();
  draw(Reason::fog, DrawPath::immediate, PrimitiveClass::surfaces, 3);
  for (int i = 0; i < 2000; ++i) kinds_.stop();
  EXPECT_EQ(kinds_.kinds().size(), 1u);
}

TEST_F(DrawKindsTest, CoreProfilesAreNotAskedForFixedFunction) {
  const std::set<GLenum> fixed = {GL_LIGHTING,   GL_LIGHT_MODEL_TWO_SIDE, GL_COLOR_MATERIAL, GL_SHADE_MODEL,
                                  GL_TEXTURE_1D, GL_TEXTURE_2D,           GL_ALPHA_TEST,     GL_FOG};
  const auto asked = [&](bool fixedFunction) {
    g_asked.clear();
    DrawKinds kinds(fixedFunction);
    kinds.record(real_, target_, Reason::traced, DrawPath::arrays, PrimitiveClass::surfaces, 1);
    std::set<GLenum> both;
    std::set_intersection(g_asked.begin(), g_asked.end(), fixed.begin(), fixed.end(),
                          std::inserter(both, both.end()));
    return both;
  };
  EXPECT_GE(asked(true).size(), 5u);
  EXPECT_EQ(asked(false), std::set<GLenum>{});
}

TEST_F(DrawKindsTest, ProgramsAreCountedSeparately) {
  const auto first = std::make_shared<KnownProgram>(), second = std::make_shared<KnownProgram>();
  const auto drawBy = [&](const std::shared_ptr<const KnownProgram>& program, Reason reason,
                          uint64_t triangles) {
    kinds_.record(real_, target_, reason, DrawPath::elements, PrimitiveClass::surfaces, triangles, program);
  };
  drawBy(first, Reason::traced, 10), drawBy(first, Reason::blend, 5), drawBy(second, Reason::program, 3);
  drawBy(nullptr, Reason::traced, 100);
  const ProgramTable table = kinds_.programs();
  ASSERT_EQ(table.size(), 2u);
  const ProgramUse &one = table.at(first.get()), &two = table.at(second.get());
  EXPECT_EQ(one.program, first);
  EXPECT_EQ(one.traced, 1u);
  EXPECT_EQ(one.rasterised, 1u);
  EXPECT_EQ(one.triangles, 15u);
  EXPECT_EQ(two.traced, 0u);
  EXPECT_EQ(two.rasterised, 1u);
  kinds_.record(real_, target_, Reason::programValue, DrawPath::elements, PrimitiveClass::surfaces, 1, second,
                "uniform is 2");
  drawBy(second, Reason::traced, 1);
  EXPECT_EQ(kinds_.programs().at(second.get()).why, "uniform is 2");
  ProgramUse sum;
  sum += one, sum += one;
  EXPECT_EQ(sum.triangles, 30u);
  EXPECT_EQ(sum.program, first);
}

}  // namespace
}  // namespace gluray::gl
