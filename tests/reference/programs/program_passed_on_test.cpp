// Surfaces whose triangles a geometry shader passes on, as f3d 4 does for colours of cells.
#include "tests/reference/programs/program_mutants.h"

#include <gtest/gtest.h>

namespace gluray::test {
namespace {

using Color = Surface::Color;
using Lights = Surface::Lights;
using Normals = Surface::Normals;

const char* const kPassingOn =
    "#version 150\nin vec4 vertexVCVSOutput[];\nout vec4 vertexVCGSOutput;\n"
    "layout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\nconst int VERT_COUNT = 3;\n"
    "void main()\n{\n  for (int i = 0; i < VERT_COUNT; i++)\n  {\n    gl_PrimitiveID = gl_PrimitiveIDIn;\n"
    "    vertexVCGSOutput = vertexVCVSOutput[i];\n    gl_Position = gl_in[i].gl_Position;\n    "
    "EmitVertex();\n"
    "  }\n  EndPrimitive();\n}\n";

struct PassedOnCase {
  const char* name;
  Surface surface;
};
void PrintTo(const PassedOnCase& c, std::ostream* out) { *out << c.name; }

const PassedOnCase kCases[] = {
    {"lit", {.color = Color::cell, .normals = Normals::triangle, .lightCount = 2}},
    {"pbr", {.color = Color::cell, .normals = Normals::triangle, .lights = Lights::pbr, .recent = true}},
    {"unlit", {.color = Color::cell, .normals = Normals::triangle, .lights = Lights::none, .recent = true}},
};

ShaderTexts textsOf(const Surface& surface) {
  std::string fragment = fragmentText(surface);
  for (size_t at = 0; (at = fragment.find("VCVSOutput", at)) != std::string::npos; at += 10)
    fragment.replace(at, 10, "VCGSOutput");
  return {{GL_VERTEX_SHADER, vertexText(surface)},
          {GL_GEOMETRY_SHADER, kPassingOn},
          {GL_FRAGMENT_SHADER, fragment}};
}

void drawPassedOn(Gl gl, GLuint program, const Surface& surface) {
  const ProgramMesh mesh = ball(12);
  const Upload up = upload(gl, mesh, program);
  beginFrame(gl);
  gl.UseProgram(program);
  cellColors(gl, mesh, 1), setInteger(gl, program, "textureC", 1);
  setAll(gl, program, perspectiveView(25), surface);
  gl.BindVertexArray(up.array);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

class PassedOn : public testing::TestWithParam<PassedOnCase> {};

TEST_P(PassedOn, LooksLikeTheRealOne) {
  const Surface& surface = GetParam().surface;
  expectBoth(
      GetParam().name, [&](Gl gl) { drawPassedOn(gl, linked(gl, textsOf(surface)), surface); }, 1);
}

INSTANTIATE_TEST_SUITE_P(Cases, PassedOn, testing::ValuesIn(kCases),
                         [](const auto& info) { return std::string(info.param.name); });

class PassedOnMutants : public testing::TestWithParam<PassedOnCase> {};

TEST_P(PassedOnMutants, AreNotTakenForTheOriginal) {
  const Surface& surface = GetParam().surface;
  expectMutantsSeen(GetParam().name, textsOf(surface),
                    [&](Gl gl, GLuint program) { drawPassedOn(gl, program, surface); });
}

INSTANTIATE_TEST_SUITE_P(MoreCases, PassedOnMutants, testing::Values(kCases[1]),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
