// Programs that take vertices, matrices and lights from fixed function: their looks, and all ways to send
// vertices.
#include "tests/reference/programs/built_in/built_in_stage.h"
#include "tests/reference/programs/program_mutants.h"

#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

struct BuiltInLook {
  const char* name;
  const ShaderPair* shaders;
  Way way;
};
void PrintTo(const BuiltInLook& c, std::ostream* out) { *out << c.name << " " << nameOf(c.way); }

const BuiltInLook kBuiltInLooks[] = {
    {"shaded", &kShaded, Way::clientElements},
    {"shaded", &kShaded, Way::clientArrays},
    {"shaded", &kShaded, Way::buffers},
    {"shaded", &kShaded, Way::immediate},
    {"shaded", &kShaded, Way::list},
    {"view_normals", &kViewNormalColor, Way::clientElements},
    {"normals", &kNormalColor, Way::clientArrays},
    {"edge_hilight", &kEdgeHilight, Way::immediate},
    {"balloon", &kBalloon, Way::immediate},
    {"balloon", &kBalloon, Way::list},
    {"open_ctm", &kOpenCtm, Way::buffers},
    {"open_ctm", &kOpenCtm, Way::list},
};

class BuiltInLooks : public testing::TestWithParam<BuiltInLook> {};

TEST_P(BuiltInLooks, AreTraced) {
  const BuiltInLook& c = GetParam();
  expectBuiltIns(
      std::string(c.name) + "-" + nameOf(c.way),
      [&](Gl gl) {
        const GLuint program = makeProgram(gl, c.shaders->vertex, c.shaders->fragment);
        const ProgramMesh round = ball(24), wavy = sheet(16);
        beginBuiltInFrame(gl);
        gl.UseProgram(program);
        sendMesh(gl, round, c.way);
        gl.Translatef(0.4f, 0.3f, 0), gl.Rotatef(70, 1, 0.2f, 0);
        gl.Color3f(0.9f, 0.7f, 0.2f);
        sendMesh(gl, wavy, c.way, false);
      },
      2);
}

INSTANTIATE_TEST_SUITE_P(Cases, BuiltInLooks, testing::ValuesIn(kBuiltInLooks), [](const auto& info) {
  return std::string(info.param.name) + "_" + nameOf(info.param.way);
});

const char* const kLampVertex =
    "varying vec3 n, p;\nvoid main() {\n  n = gl_NormalMatrix * gl_Normal;\n"
    "  p = vec3(gl_ModelViewMatrix * gl_Vertex);\n"
    "  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n}\n";
const char* const kLampFragment =
    "varying vec3 n, p;\nvoid main() {\n  vec3 N = normalize(n);\n"
    "  vec3 L = normalize(gl_LightSource[0].position.xyz - p);\n"
    "  vec3 H = normalize(L - normalize(p));\n"
    "  float d = max(dot(N, L), 0.0);\n"
    "  float s = d > 0.0 ? pow(max(dot(N, H), 0.0), gl_FrontMaterial.shininess) : 0.0;\n"
    "  vec3 sum = gl_FrontLightModelProduct.sceneColor.rgb + gl_FrontLightProduct[0].ambient.rgb;\n"
    "  sum += d * gl_FrontLightProduct[0].diffuse.rgb + s * gl_FrontLightProduct[0].specular.rgb;\n"
    "  gl_FragColor = vec4(sum, 1.0);\n}\n";

std::string blocksOf(const char* shader) {
  std::string text = shader;
  text = text.substr(text.find("{\n") + 2);
  return text.substr(0, text.rfind('}'));
}

std::string lampFamily() {
  return "[[code]]\nname = \"lamp\"\ncomplete = true\nblocks = '''\n" + blocksOf(kLampVertex) + "\n" +
         blocksOf(kLampFragment) +
         "'''\n[[family]]\nname = \"lamp\"\nmatch.active = \"gl_Vertex\"\nmatch.code = \"lamp\"\n"
         "vertex.position = \"gl_Vertex\"\nvertex.normal = \"gl_Normal\"\n"
         "transform.clip_from_object = [\"gl_ProjectionMatrix\", \"gl_ModelViewMatrix\"]\n"
         "transform.eye_from_object = \"gl_ModelViewMatrix\"\ntransform.normal_matrix = \"gl_NormalMatrix\"\n"
         "lights.position = \"gl_LightSource[0].position\"\nlights.specular = \"half\"\n"
         "material.ambient_color = \"gl_FrontLightProduct[0].ambient\"\n"
         "material.emission_color = \"gl_FrontLightModelProduct.sceneColor\"\n"
         "material.diffuse_color = \"gl_FrontLightProduct[0].diffuse\"\n"
         "material.specular_color = \"gl_FrontLightProduct[0].specular\"\n"
         "material.shininess = \"gl_FrontMaterial.shininess\"\n";
}

