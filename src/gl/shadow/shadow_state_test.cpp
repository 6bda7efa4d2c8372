// When ShadowState queries the real OpenGL, by a fake OpenGL that counts queries.
#include "gl/shadow/shadow_state.h"

#include "gl/basics/failsafe.h"
#include "gl/real/errors.h"

#include <GL/glext.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <new>

namespace gluray::gl {
namespace {

struct CountingGl {
  std::map<GLenum, int> asked;  // times, by name
  int queries = 0;              // of state
  int errorQueries = 0;
  GLint width = 300;           // of the viewport
  bool colorMaterial = false;  // and lighting
  bool lighting = false;
  bool fails = false;
  std::array<GLfloat, 4> material{};  // each colour
};
CountingGl g_counting;

void countQuery(GLenum name) {
  ++g_counting.asked[name], ++g_counting.queries;
  if (g_counting.fails) throw std::bad_alloc();
}

void APIENTRY countIntegerv(GLenum name, GLint* values) {
  countQuery(name);
  if (name == GL_VIEWPORT) std::copy_n(std::array<GLint, 4>{0, 0, g_counting.width, 200}.data(), 4, values);
  if (name == GL_COLOR_MATERIAL_PARAMETER) *values = GL_DIFFUSE;
}
void APIENTRY countFloatv(GLenum name, GLfloat*) { countQuery(name); }
void APIENTRY countDoublev(GLenum name, GLdouble*) { countQuery(name); }
void APIENTRY countBooleanv(GLenum name, GLboolean*) { countQuery(name); }
GLboolean APIENTRY countEnabled(GLenum name) {
  countQuery(name);
  const bool lights = name == GL_LIGHTING || name == GL_COLOR_MATERIAL;
  const bool on = (g_counting.colorMaterial && lights) || (g_counting.lighting && name == GL_LIGHTING);
  return on ? GL_TRUE : GL_FALSE;
}
void APIENTRY countMaterialfv(GLenum, GLenum name, GLfloat* values) {
  countQuery(name);
  if (name != GL_SHININESS) std::copy_n(g_counting.material.data(), 4, values);
}
const GLubyte* APIENTRY countString(GLenum name) {
  countQuery(name);
  return reinterpret_cast<const GLubyte*>(name == GL_VERSION ? "2.1 Fake" : "");
}
GLenum APIENTRY countError() {
  ++g_counting.errorQueries;
  return GL_NO_ERROR;
}

RealGl countingTable() {
  RealGl real;
  loadRealGl(
      real, [](void*, const char*) -> void* { return nullptr; }, nullptr);
  real.GetIntegerv = countIntegerv, real.GetFloatv = countFloatv, real.GetDoublev = countDoublev;
  real.GetBooleanv = countBooleanv, real.IsEnabled = countEnabled, real.GetMaterialfv = countMaterialfv;
  real.GetString = countString, real.GetError = countError;
  real.UseProgram = [](GLuint) {};
  return real;
}

struct StateRead {
  uint32_t groups;  // that it needs
  void (*read)(ShadowState&);
};
const StateRead kStateReads[] = {
    {kModelview, [](ShadowState& s) { s.modelview(), s.modelviewIsInvertible(); }},
    {kProjection, [](ShadowState& s) { s.projection(), s.projectionIsInvertible(); }},
    {kViewport, [](ShadowState& s) { s.viewport(), s.viewportPixels(); }},
    {kRaster, [](ShadowState& s) { s.raster(); }},
    {kTarget, [](ShadowState& s) { s.target(); }},
    {kLighting | kRaster, [](ShadowState& s) { s.shading(); }},
    {kMaterial | kLighting, [](ShadowState& s) { s.material(); }},
    {kFixedTextures, [](ShadowState& s) { s.fixedTextures(), s.textureReason(); }},
    {kClip, [](ShadowState& s) { s.clipPlanes(); }},
    {kProgram | kProgramTextures, [](ShadowState& s) { s.program(); }},
    {kFixedArrays, [](ShadowState& s) { s.arrays(); }},
    {kAttributes, [](ShadowState& s) { s.attributes(); }},
};

class ShadowStateTest : public ::testing::Test {
 protected:
  void create(bool core) {
    ContextInfo info;
    info.core = core;
    shadow_ = std::make_unique<ShadowState>(real_, beginEnd_, std::make_shared<ShareGroup>(), info, settings_,
                                            errors_, failsafe_);
    g_counting = {};
  }
  void SetUp() override { create(false); }
  /// Number of queries of state that reading takes.
  int queriesOf(const StateRead& one) {
    const int before = g_counting.queries;
    one.read(*shadow_);
    return g_counting.queries - before;
  }

