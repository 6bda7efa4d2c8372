// Instances with a place and a scale, colours of vertices or instances, lights with names, and conditions in
// the source.
#include "tests/reference/programs/program_stage.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

struct ShiftedCase {
  const char* name;
  bool perInstance = true;  // colours
  float alpha = 1;          // of the last instance's colour
  bool unknown = false;     // a condition lets through a statement that the family does not know
  int traced = 1;
};
void PrintTo(const ShiftedCase& c, std::ostream* out) { *out << c.name; }

const ShiftedCase kShiftedCases[] = {{"instance_colors"},
                                     {"vertex_colors", false},
                                     {"one_translucent", true, 0.5f, false, 0},
                                     {"other_branch", true, 1, true, 0}};

const char* const kShiftedVertex =
    "in vec3 vertexMC, normalMC; in vec4 scalarColor; uniform mat4 mvp, modelview; out vec3 n; out vec4 c;\n"
    "#ifdef SHIFTED\nin vec4 spot;\n#endif\n"
    "void main() {\n#ifdef SHIFTED\nvec4 at = vec4(spot.w * vertexMC + spot.xyz, 1);\n#else\n"
    "vec4 at = vec4(vertexMC, 1);\n#endif\n"
    "n = normalize((modelview * vec4(normalMC, 0)).xyz);\nc = scalarColor;\ngl_Position = mvp * at;\n}\n";
const char* const kShiftedFragment =
    "in vec3 n; in vec4 c; uniform vec3 sunWay, skyWay, sunGlow, skyGlow; out vec4 color;\n"
    "void main() {\nvec3 m = normalize(n);\n"
    "vec3 light = max(dot(m, -sunWay), 0.0) * sunGlow + max(dot(m, -skyWay), 0.0) * skyGlow;\n"
    "#if defined(INVERTED) && defined(SHIFTED)\nlight = 1.0 - light;\n#endif\n"
    "color = vec4(c.rgb * light, c.a);\n}\n";
const std::string kShiftedFamily = R"([[code]]
name = "shifted"
complete = true
blocks = '''
vec4 at = vec4(spot.w * vertexMC + spot.xyz, 1);
n = normalize((modelview * vec4(normalMC, 0)).xyz);
c = scalarColor;
gl_Position = mvp * at;

vec3 m = normalize(n);
vec3 light = max(dot(m, -sunWay), 0.0) * sunGlow + max(dot(m, -skyWay), 0.0) * skyGlow;
color = vec4(c.rgb * light, c.a);
'''
[[family]]
name = "shifted"
match.active = ["vertexMC", "spot"]
match.resolve_conditions = true
match.code = "shifted"
vertex.position = "vertexMC"
vertex.normal = "normalMC"
vertex.color = "scalarColor"
instance.shift_and_scale = "spot"
instance.color = "scalarColor"
transform.clip_from_object = "mvp"
transform.eye_from_object = "modelview"
transform.normal_matrix = "modelview"
normals.unit = "both"
color.opaque_only = true
lights.names = ["sun", "sky"]
lights.direction = "{}Way"
lights.color = "{}Glow"
)";

/// An array of four floats for each instance.
void addOfInstances(Gl gl, GLuint program, const char* name, const std::vector<GLfloat>& values) {
  const auto at = static_cast<GLuint>(gl.GetAttribLocation(program, name));
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * values.size()), values.data(), GL_STATIC_DRAW);
  gl.EnableVertexAttribArray(at);
  gl.VertexAttribPointer(at, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.VertexAttribDivisor(at, 1);
}

void drawShifted(Gl gl, const ShiftedCase& c) {
  constexpr int kBalls = 12;
  const std::string head =
      std::string("#version 150\n#define SHIFTED 1\n") + (c.unknown ? "#define INVERTED 1\n" : "");
  const GLuint program = makeProgram(gl, head + kShiftedVertex, head + kShiftedFragment);
  const ProgramMesh mesh = ball(12);
  upload(gl, mesh, program);
  std::vector<GLfloat> spots, colors;
  for (int i = 0; i < kBalls; ++i) {
    const auto t = static_cast<float>(i);
    for (const float v : {1.2f * std::sin(2 * t), 0.9f * std::cos(3 * t), std::sin(t), 0.2f + 0.02f * t})
      spots.push_back(v);
    for (const float v : {0.08f * t, 1 - 0.05f * t, 0.6f, i + 1 == kBalls ? c.alpha : 1}) colors.push_back(v);
  }
  addOfInstances(gl, program, "spot", spots);
  if (c.perInstance) addOfInstances(gl, program, "scalarColor", colors);
  beginFrame(gl);
  gl.Disable(GL_BLEND);
  gl.UseProgram(program);
  const View view = perspectiveView(35);
  setMat4(gl, program, "mvp", glm::mat4(view.clipFromEye * view.eyeFromObject));
  setMat4(gl, program, "modelview", glm::mat4(view.eyeFromObject));
  setVec3(gl, program, "sunWay", {-0.6f, 0, -0.8f}), setVec3(gl, program, "sunGlow", {0.9f, 0.8f, 0.5f});
  setVec3(gl, program, "skyWay", {0, -1, 0}), setVec3(gl, program, "skyGlow", {0.1f, 0.3f, 0.6f});
  gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, kBalls);
}

class ProgramShifted : public testing::TestWithParam<ShiftedCase> {};

TEST_P(ProgramShifted, IsWhatTheProgramComputes) {
  const ShiftedCase& c = GetParam();
  expectBoth(
      std::string("shifted_") + c.name, [&](Gl gl) { drawShifted(gl, c); }, c.traced, coreWish(3, 3),
      kProgramTolerance, kShiftedFamily);
}

INSTANTIATE_TEST_SUITE_P(Cases, ProgramShifted, testing::ValuesIn(kShiftedCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