/// State that no call names to the program: each draw has that of its time.
TEST(BuiltInInputs, AreThoseOfTheDraw) {
  expectBuiltIns(
      "lamps",
      [](Gl gl) {
        const GLuint program = makeProgram(gl, kLampVertex, kLampFragment);
        const ProgramMesh round = ball(16);
        beginBuiltInFrame(gl);
        gl.Scalef(0.6f, 0.6f, 0.6f);
        gl.UseProgram(program);
        gl.Translatef(-1.2f, 0, 0), sendMesh(gl, round, Way::immediate);
        const GLfloat red[] = {1, 0.2f, 0.1f, 1}, place[] = {-2, 0, 3, 1};
        gl.Materialfv(GL_FRONT, GL_DIFFUSE, red), gl.Materialf(GL_FRONT, GL_SHININESS, 40);
        gl.Translatef(1.2f, 0, 0), sendMesh(gl, round, Way::clientElements);
        gl.Lightfv(GL_LIGHT0, GL_POSITION, place), gl.Lightfv(GL_LIGHT0, GL_AMBIENT, red);
        gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, red);
        gl.Translatef(1.2f, 0, 0), sendMesh(gl, round, Way::list);
      },
      3, lampFamily());
}

TEST(BuiltInInputs, OfColorsAreClamped) {
  expectBuiltIns(
      "clamped",
      [](Gl gl) {
        const GLuint program = makeProgram(gl, kShaded.vertex, kShaded.fragment);
        beginBuiltInFrame(gl);
        gl.UseProgram(program);
        gl.Color4f(3, -1, 0.5f, 1);
        sendMesh(gl, ball(16), Way::clientElements, false);
        gl.Translatef(0, 0, 1);
        gl.Begin(GL_TRIANGLES), gl.Normal3f(0.5f, -0.5f, -0.3f);
        gl.Color3f(4, 0, 0), gl.Vertex2f(-1, -1), gl.Color3f(0, 2, -3), gl.Vertex2f(1, -1);
        gl.Color3f(0.3f, -2, 1), gl.Vertex2f(0, 1), gl.End();
      },
      2);
}

/// Colours by height: powers, and none where they are undefined.
TEST(BuiltInInputs, OfHeightColors) {
  const auto draw = [](const std::vector<GLfloat>& map) {
    return [map](Gl gl) {
      const GLuint program = makeProgram(gl, kHeightColor.vertex, kHeightColor.fragment);
      beginBuiltInFrame(gl);
      gl.UseProgram(program);
      gl.Uniform1fv(gl.GetUniformLocation(program, "colorMap"), 9, map.data());
      sendMesh(gl, ball(24), Way::clientElements);
    };
  };
  expectBuiltIns("height", draw({1, 1, 1, 1, 0.5f, 1, 1, 0, 1}), 1);
  expectBuiltIns("height-powers", draw({0.3f, 1.5f, 0.5f, 0.4f, 1, 2, -0.5f, -1, 1.5f}), 1);
  expectBuiltIns("height-undefined", draw({1, 0.5f, 2, 1, 0, 1, 1, 0, 1}), 0);
  expectBuiltIns("height-negative-power", draw({1, 1, 1, 1, 3, -0.5f, 1, 0, 1}), 0);
}

class BuiltInMutants : public testing::TestWithParam<BuiltInLook> {};

TEST_P(BuiltInMutants, AreNotTakenForTheOriginal) {
  const BuiltInLook& c = GetParam();
  expectMutantsSeen(
      c.name, {{GL_VERTEX_SHADER, c.shaders->vertex}, {GL_FRAGMENT_SHADER, c.shaders->fragment}},
      [&](Gl gl, GLuint program) {
        const GLfloat map[] = {0.5f, 1, 1, 0.5f, 1.5f, 1, 0.4f, 1, 2};
        beginBuiltInFrame(gl);
        gl.UseProgram(program);
        gl.Uniform1fv(gl.GetUniformLocation(program, "colorMap"), 9, map);
        sendMesh(gl, ball(12), c.way);
      },
      compatibleWish());
}

const BuiltInLook kBuiltInMutantCases[] = {
    {"shaded", &kShaded, Way::clientElements},   {"view_normals", &kViewNormalColor, Way::immediate},
    {"normals", &kNormalColor, Way::buffers},    {"edge_hilight", &kEdgeHilight, Way::buffers},
    {"balloon", &kBalloon, Way::buffers},        {"height", &kHeightColor, Way::clientArrays},
    {"open_ctm", &kOpenCtm, Way::clientElements}};
INSTANTIATE_TEST_SUITE_P(Cases, BuiltInMutants, testing::ValuesIn(kBuiltInMutantCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
