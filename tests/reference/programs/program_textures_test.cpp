// Textures that VTK's programs put only on front faces.
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

namespace gluray::test {
namespace {

/// With VTK's words for it.
GLuint makeTextured(Gl gl, const Surface& surface) {
  std::string text = fragmentText(surface);
  const std::string always =
      "  fragOutput0 = fragOutput0 * vec4(texture(actortexture, tcoordVCVSOutput).rgb, 1.0);\n";
  const size_t at = text.find(always);
  EXPECT_NE(at, std::string::npos);
  text.replace(at, always.size(),
               "  vec4 tcolor_0 = texture(actortexture, tcoordVCVSOutput);\n"
               "  tcolor_0 = vec4(tcolor_0.r, tcolor_0.g, tcolor_0.b, 1.0);\n  vec4 tcolor = tcolor_0;\n"
               "  if (gl_FrontFacing == true || showTexturesOnBackface) {\n"
               "    fragOutput0 = fragOutput0 * tcolor; }\n");
  text.insert(text.find("void main()"), "uniform bool showTexturesOnBackface;\n");
  return makeProgram(gl, vertexText(surface), text);
}

struct Textured {
  int onBack = 0;
  GLenum frontFace = GL_CCW;
  Surface surface = {.lightCount = 2, .actorTexture = true};
};

/// A ball cut open by the near plane.
void drawTextured(Gl gl, const Textured& t) {
  const ProgramMesh mesh = ball(24);
  const GLuint program = makeTextured(gl, t.surface);
  upload(gl, mesh, program);
  beginFrame(gl);
  gl.FrontFace(t.frontFace);
  gl.UseProgram(program);
  View view = perspectiveView(25);
  view.eyeFromObject[3].z += 2.4;
  setAll(gl, program, view, t.surface);
  chequers(gl, 4), setInteger(gl, program, "actortexture", 4);
  setInteger(gl, program, "showTexturesOnBackface", t.onBack);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
  gl.FrontFace(GL_CCW);
}

TEST(ProgramTextures, AreOnFrontFacesAlone) {
  for (const GLenum face : {GL_CCW, GL_CW})
    expectBoth(
        "textures_in_front", [&](Gl gl) { drawTextured(gl, {.frontFace = face}); }, 1);
}

TEST(ProgramTextures, AreOnBothFaces) {
  for (const GLenum face : {GL_CCW, GL_CW})
    expectBoth(
        "textures_on_both",
        [&](Gl gl) {
          drawTextured(gl, {1, face});
        },
        1);
}

TEST(ProgramTextures, OfBackFacesWithAMaterialOfTheirOwn) {
  for (const int onBack : {0, 1}) {
    Textured t{onBack};
    t.surface.backMaterial = true;
    expectBoth(
        "textures_and_back_material", [&](Gl gl) { drawTextured(gl, t); }, 1);
  }
}

}  // namespace
}  // namespace gluray::test
