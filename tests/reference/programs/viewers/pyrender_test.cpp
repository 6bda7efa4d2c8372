// The shaders of pyrender's meshes, against the real OpenGL.
#include "tests/reference/programs/viewers/pyrender_text.h"
#include "tests/reference/programs/viewers/viewer_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <string>

namespace gluray::test {
namespace {

struct PyrenderCase {
  const char* name;
  bool flat = false, colors = false;
  float metallic = 0.3f, roughness = 0.5f;
  int lights = 2, points = 0;
  float emission = 0;
};
void PrintTo(const PyrenderCase& c, std::ostream* out) { *out << c.name; }

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// Replaces conditions and names as pyrender does.
std::string pyrenderText(const char* shader, const PyrenderCase& c) {
  std::map<std::string, int> defined = {
      {"NORMAL_LOC", 1},       {"USE_METALLIC_MATERIAL", 1}, {"INST_M_LOC", c.colors ? 3 : 2},
      {"MAX_POINT_LIGHTS", 2}, {"MAX_SPOT_LIGHTS", 1},       {"MAX_DIRECTIONAL_LIGHTS", 3}};
  if (c.colors) defined["COLOR_0_LOC"] = 2;
  std::string text = shader;
  for (const char* name : {"NORMAL_LOC", "TEXCOORD_0_LOC", "COLOR_0_LOC", "USE_METALLIC_MATERIAL",
                           "HAS_BASE_COLOR_TEX", "SRGB_CORRECTED"}) {
    const bool on = defined.contains(name);
    replaceAll(text, std::string("#ifdef ") + name + "\n", on ? "#if 1\n" : "#if 0\n");
    replaceAll(text, std::string("#ifndef ") + name + "\n", on ? "#if 0\n" : "#if 1\n");
  }
  for (const auto& [name, value] : defined) replaceAll(text, name, std::to_string(value));
  return text;
}
std::string pyrenderVertex(const PyrenderCase& c) { return pyrenderText(kPyrenderVertex, c); }
std::string pyrenderFragment(const PyrenderCase& c) {
  return pyrenderText(c.flat ? kPyrenderFlatFragment : kPyrenderFragment, c);
}

void setPyrenderLights(Gl gl, GLuint program, const PyrenderCase& c) {
  setInteger(gl, program, "n_directional_lights", c.lights);
  setInteger(gl, program, "n_point_lights", c.points);
  setVec3(gl, program, "ambient_light", {0.2f, 0.15f, 0.1f});
  setVec3(gl, program, "directional_lights[0].color", {1, 0.9f, 0.8f});
  setVec3(gl, program, "directional_lights[0].direction", {-0.4f, -0.5f, -0.8f});
  setFloat(gl, program, "directional_lights[0].intensity", 3);
  setVec3(gl, program, "directional_lights[1].color", {0.3f, 0.5f, 1});
  setVec3(gl, program, "directional_lights[1].direction", {1, 0.2f, -0.3f});
  setFloat(gl, program, "directional_lights[1].intensity", 2);
  setVec3(gl, program, "point_lights[0].color", {1, 1, 1});
  setVec3(gl, program, "point_lights[0].position", {1, 2, 3});
  setFloat(gl, program, "point_lights[0].intensity", 10);
}

/// One instance matrix, not orthogonal.
void setInstance(Gl gl, GLuint program) {
  const GLint place = gl.GetAttribLocation(program, "inst_m");
  makeBuffer(gl, GL_ARRAY_BUFFER,
             std::vector<glm::mat4>{
                 glm::mat4({1, 0.2f, 0, 0}, {0, 0.8f, 0, 0}, {0.1f, 0, 0.9f, 0}, {0.1f, 0, 0, 1})});
  for (GLuint k = 0; k < 4; ++k) {
    const GLuint column = static_cast<GLuint>(place) + k;
    gl.EnableVertexAttribArray(column);
    gl.VertexAttribPointer(column, 4, GL_FLOAT, GL_FALSE, 64, reinterpret_cast<const void*>(size_t{16} * k));
    gl.VertexAttribDivisor(column, 1);
  }
}

DrawViewer drawPyrender(const PyrenderCase& c) {
  return [c](Gl gl, GLuint program) {
    beginFrame(gl);
    gl.BlendFunc(GL_ONE, GL_ZERO);
    gl.UseProgram(program);
    const View view = perspectiveView(35);
    const glm::mat4 model = glm::rotate(glm::scale(glm::mat4(1), {1.1f, 0.9f, 1}), 0.3f, {0, 0, 1});
    setMat4(gl, program, "M", model), setMat4(gl, program, "V", glm::mat4(view.eyeFromObject));
    setMat4(gl, program, "P", glm::mat4(view.clipFromEye));
    setVec3(gl, program, "cam_pos", glm::vec3(glm::inverse(view.eyeFromObject)[3]));
    const glm::vec4 color(0.9f, 0.6f, 0.3f, 1);
    gl.Uniform4fv(gl.GetUniformLocation(program, "material.base_color_factor"), 1, &color.x);
    setFloat(gl, program, "material.metallic_factor", c.metallic);
    setFloat(gl, program, "material.roughness_factor", c.roughness);
    setVec3(gl, program, "material.emissive_factor", glm::vec3(c.emission));
    setPyrenderLights(gl, program, c);
    const Bowl bowl = bowlWithColors();
    const BowlDraw arrays(gl, bowl);
    std::vector<glm::vec4> colors;
    for (const glm::vec3& color3 : bowl.colors) colors.emplace_back(color3, 1);
    setArray(gl, program, "position", bowl.mesh.positions),
        setArray(gl, program, "normal", bowl.mesh.normals);
    setArray(gl, program, "color_0", colors);
    setInstance(gl, program);
    arrays.draw(1);
  };
}

const PyrenderCase kPyrenderCases[] = {
    {.name = "mesh"},
    {.name = "smooth_metal", .metallic = 1, .roughness = 0.2f},
    {.name = "beyond_range", .metallic = -0.5f, .roughness = 0.01f},
    {.name = "colors", .colors = true},
    {.name = "rough_colors", .colors = true, .metallic = 0.8f, .roughness = 1.4f},
    {.name = "no_light", .lights = 0},
    {.name = "flat", .flat = true},
    {.name = "flat_colors", .flat = true, .colors = true},
};

class PyrenderPrograms : public testing::TestWithParam<PyrenderCase> {};

TEST_P(PyrenderPrograms, AreTraced) {
  const PyrenderCase& c = GetParam();
  expectTraced(std::string("pyrender_") + c.name, pyrenderVertex(c), pyrenderFragment(c), drawPyrender(c));
}
INSTANTIATE_TEST_SUITE_P(All, PyrenderPrograms, testing::ValuesIn(kPyrenderCases),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(PyrenderPrograms, LightsAtPointsAndEmissionAreLeft) {
  for (const PyrenderCase& c :
       {PyrenderCase{.name = "points", .points = 1}, PyrenderCase{.name = "emission", .emission = 0.3f}})
    expectLeft(std::string("pyrender_") + c.name, pyrenderVertex(c), pyrenderFragment(c), drawPyrender(c));
}

class PyrenderMutants : public testing::TestWithParam<PyrenderCase> {};

TEST_P(PyrenderMutants, AreSeen) {
  const PyrenderCase& c = GetParam();
  expectViewerMutantsSeen(std::string("pyrender_") + c.name, pyrenderVertex(c), pyrenderFragment(c),
                          drawPyrender(c));
}
INSTANTIATE_TEST_SUITE_P(Cases, PyrenderMutants, testing::Values(kPyrenderCases[7]),
                         [](const auto& info) { return std::string(info.param.name); });
/// Label `program`: scripts/test --all.
INSTANTIATE_TEST_SUITE_P(MoreCases, PyrenderMutants, testing::Values(kPyrenderCases[3]),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
