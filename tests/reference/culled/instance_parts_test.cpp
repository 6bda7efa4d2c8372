// A draw of instances made in parts by the real OpenGL has the image of the whole draw to the bit, with a
// base instance, with vertex buffer bindings, and without both. State is as before.
#include "gl/arrays/signed_fractions.h"
#include "gl/culled/instances/instance_draws.h"
#include "gl/program_state/program_state.h"
#include "gl/sharing/share_group.h"
#include "tests/reference/culled/swarm.h"
#include "tests/support/osmesa_context.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace gluray::test {
namespace {

using namespace culled;

/// What an OpenGL lacks.
struct Older {
  bool baseInstance = false, bindings = false;
};

gl::RealGl without(const Older& older, gl::RealGl real) {
  const auto missing = [](auto& command) {
    command = reinterpret_cast<std::remove_reference_t<decltype(command)>>(gl::missingCommand());
  };
  if (older.baseInstance) missing(real.DrawArraysInstancedBaseInstance);
  if (older.bindings) missing(real.BindVertexBuffer);
  return real;
}

/// Divisors of the places and of the colours.
struct Rates {
  GLuint places = 1, tints = 1;
};

/// With a vertex array object, or with the default one (true).
class InstanceParts : public ::testing::TestWithParam<bool> {
 protected:
  InstanceParts()
      : context_(OsmesaContext::create(GetParam() ? ContextWish{kSide, kSide}
                                                  : ContextWish{kSide, kSide, true, 3, 3})) {
    gl::RealGl real = context_->real();
    if (GetParam())
      real.BindVertexArray = reinterpret_cast<decltype(real.BindVertexArray)>(gl::missingCommand());
    program_ = makeProgram(real, vertexOf(kPlacings[0]), tintedFragment());
    send(real, mesh_, program_);
  }
  void sendPlaces(const Rates& rates) {
    const gl::RealGl& real = context_->real();
    sendSwarm(real, program_, swarm_, rates.places);
    real.VertexAttribDivisor(static_cast<GLuint>(real.GetAttribLocation(program_, "tint")), rates.tints);
    real.BindBuffer(GL_ARRAY_BUFFER, 0);
  }
  void begin() {
    clear(context_->real());
    context_->real().UseProgram(program_);
    turn(context_->real(), program_, 1);
  }
  gl::Elements whole() const { return {0, mesh_.count(), GL_UNSIGNED_INT, nullptr, 0, countOf(swarm_) - 3}; }
  DrawnImage image() const { return readImage(context_->real(), kSide, kSide); }

  /// Draws all instances in runs of random lengths.
  void drawParts(const gl::RealGl& real, unsigned seed) {
    gl::ShareGroup group;
    gl::ArrayState arrays;
    gl::readAttributes(real, group, nullptr, arrays);
    std::optional<gl::InstanceUnits> units;
    ASSERT_EQ(gl::findUnits(real, arrays, whole(), units), gl::CullReason::culled);
    std::mt19937 random(seed);
    size_t parts = 0;
    for (uint32_t first = 0; first < units->units();) {
      const uint32_t end = std::min(units->units(), first + 1 + static_cast<uint32_t>(random() % 6));
      std::vector<uint64_t> run((units->units() + 63) / 64);
      for (; first < end; ++first) run[first / 64] |= uint64_t{1} << (first & 63);
      gl::InstanceDraws draws(real, arrays, *units);
      units->forParts(run, [&](const gl::InstancePart& part) {
        gl::drawReal(real, GL_TRIANGLES, draws.elementsOf(whole(), part)), ++parts;
      });
    }
    EXPECT_GT(parts, units->units() / 6);
  }

