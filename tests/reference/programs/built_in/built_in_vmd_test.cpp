// A program that computes what VMD's surfaces show. Its text is another one than VMD's, so its digests are
// added to those of the built-in family.
#include "gl/families/built_in_families.gen.h"
#include "gl/glsl/shader_digest.h"
#include "tests/reference/programs/built_in/built_in_stage.h"

#include <gtest/gtest.h>

#include <string_view>

namespace gluray::test {
namespace {

const char* const kVmdVertex =
    "#version 110\nvarying vec3 way, paint;\nvoid main() {\n  vec4 p = gl_ModelViewMatrix * gl_Vertex;\n"
    "  gl_ClipVertex = p;\n  way = normalize(gl_NormalMatrix * gl_Normal);\n  paint = gl_Color.rgb;\n"
    "  gl_FogFragCoord = abs(p.z);\n  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n}\n";
const char* const kVmdFragment =
    "#version 110\nvarying vec3 way, paint;\nuniform vec3 vmdlight0, vmdlight1, vmdlight2, vmdlight3;\n"
    "uniform vec3 vmdlight0H, vmdlight1H, vmdlight2H, vmdlight3H;\nuniform vec4 vmdlightscale, vmdmaterial;\n"
    "uniform float vmdopacity, vmdoutline;\nuniform int vmdfogmode, vmdtexturemode, vmdtransmode;\n"
    "vec3 n;\nfloat matt(vec3 l) { return max(dot(n, l), 0.0); }\n"
    "float shiny(vec3 h) { return pow(max(dot(n, h), 0.0), vmdmaterial.w); }\n"
    "float clear() {\n  float d = gl_FogFragCoord, t = gl_Fog.density * d;\n"
    "  if (vmdfogmode == 1) return clamp((gl_Fog.end - d) * gl_Fog.scale, 0.0, 1.0);\n"
    "  if (vmdfogmode == 2) return exp(-t);\n  return vmdfogmode == 3 ? exp(-t * t) : 1.0;\n}\n"
    "void main() {\n  n = (gl_FrontFacing ? 1.0 : -1.0) * normalize(way);\n"
    "  vec4 d = vec4(matt(vmdlight0), matt(vmdlight1), matt(vmdlight2), matt(vmdlight3));\n"
    "  vec4 s = vec4(shiny(vmdlight0H), shiny(vmdlight1H), shiny(vmdlight2H), shiny(vmdlight3H));\n"
    "  vec3 lit = paint * dot(d, vmdlightscale) * vmdmaterial.y + vmdmaterial.x\n"
    "    + vmdmaterial.z * dot(s, vmdlightscale);\n"
    "  if (vmdoutline > 0.0) lit *= 1.0 - vmdoutline * (1.0 - abs(n.z));\n"
    "  if (vmdtexturemode != 0) lit *= 0.5;\n"
    "  float a = vmdtransmode == 1 ? vmdopacity * abs(n.z) : vmdopacity;\n"
    "  gl_FragColor = vec4(mix(gl_Fog.color.rgb, lit, clear()), a);\n}\n";

/// The built-in family, which knows our text, too.
std::string vmdFamily() {
  std::string text;
  for (const auto& [file, content] : gl::kBuiltInFamilyFiles)
    if (std::string_view(file).find("vmd.toml") != std::string_view::npos) text = content;
  const auto digest = [](const char* shader) { return gl::textOf(gl::digestOf(shader)); };
  return text + "\n[[code]]\nname = \"VMD surfaces\"\nshaders = [\"" + digest(kVmdVertex) + "\", \"" +
         digest(kVmdFragment) + "\"]\n";
}

struct VmdCase {
  const char* name;
  void (*set)(Gl gl, GLuint program);
  int traced = 3;
};
void PrintTo(const VmdCase& c, std::ostream* out) { *out << c.name; }

void setFog(Gl gl, GLuint program, int mode) {
  const GLfloat color[] = {0.1f, 0.3f, 0.8f, 1};
  gl.Fogfv(GL_FOG_COLOR, color), gl.Fogf(GL_FOG_DENSITY, 0.25f);
  gl.Fogf(GL_FOG_START, 2.8f), gl.Fogf(GL_FOG_END, 4.6f);
  setInteger(gl, program, "vmdfogmode", mode);
}

const VmdCase kVmdCases[] = {
    {"plain", [](Gl, GLuint) {}},
    {"linear_fog", [](Gl gl, GLuint p) { setFog(gl, p, 1); }},
    {"exp_fog", [](Gl gl, GLuint p) { setFog(gl, p, 2); }},
    {"exp2_fog", [](Gl gl, GLuint p) { setFog(gl, p, 3); }},
    {"fog_off", [](Gl gl, GLuint p) { setFog(gl, p, 0); }},
    {"inside", [](Gl gl, GLuint) { gl.Enable(GL_CULL_FACE), gl.CullFace(GL_FRONT); }},
    {"translucent",
     [](Gl gl, GLuint p) {
       gl.Enable(GL_BLEND), gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), gl.DepthMask(GL_FALSE);
       setFloat(gl, p, "vmdopacity", 0.4f);
     }},
    {"outlined", [](Gl gl, GLuint p) { setFloat(gl, p, "vmdoutline", 0.5f); }, 0},
    {"textured", [](Gl gl, GLuint p) { setInteger(gl, p, "vmdtexturemode", 1); }, 0},
    {"by_angle",
     [](Gl gl, GLuint p) { setInteger(gl, p, "vmdtransmode", 1), setFloat(gl, p, "vmdopacity", 0.6f); }, 0},
};

void setVmd(Gl gl, GLuint program) {
  const GLfloat scale[] = {1, 0, 1, 0.5f}, material[] = {0.05f, 0.65f, 0.5f, 18};
  gl.Uniform4fv(gl.GetUniformLocation(program, "vmdlightscale"), 1, scale);
  gl.Uniform4fv(gl.GetUniformLocation(program, "vmdmaterial"), 1, material);
  setFloat(gl, program, "vmdopacity", 1);
  const glm::vec3 lights[] = {{0, 0, 1}, {1, 0, 0}, {0.6f, 0.8f, 0}, {-0.48f, 0.6f, 0.64f}};
  for (int i = 0; i < 4; ++i) {
    const std::string name = "vmdlight" + std::to_string(i);
    setVec3(gl, program, name.c_str(), lights[i]);
    setVec3(gl, program, (name + "H").c_str(), glm::normalize(lights[i] + glm::vec3(0.1f, 0, 1)));
  }
}

class VmdSurfaces : public testing::TestWithParam<VmdCase> {};

TEST_P(VmdSurfaces, AreTraced) {
  const VmdCase& c = GetParam();
  expectBuiltIns(
      std::string("vmd-") + c.name,
      [&](Gl gl) {
        const GLuint program = makeProgram(gl, kVmdVertex, kVmdFragment);
        const ProgramMesh round = ball(24), wavy = sheet(16);
        beginBuiltInFrame(gl);
        gl.UseProgram(program);
        setVmd(gl, program);
        c.set(gl, program);
        sendMesh(gl, round, Way::clientElements);
        gl.Translatef(0.4f, 0.3f, 0), gl.Rotatef(70, 1, 0.2f, 0);
        gl.Color4f(0.9f, 0.7f, 0.2f, 0.3f);  // this alpha does not count
        sendMesh(gl, wavy, Way::immediate, false);
        gl.Color3f(0.3f, 0.9f, 0.8f), gl.Scalef(0.5f, 0.5f, 0.5f);
        sendMesh(gl, round, Way::list, false);
        gl.DepthMask(GL_TRUE);
      },
      c.traced, vmdFamily());
}

INSTANTIATE_TEST_SUITE_P(Cases, VmdSurfaces, testing::ValuesIn(kVmdCases),
                         [](const auto& info) { return std::string(info.param.name); });

/// Fog by |z| at the vertices is not that of points on a triangle that reaches behind the viewer's plane.
TEST(VmdSurface, ThatReachesBehindTheViewerIsLeftInFog) {
  expectBuiltIns(
      "vmd-behind",
      [&](Gl gl) {
        const GLuint program = makeProgram(gl, kVmdVertex, kVmdFragment);
        beginBuiltInFrame(gl);
        gl.UseProgram(program);
        setVmd(gl, program), setFog(gl, program, 1);
        gl.Scalef(1, 1, 5), sendMesh(gl, ball(12), Way::clientElements);
        gl.Translatef(0.7f, 0, 0), setInteger(gl, program, "vmdfogmode", 0);
        sendMesh(gl, ball(12), Way::clientElements);
      },
      1, vmdFamily());
}

TEST(VmdSurface, OfAnotherProgramIsNotRecognised) {
  const std::string other = std::string(kVmdFragment).replace(13, 0, "// the same\nuniform float more;\n");
  expectBuiltIns(
      "vmd-other",
      [&](Gl gl) {
        const GLuint program = makeProgram(gl, kVmdVertex, other);
        beginBuiltInFrame(gl);
        gl.UseProgram(program);
        setVmd(gl, program);
        sendMesh(gl, ball(12), Way::clientElements);
      },
      0, vmdFamily());
}

}  // namespace
}  // namespace gluray::test
