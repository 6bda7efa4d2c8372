#include "intercept/present/tracing_presenter.h"
#include "tests/reference/programs/program_stage.h"
#include "tests/support/gl_state.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace gluray::test {
namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  return all;
}

/// The state that the program sees, without object names, which differ because GLuRay makes objects, too.
GlState withoutNames(GlState state) {
  std::erase_if(state, [](const auto& entry) {
    const std::string& name = entry.first;
    return name.find("BINDING") != std::string::npos || name == "CURRENT_PROGRAM" || name.ends_with(" 34975");
  });
  return state;
}

/// Image, errors and state after a program's draws.
struct DrawnResult {
  DrawnImage image;
  GlState state;
  GLenum error = GL_NO_ERROR;
};

/// Records errors and state, then the image. Pending draws must not change the former.
DrawnResult drawn(Gl gl, const DrawProgram& draw, const ContextWish& wish) {
  DrawnResult result;
  draw(gl);
  result.error = gl.GetError();
  const GlState before = queryState(gl);
  gl.Finish();
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
  result.state = queryState(gl);
  EXPECT_EQ(joined(differences(before, result.state)), "") << "state, by showing what was pending";
  result.state = withoutNames(std::move(result.state));
  result.image = readImage(gl, wish.width, wish.height);
  return result;
}

DrawnResult drawnByRealOpenGl(const DrawProgram& draw, const ContextWish& wish) {
  const auto real = OsmesaContext::create(wish);
  return drawn(real->real(), draw, wish);
}

ContextWish orCore(const ContextWish& wish) { return wish.width == 64 ? coreWish() : wish; }

/// Expects the real OpenGL's image within `tolerance`, and the same errors and state.
void expectLike(const DrawnResult& expected, const DrawnResult& got, const scenes::Tolerance& tolerance,
                const std::string& file) {
  EXPECT_EQ(got.error, expected.error);
  EXPECT_EQ(joined(differences(expected.state, got.state)), "");
  const Comparison c = compare(expected.image, got.image, tolerance);
  EXPECT_TRUE(c.accepted) << c.text;
  std::printf("%s: %s", file.c_str(), c.text.c_str());
  if (!c.accepted) writeFailure(TEST_OUTPUT, file, expected.image, got.image);
}

std::string reasons(const gl::Statistics& s) {
  std::string text;
  for (int i = 0; i < gl::kReasonCount; ++i)
    if (s.rasterisedBecause[static_cast<size_t>(i)])
      text += std::string(gl::describe(static_cast<gl::Reason>(i))) + "; ";
  return text;
}

std::shared_ptr<const gl::FamilyList> parsed(const std::string& families) {
  if (families.empty()) return familiesOfTests();
  return std::make_shared<const gl::FamilyList>(gl::parseFamilies(families, "test.toml"));
}

Outcome traced(const DrawnResult& expected, const std::string& name, const DrawProgram& draw, int draws,
               const ContextWish& wish, const scenes::Tolerance& tolerance, const std::string& families) {
  TracedContext ours(wish, TracedContext::tracing(), nullptr, nullptr, parsed(families));
  const DrawnResult got = drawn(ours.gl(), draw, wish);
  const gl::Statistics& s = ours.context().counts.statistics;
  expectLike(expected, got, tolerance, "program-" + name);
  if (draws >= 0) { EXPECT_EQ(s.drawsTraced, static_cast<uint64_t>(draws)) << reasons(s); }
  std::printf("; %d traced, %d rasterised %s\n", static_cast<int>(s.drawsTraced),
              static_cast<int>(s.drawsRasterised), reasons(s).c_str());
  return {s, expected.image, got.image};
}

void drawnAgain(const DrawnResult& expected, const std::string& name, const DrawProgram& draw,
                const ContextWish& wish, const std::string& families) {
  auto fails = std::make_unique<present::TracingPresenter>(
      frame::Tracer{[](const scene::Snapshot&, Image&, scene::TraceCost&, std::string& why) {
        return why = "this test lets tracing fail", false;
      }});
  TracedContext ours(wish, TracedContext::tracing(), std::move(fails), nullptr, parsed(families));
  const DrawnResult got = drawn(ours.gl(), draw, wish);
  expectLike(expected, got, {0, 0, 0, "the same draws by the same OpenGL"}, "program-failing-" + name);
  std::printf("\n");
}

}  // namespace

Outcome expectSame(const std::string& name, const DrawProgram& draw, int draws, ContextWish wish,
                   const scenes::Tolerance& tolerance, const std::string& families) {
  wish = orCore(wish);
  return traced(drawnByRealOpenGl(draw, wish), name, draw, draws, wish, tolerance, families);
}

void expectSameWhenTracingFails(const std::string& name, const DrawProgram& draw, ContextWish wish,
                                const std::string& families) {
  wish = orCore(wish);
  drawnAgain(drawnByRealOpenGl(draw, wish), name, draw, wish, families);
}

void expectBoth(const std::string& name, const DrawProgram& draw, int draws, const ContextWish& given,
                const scenes::Tolerance& tolerance, const std::string& families) {
  const ContextWish wish = orCore(given);
  const DrawnResult expected = drawnByRealOpenGl(draw, wish);
  traced(expected, name, draw, draws, wish, tolerance, families);
  drawnAgain(expected, name, draw, wish, families);
}

}  // namespace gluray::test
