// Lines that a geometry shader makes rectangles of (lines.size of family files): as tubes, and as they are.
#include "tests/reference/programs/impostors/own_impostors.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::test {
namespace {

const char* const kLineVertex =
    "#version 150\nin vec3 place, paint; uniform mat4 projection, modelview; out vec3 tint;\n"
    "void main() { tint = paint; gl_Position = projection * modelview * vec4(place, 1); }\n";
const char* const kLineGeometry =
    "#version 150\nlayout(lines) in; layout(triangle_strip, max_vertices = 4) out;\n"
    "in vec3 tint[]; uniform vec2 wide; out vec3 color;\n"
    "void main() { vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;\n"
    "  vec2 d = normalize(b.xy / b.w - a.xy / a.w), n = vec2(-d.y, d.x);\n"
    "  for (int j = 0; j < 4; ++j) { vec4 p = gl_in[j / 2].gl_Position; color = tint[j / 2];\n"
    "    p.xy += (j % 2 - 0.5) * wide * n * p.w; gl_Position = p; EmitVertex(); } }\n";
const char* const kLineFragment =
    "#version 150\nin vec3 color; out vec4 pixel; void main() { pixel = vec4(color, 1); }\n";
// The same without a geometry shader.
const char* const kThinFragment =
    "#version 150\nin vec3 tint; out vec4 pixel; void main() { pixel = vec4(tint, 1); }\n";

const std::string kUnlitLines =
    "[[family]]\nname = \"thin\"\nmatch.active = [\"place\", \"modelview\", \"projection\"]\n"
    "vertex.position = \"place\"\nvertex.color = \"paint\"\nlights.model = \"unlit\"\n"
    "transform.clip_from_object = [\"projection\", \"modelview\"]\n"
    "transform.eye_from_object = \"modelview\"\nnormals.without = \"triangle\"\n"
    "material.diffuse_intensity = 0\nmaterial.ambient_intensity = 1\n"
    "[[family]]\nname = \"wide\"\ninherits = \"thin\"\nmatch.geometry_shader = true\n"
    "match.only_lines_and_points = true\nlines.size = \"wide\"\n";

void drawLinesOf(Gl gl, bool wide, float pixels, int viewport = kProgramWidth) {
  const GLuint program =
      linkImpostors(gl, kLineVertex, wide ? kLineGeometry : "", wide ? kLineFragment : kThinFragment);
  placeImpostors(gl, program);
  beginFrame(gl);
  gl.UseProgram(program);
  lookAtImpostors(gl, program, perspectiveView(35), false);
  gl.Uniform2f(gl.GetUniformLocation(program, "wide"), 2 * pixels / kProgramWidth,
               2 * pixels / kProgramHeight);
  gl.Viewport(0, 0, viewport, viewport * kProgramHeight / kProgramWidth);
  gl.DrawArrays(GL_LINES, 4, kImpostors - 4);
}

/// What GLuRay draws while lines are tubes.
Outcome asTubesOf(float width, const DrawProgram& draw) {
  Settings settings = TracedContext::tracing();
  settings.lines.look = LineLook::tubes, settings.lines.width = width;
  const auto families = std::make_shared<const gl::FamilyList>(gl::parseFamilies(kUnlitLines, "lines.toml"));
  const TracedContext traced(coreWish(), settings, nullptr, nullptr, families);
  draw(traced.gl());
  Outcome outcome;
  outcome.got = traced.read();
  outcome.statistics = traced.context().counts.statistics;
  return outcome;
}

TEST(ProgramWideLines, AreTheTubesOfThinLinesOfThatWidth) {
  for (const float width : {2.0f, 7.0f, 20.0f}) {
    SCOPED_TRACE(width);
    const Outcome wide = asTubesOf(0, [&](Gl gl) { drawLinesOf(gl, true, width); }),
                  thin = asTubesOf(width, [&](Gl gl) { drawLinesOf(gl, false, 1); });
    EXPECT_EQ(wide.statistics.drawsTraced, 1u);
    EXPECT_EQ(thin.statistics.drawsTraced, 1u);
    EXPECT_EQ(wide.got.colors, thin.got.colors);
    EXPECT_EQ(wide.got.depths, thin.got.depths);
  }
}

TEST(ProgramWideLines, HaveTheSettingsWidthIfThereIsOne) {
  const Outcome wide = asTubesOf(5, [](Gl gl) { drawLinesOf(gl, true, 9); }),
                thin = asTubesOf(5, [](Gl gl) { drawLinesOf(gl, false, 1); });
  EXPECT_EQ(wide.got.colors, thin.got.colors);
}

TEST(ProgramWideLines, AreAsWideInTheViewportAsTheirProgramMakesThem) {
  const Outcome wide = asTubesOf(0, [](Gl gl) { drawLinesOf(gl, true, 10, kProgramWidth / 2); }),
                thin = asTubesOf(5, [](Gl gl) { drawLinesOf(gl, false, 1, kProgramWidth / 2); });
  EXPECT_EQ(wide.statistics.drawsTraced, 1u);
  EXPECT_EQ(wide.got.colors, thin.got.colors);
  EXPECT_EQ(wide.got.depths, thin.got.depths);
}

TEST(ProgramWideLines, AreLeftToTheRealOpenGlOtherwise) {
  const Outcome outcome = expectSame(
      "wide_lines_off", [](Gl gl) { drawLinesOf(gl, true, 7); }, 0, coreWish(), kProgramTolerance,
      kUnlitLines);
  EXPECT_EQ(outcome.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::lines)], 1u);
}

}  // namespace
}  // namespace gluray::test
