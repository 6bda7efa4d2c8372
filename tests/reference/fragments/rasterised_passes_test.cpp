// Surfaces whose first pass is rasterised, for any reason, and whose second pass could be traced: the second
// meets the depth of the first to the bit, so it is rasterised, too.
#include "tests/reference/both.h"
#include "tests/reference/programs/built_in/built_in_stage.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::test {
namespace {

/// State of a first pass that rules out tracing and leaves depth.
struct FirstPass {
  const char* name;
  void (*begin)(Gl gl);
  void (*end)(Gl gl);
  bool remembered = false;  // as one pass of several, whatever was traced before
};
void PrintTo(const FirstPass& pass, std::ostream* out) { *out << pass.name; }

void stipple(Gl gl) {
  std::vector<GLubyte> halftone(128);
  for (size_t i = 0; i < halftone.size(); ++i) halftone[i] = i / 4 % 2 ? 0xaa : 0x55;
  gl.PolygonStipple(halftone.data()), gl.Enable(GL_POLYGON_STIPPLE);
}

void mark(Gl gl) {
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilFunc(GL_ALWAYS, 1, 0xff), gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
}

void countSamples(Gl gl) {
  GLuint query = 0;
  gl.GenQueries(1, &query), gl.BeginQuery(GL_SAMPLES_PASSED, query);
}

/// Of no family: stripes on the surface that fixed function draws.
void useStripes(Gl gl) {
  gl.UseProgram(makeProgram(
      gl, "#version 120\nvarying float x;\nvoid main() { x = gl_Vertex.x; gl_Position = ftransform(); }",
      "#version 120\nvarying float x;\n"
      "void main() { gl_FragColor = vec4(fract(8.0 * x), 0.5, 0.2, 1.0); }"));
}

const FirstPass kFirstPasses[] = {
    {"stencil", mark, [](Gl gl) { gl.Disable(GL_STENCIL_TEST); }},
    {"stipple", stipple, [](Gl gl) { gl.Disable(GL_POLYGON_STIPPLE); }},
    {"logic_op", [](Gl gl) { gl.Enable(GL_COLOR_LOGIC_OP), gl.LogicOp(GL_XOR); },
     [](Gl gl) { gl.Disable(GL_COLOR_LOGIC_OP); }},
    {"always", [](Gl gl) { gl.DepthFunc(GL_ALWAYS); }, [](Gl) {}},
    {"coverage", [](Gl gl) { gl.Enable(GL_SAMPLE_COVERAGE); }, [](Gl gl) { gl.Disable(GL_SAMPLE_COVERAGE); }},
    {"outlines", [](Gl gl) { gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE); },
     [](Gl gl) { gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL); }},
    {"query", countSamples, [](Gl gl) { gl.EndQuery(GL_SAMPLES_PASSED); }},
    {"draw_buffer", [](Gl gl) { gl.DrawBuffer(GL_NONE); }, [](Gl gl) { gl.DrawBuffer(GL_BACK); }},
    {"color_mask", [](Gl gl) { gl.ColorMask(0, 0, 0, 0); }, [](Gl gl) { gl.ColorMask(1, 1, 1, 1); }, true},
    {"depth_clamp", [](Gl gl) { gl.Enable(GL_DEPTH_CLAMP); }, [](Gl gl) { gl.Disable(GL_DEPTH_CLAMP); }},
    {"program", useStripes, [](Gl gl) { gl.UseProgram(0); }},
};

class RasterisedPasses : public testing::TestWithParam<FirstPass> {};

/// A surface in two passes; and, under the same matrix and under another one, surfaces in one pass.
void drawPasses(Gl gl, const FirstPass& first, Way way, GLenum depthFunc) {
  const ProgramMesh round = ball(20), wavy = sheet(12), small = ball(12);
  gl.Color4f(1, 0.2f, 0.1f, 1);
  first.begin(gl);
  sendMesh(gl, round, way, false);
  first.end(gl);
  gl.DepthFunc(depthFunc);
  gl.Color4f(0.1f, 0.4f, 1, 1), sendMesh(gl, round, way, false);
  gl.PushMatrix(), gl.PopMatrix();  // ends the run of surfaces that are sent together
  gl.Color4f(0.3f, 0.9f, 0.3f, 1), sendMesh(gl, wavy, way, false);
  gl.Translatef(0.3f, 0, 0.9f), gl.Scalef(0.3f, 0.3f, 0.3f);
  gl.Color4f(0.9f, 0.9f, 0.2f, 1), sendMesh(gl, small, way, false);
  gl.DepthFunc(GL_LESS);
}