  std::unique_ptr<OsmesaContext> context_;
  GLuint program_ = 0;
  const ProgramMesh mesh_ = ball(8);
  Swarm swarm_ = swarm(5);
};

TEST_P(InstanceParts, AreTheWholeDraw) {
  for (const Rates& rates : {Rates{1, 1}, Rates{2, 2}, Rates{1, 3}, Rates{4, 6}, Rates{1, 1000}}) {
    sendPlaces(rates);
    begin();
    gl::drawReal(context_->real(), GL_TRIANGLES, whole());
    const DrawnImage expected = image();
    EXPECT_GT(std::ranges::count_if(expected.depths, [](float depth) { return depth < 1; }), 5000);
    for (const Older& older : {Older{}, Older{true, false}, Older{true, true}, Older{false, true}}) {
      SCOPED_TRACE(std::to_string(rates.places) + " " + std::to_string(rates.tints) +
                   (older.baseInstance ? " no base instance" : "") + (older.bindings ? " no bindings" : ""));
      const gl::RealGl real = without(older, context_->real());
      begin();
      const GlState before = queryState(context_->real());
      drawParts(real, rates.tints);
      for (const std::string& line : differences(before, queryState(context_->real()))) ADD_FAILURE() << line;
      const DrawnImage got = image();
      EXPECT_TRUE(got.colors == expected.colors && got.depths == expected.depths)
          << whereDifferent(expected, got);
      EXPECT_EQ(context_->real().GetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
  }
}

/// Arrays that end before the draw does, that are in memory, or of types that are not read.
TEST_P(InstanceParts, AreNotMadeWhereArraysCannotBeginLater) {
  const gl::RealGl& real = context_->real();
  const gl::RealGl older = without({true, false}, real);
  const auto reasonOf = [&](const gl::RealGl& by, GLsizei instances) {
    gl::ShareGroup group;
    gl::ArrayState arrays;
    gl::readAttributes(real, group, nullptr, arrays);
    gl::Elements all = whole();
    all.instances = instances;
    std::optional<gl::InstanceUnits> units;
    return gl::findUnits(by, arrays, all, units);
  };
  sendPlaces({1, 1});
  EXPECT_EQ(reasonOf(older, countOf(swarm_)), gl::CullReason::culled);
  EXPECT_EQ(reasonOf(older, countOf(swarm_) + 1), gl::CullReason::instanceArrays);
  EXPECT_EQ(reasonOf(real, countOf(swarm_) + 1), gl::CullReason::culled);
  const auto tint = static_cast<GLuint>(real.GetAttribLocation(program_, "tint"));
  GLuint packed = 0;
  real.GenBuffers(1, &packed), real.BindBuffer(GL_ARRAY_BUFFER, packed);
  real.BufferData(GL_ARRAY_BUFFER, 4 * countOf(swarm_), nullptr, GL_STATIC_DRAW);
  real.VertexAttribPointer(tint, 4, GL_INT_2_10_10_10_REV, GL_TRUE, 0, nullptr);
  EXPECT_EQ(reasonOf(older, countOf(swarm_)), gl::CullReason::instanceArrays);
  EXPECT_EQ(reasonOf(real, countOf(swarm_)), gl::CullReason::culled);
}

INSTANTIATE_TEST_SUITE_P(Arrays, InstanceParts, ::testing::Bool());

/// The real OpenGL of the tests has GL 4.2's rule; state and errors stay as they are.
TEST(SignedFractions, AreThoseOfTheRealOpenGl) {
  for (const ContextWish& wish : {ContextWish{kSide, kSide, true, 3, 3}, ContextWish{kSide, kSide}}) {
    const auto context = OsmesaContext::create(wish);
    const gl::RealGl& real = context->real();
    const GlState before = queryState(real);
    gl::SignedFractions fractions;
    EXPECT_TRUE(fractions.areSymmetric(real, wish.core));
    for (const std::string& line : differences(before, queryState(real))) ADD_FAILURE() << line;
    EXPECT_EQ(real.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    gl::RealGl older = real;
    older.BindTransformFeedback =
        reinterpret_cast<decltype(older.BindTransformFeedback)>(gl::missingCommand());
    gl::SignedFractions unknown;
    EXPECT_FALSE(unknown.areSymmetric(older, wish.core));
  }
}

}  // namespace
}  // namespace gluray::test