  RealGl real_ = countingTable();
  BeginEnd beginEnd_;
  Errors errors_{real_, beginEnd_};
  Failsafe failsafe_{[] {}};
  Settings settings_;
  std::unique_ptr<ShadowState> shadow_;
};

TEST_F(ShadowStateTest, AsksOnceForEachTouch) {
  shadow_->refresh(kAllGroups);
  for (const StateRead& one : kStateReads) {
    EXPECT_EQ(queriesOf(one), 0) << one.groups << " is clean";
    for (uint32_t group = 1; group < kAllGroups; group <<= 1) {
      shadow_->touch(group);
      EXPECT_EQ(queriesOf(one) > 0, (one.groups & group) != 0) << one.groups << " touched by " << group;
      EXPECT_EQ(queriesOf(one), 0) << one.groups << " after " << group;
      shadow_->refresh(group);
    }
  }
}

TEST_F(ShadowStateTest, ReturnsWhatTheRealOpenGLHolds) {
  EXPECT_EQ(shadow_->viewport().box, glm::ivec4(0, 0, 300, 200));
  g_counting.width = 400;
  EXPECT_EQ(shadow_->viewport().box.z, 300) << "no call has touched it";
  shadow_->touch(kViewport);
  EXPECT_EQ(shadow_->viewportPixels(), 400 * 200);
  EXPECT_EQ(shadow_->viewport().box.z, 400);
  EXPECT_EQ(g_counting.asked[GL_VIEWPORT], 2);
}

TEST_F(ShadowStateTest, ReadsGroupsTogetherWhenADrawBegins) {
  shadow_->refresh(kDrawGroups);
  const int queries = g_counting.queries;
  EXPECT_EQ(g_counting.errorQueries, 2) << "one for the program's error, one for ours";
  EXPECT_EQ(shadow_->pixelState().viewport.box.z, 300);
  shadow_->shading(), shadow_->material(), shadow_->modelview(), shadow_->clipPlanes(), shadow_->rare();
  EXPECT_EQ(g_counting.queries, queries);
  EXPECT_EQ(g_counting.errorQueries, 2);
}

TEST_F(ShadowStateTest, RareStateIsAskedOnce) {
  EXPECT_TRUE(shadow_->rare().asked);
  const int queries = g_counting.queries;
  EXPECT_GT(queries, 0);
  shadow_->rare();
  EXPECT_EQ(g_counting.queries, queries);
}

TEST_F(ShadowStateTest, CoreProfilesAreNeverAskedForFixedFunction) {
  create(true);
  shadow_->refresh(kAllGroups);
  EXPECT_EQ(g_counting.asked.count(GL_MODELVIEW_MATRIX) + g_counting.asked.count(GL_LIGHTING) +
                g_counting.asked.count(GL_AMBIENT) + g_counting.asked.count(GL_MAX_CLIP_PLANES),
            0u);
  EXPECT_FALSE(shadow_->isDirty(kAllGroups));
  for (const StateRead& one : kStateReads) {
    shadow_->touch(kFixedFunction);
    EXPECT_EQ(queriesOf(one), 0) << one.groups;
  }
  EXPECT_EQ(shadow_->projection(), glm::dmat4(1));
  EXPECT_FALSE(shadow_->rare().fixedFunction);
}

TEST_F(ShadowStateTest, NothingIsAskedBetweenBeginAndEnd) {
  shadow_->refresh(kAllGroups);
  g_counting = {.width = 400};
  shadow_->touch(kAllGroups);
  beginEnd_.inside = BeginEnd::Inside::rasterised;
  for (const StateRead& one : kStateReads) EXPECT_EQ(queriesOf(one), 0) << one.groups;
  shadow_->refresh(kAllGroups);
  EXPECT_EQ(shadow_->viewport().box.z, 300);
  EXPECT_EQ(g_counting.queries + g_counting.errorQueries, 0);
  beginEnd_.inside = BeginEnd::Inside::captured;  // the real OpenGL is outside
  EXPECT_EQ(shadow_->viewport().box.z, 400);
}

TEST_F(ShadowStateTest, RareStateIsNotAskedBetweenBeginAndEnd) {
  beginEnd_.executed = BeginEnd::Inside::rasterised;
  EXPECT_FALSE(shadow_->rare().asked);
  EXPECT_EQ(g_counting.queries + g_counting.errorQueries, 0);
}

TEST_F(ShadowStateTest, ColoursChangeTheMaterialWithColorMaterial) {
  shadow_->refresh(kAllGroups);
  shadow_->colorSet();
  EXPECT_FALSE(shadow_->isDirty(kAllGroups)) << "it is off";
  g_counting = {.colorMaterial = true};
  shadow_->touch(kLighting);
  shadow_->colorSet();
  EXPECT_EQ(g_counting.queries, 0) << "colours are set between glBegin and glEnd, too";
  shadow_->material();
  EXPECT_EQ(g_counting.asked[GL_AMBIENT], 2) << "front and back, because lighting was dirty";
  shadow_->colorSet();
  EXPECT_TRUE(shadow_->isDirty(kMaterial)) << "the material did not have the colour";
}

TEST_F(ShadowStateTest, MaterialsThatHaveTheColourAreNotReadAgain) {
  g_counting = {.colorMaterial = true, .material = {1, 1, 1, 1}};  // the initial colour
  shadow_->refresh(kAllGroups);
  g_counting.queries = 0;
  const float red[4] = {1, 0, 0, 1};
  shadow_->current.keep(kColor, red), shadow_->colorSet();
  EXPECT_EQ(shadow_->material().front.diffuse, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(shadow_->material().back.diffuse, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(shadow_->material().front.ambient, glm::vec4(1));
  EXPECT_EQ(g_counting.queries, 0);
}

TEST_F(ShadowStateTest, MaterialsAreKnownWhileNoColourChangesThem) {
  MaterialChange change;
  const float red[4] = {1, 0, 0, 1};
  change.set(GL_FRONT, GL_EMISSION, red);
  shadow_->refresh(kAllGroups);
  shadow_->materialSet(change);
  EXPECT_TRUE(shadow_->isDirty(kMaterial)) << "without lighting it is unknown whether it follows the colour";
  g_counting = {.lighting = true};
  shadow_->touch(kLighting), shadow_->refresh(kAllGroups);
  g_counting.queries = 0;
  shadow_->materialSet(change);
  EXPECT_EQ(shadow_->material().front.emission, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(g_counting.queries, 0);
  g_counting.colorMaterial = true;
  shadow_->touch(kLighting), shadow_->refresh(kAllGroups);
  shadow_->materialSet(change);
  EXPECT_TRUE(shadow_->isDirty(kMaterial));
}

TEST_F(ShadowStateTest, ExpiredGroupsHoldUntilTheNextDraw) {
  shadow_->refresh(kProgramGroups);
  g_counting = {};
  shadow_->expire(kProgram);
  EXPECT_TRUE(shadow_->isDirty(kProgram));
  shadow_->program();
  EXPECT_EQ(g_counting.queries, 0);
  shadow_->refresh(kProgramGroups);
  EXPECT_EQ(g_counting.asked[GL_CURRENT_PROGRAM], 1);
  shadow_->refresh(kProgramGroups);
  EXPECT_EQ(g_counting.asked[GL_CURRENT_PROGRAM], 1);
}

TEST_F(ShadowStateTest, ReadingAgainAfterAFailureWaitsForTheNextDraw) {
  shadow_->refresh(kAllGroups);
  g_counting = {.width = 400, .fails = true};
  shadow_->touch(kViewport);
  EXPECT_EQ(shadow_->viewport().box.z, 300);
  EXPECT_TRUE(failsafe_.aside());
  g_counting.fails = false;
  EXPECT_EQ(shadow_->viewport().box.z, 300);
  shadow_->refresh(kViewport);
  EXPECT_EQ(shadow_->viewport().box.z, 400);
}

TEST_F(ShadowStateTest, TellsWhatWasReadBack) {
  shadow_->refresh(kAllGroups);
  shadow_->forgetReadBack(kViewport | kTarget);
  EXPECT_FALSE(shadow_->wasReadBack(kViewport | kTarget));
  EXPECT_TRUE(shadow_->wasReadBack(kRaster));
  shadow_->touch(kTarget);
  EXPECT_FALSE(shadow_->wasReadBack(kTarget)) << "not yet";
  shadow_->target();
  EXPECT_TRUE(shadow_->wasReadBack(kTarget));
  EXPECT_FALSE(shadow_->wasReadBack(kViewport));
}

}  // namespace
}  // namespace gluray::gl
