// Programs that differ from VTK's in one statement of main, as when users replace parts of VTK's
// shaders: removed, repeated, changed, or exchanged with the next one. The image must show the change,
// traced or not.
#include "tests/reference/programs/program_mutants.h"

#include <gtest/gtest.h>

namespace gluray::test {
namespace {

using Color = Surface::Color;
using Normals = Surface::Normals;
using Lights = Surface::Lights;

struct MutantCase {
  const char* name;
  Surface surface;
};
void PrintTo(const MutantCase& c, std::ostream* out) { *out << c.name; }

const MutantCase kMutantCases[] = {
    {"headlight", {.lights = Lights::headlight}},
    {"positional", {.lights = Lights::positional, .lightCount = 2}},
    {"mapped", {.color = Color::mapped, .actorTexture = true, .colorTcoord = true, .tcoordMatrix = true}},
    {"pbr", {.lights = Lights::pbr}},
};
/// Label `program`: scripts/test --all.
const MutantCase kMoreCases[] = {
    {"unlit", {.lights = Lights::none}},
    {"recent_unlit", {.color = Color::mapped, .lights = Lights::none, .recent = true}},
    {"recent_unlit_base_texture", {.lights = Lights::none, .recent = true, .baseTexture = true}},
    {"directional", {.color = Color::vertex, .lightCount = 2}},
    {"cells", {.color = Color::cell, .normals = Normals::cell}},
    {"triangle_normals", {.normals = Normals::triangle}},
    {"back_material_clipped", {.backMaterial = true, .clipPlanes = true}},
    {"depth_offset", {.depthOffset = true}},
    {"pbr_headlight", {.lights = Lights::pbrHeadlight}},
};

/// A bowl: both sides of its triangles are visible.
ProgramMesh bowl() {
  ProgramMesh mesh = ball(12);
  mesh.indices.resize(mesh.indices.size() / 6 * 3);
  return mesh;
}

void setSurface(Gl gl, GLuint program, const ProgramMesh& mesh, const Surface& surface) {
  if (surface.color == Color::cell) cellColors(gl, mesh, 1), setInteger(gl, program, "textureC", 1);
  if (surface.normals == Normals::cell) cellNormals(gl, mesh, 2), setInteger(gl, program, "textureN", 2);
  if (surface.color == Color::mapped) colorMap(gl, 3), setInteger(gl, program, "colortexture", 3);
  if (surface.actorTexture) chequers(gl, 4), setInteger(gl, program, "actortexture", 4);
  if (surface.baseTexture) chequers(gl, 4), setInteger(gl, program, "albedoTex", 4);
  setAll(gl, program, perspectiveView(25), surface);
  setMat4(gl, program, "tcMatrix",
          glm::mat4(0.9f, 0.8f, 0, 0, -1.1f, 1.3f, 0, 0, 0, 0, 1, 0, 0.6f, -0.2f, 0, 2));
  const glm::vec4 planes[] = {{0.8f, 0.3f, 0.5f, 0.4f}, {-0.3f, 0.9f, 0, 0.6f}};
  gl.Uniform4fv(gl.GetUniformLocation(program, "clipPlanes"), 2, &planes[0].x);
  setInteger(gl, program, "numClipPlanes", 2);
  setFloat(gl, program, "cOffset", 200);
}

class ProgramMutants : public testing::TestWithParam<MutantCase> {};

TEST_P(ProgramMutants, AreNotTakenForTheOriginal) {
  const Surface& surface = GetParam().surface;
  expectMutantsSeen(GetParam().name,
                    {{GL_VERTEX_SHADER, vertexText(surface)}, {GL_FRAGMENT_SHADER, fragmentText(surface)}},
                    [&](Gl gl, GLuint program) {
                      const ProgramMesh mesh = bowl();
                      const Upload up = upload(gl, mesh, program);
                      beginFrame(gl);
                      gl.UseProgram(program);
                      setSurface(gl, program, mesh, surface);
                      gl.BindVertexArray(up.array);
                      gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
                    });
}

INSTANTIATE_TEST_SUITE_P(Cases, ProgramMutants, testing::ValuesIn(kMutantCases),
                         [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(MoreCases, ProgramMutants, testing::ValuesIn(kMoreCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