TEST_P(RasterisedPasses, KeepSecondPassesFromBeingTraced) {
  const FirstPass& first = GetParam();
  const BothStage stage{kProgramWidth, kProgramHeight, "rasterised-passes",
                        [](Gl gl) { beginBuiltInFrame(gl); }};
  for (const Way way : {Way::immediate, Way::list, Way::clientArrays, Way::clientElements, Way::buffers})
    for (const GLenum depthFunc : {GL_LESS, GL_LEQUAL}) {
      const std::string name =
          std::string(first.name) + "-" + nameOf(way) + (depthFunc == GL_LESS ? "-less" : "-less-or-equal");
      const gl::Statistics counts =
          compareBoth(stage, name, [&](Gl gl) { drawPasses(gl, first, way, depthFunc); });
      EXPECT_EQ(counts.drawsTraced, 2u) << name;
    }
}

/// Where nothing could be traced for long, vertices of what is rasterised are not looked at: in the first
/// frame with a second pass everything is rasterised, and in the next one only passes are.
TEST_P(RasterisedPasses, AreFoundAfterManyFramesWithoutTracedSurfaces) {
  const FirstPass& first = GetParam();
  const BothStage stage{kProgramWidth, kProgramHeight, "rasterised-passes", [](Gl) {}};
  for (const Way way : {Way::immediate, Way::list, Way::clientArrays})
    for (const bool again : {false, true}) {
      const std::string name =
          std::string(first.name) + "-" + nameOf(way) + "-later" + (again ? "-again" : "");
      const gl::Statistics counts = compareBoth(stage, name, [&](Gl gl) {
        const ProgramMesh round = ball(4);
        for (int frame = 0; frame < 110; ++frame) {
          beginBuiltInFrame(gl);
          first.begin(gl);
          sendMesh(gl, round, way, false);
          first.end(gl);
          gl.DepthFunc(GL_LESS);
        }
        for (int frame = 0; frame <= again; ++frame) {
          beginBuiltInFrame(gl);
          drawPasses(gl, first, way, GL_LEQUAL);
        }
      });
      EXPECT_EQ(counts.drawsTraced, (again ? 2u : 0u) + (first.remembered ? 2u : 0u)) << name;
    }
}

/// One pass over half of a surface, in either order.
TEST_P(RasterisedPasses, OverPartsOfSurfacesAreFound) {
  const FirstPass& first = GetParam();
  const BothStage stage{kProgramWidth, kProgramHeight, "rasterised-passes",
                        [](Gl gl) { beginBuiltInFrame(gl); }};
  const ProgramMesh whole = ball(20);
  ProgramMesh half = whole;
  half.indices.resize(whole.indices.size() / 6 * 3);
  for (const Way way : {Way::immediate, Way::list, Way::clientElements})
    for (const bool halfFirst : {false, true}) {
      const std::string name = std::string(first.name) + "-" + nameOf(way) + (halfFirst ? "-half" : "-whole");
      const gl::Statistics counts = compareBoth(stage, name, [&](Gl gl) {
        gl.Color4f(1, 0.2f, 0.1f, 1);
        first.begin(gl);
        sendMesh(gl, halfFirst ? half : whole, way, false);
        first.end(gl);
        gl.DepthFunc(GL_LEQUAL);
        gl.Color4f(0.1f, 0.4f, 1, 1), sendMesh(gl, halfFirst ? whole : half, way, false);
      });
      EXPECT_EQ(counts.drawsTraced, 0u) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(Reasons, RasterisedPasses, testing::ValuesIn(kFirstPasses),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
