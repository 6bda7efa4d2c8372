// Programs made of the statements that the built-in families of PyMOL and ChimeraX know.
#include "base/toml_text.h"
#include "gl/families/built_in_families.gen.h"
#include "tests/reference/programs/built_in/built_in_stage.h"
#include "tests/reference/programs/program_stage.h"

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::test {
namespace {

/// "statements" or "blocks" of the `n`th section of that name in spec/programs.
std::string codeOf(std::string_view section, const char* key, int n = 1) {
  for (const auto& [file, text] : gl::kBuiltInFamilyFiles) {
    const toml::table root = parseToml(text, file);
    const toml::array* sections = root["code"].as_array();
    for (size_t i = 0; sections && i < sections->size(); ++i) {
      const toml::table& one = *(*sections)[i].as_table();
      if (one.at("name").value_or(std::string_view()) == section && --n == 0)
        return one.at(key).value_or(std::string());
    }
  }
  ADD_FAILURE() << section;
  return "";
}

/// Block number `i` of a section.
std::string blockOf(std::string_view section, int i) {
  std::string text = codeOf(section, "blocks");
  for (; i > 0; --i) text.erase(0, text.find("\n\n") + 2);
  return text.substr(0, text.find("\n\n")) + "\n";
}

/// The definition of a function for the `n`th time in the text.
std::string functionAt(const std::string& text, const std::string& head, int n) {
  size_t at = text.find(head);
  for (; n > 1; --n) at = text.find(head, at + 1);
  return text.substr(at, text.find("\n}\n", at) + 3 - at);
}

/// Connects one array of the mesh, or of values, to the attribute, if the program has it.
template <class T>
void connect(Gl gl, GLuint program, const char* name, const std::vector<T>& values, GLint size, GLenum type,
             GLuint divisor = 0) {
  const GLint found = gl.GetAttribLocation(program, name);
  if (found < 0) return;
  const auto at = static_cast<GLuint>(found);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
                GL_STATIC_DRAW);
  for (GLint column = 0; column * 4 < size; ++column) {
    const auto place = at + static_cast<GLuint>(column);
    const GLsizei stride = size > 4 ? 4 * size : 0;
    gl.EnableVertexAttribArray(place);
    gl.VertexAttribPointer(place, std::min(size, 4), type, type == GL_UNSIGNED_BYTE, stride,
                           reinterpret_cast<const void*>(static_cast<size_t>(16 * column)));
    if (divisor) gl.VertexAttribDivisor(place, divisor);
  }
}

/// Makes the mesh's arrays current.
void connectMesh(Gl gl, GLuint program, const ProgramMesh& mesh, const char* position, const char* normal,
                 const char* color) {
  GLuint array = 0, indices = 0;
  gl.GenVertexArrays(1, &array), gl.BindVertexArray(array);
  connect(gl, program, position, mesh.positions, 3, GL_FLOAT);
  connect(gl, program, normal, mesh.normals, 3, GL_FLOAT);
  if (color) connect(gl, program, color, mesh.colors, 4, GL_UNSIGNED_BYTE);
  gl.GenBuffers(1, &indices), gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * mesh.indices.size()),
                mesh.indices.data(), GL_STATIC_DRAW);
}

struct PyMolCase {
  const char* name;
  bool surface = true, cue = true, inside = false;
  int lights = 2, twoSided = 0;
  const char* zero = nullptr;  // a boolean that is 1 otherwise
  const char* one = nullptr;   // a number that is 0 otherwise
  int traced = 1;
  bool named = false;  // the structures of lights have names, as in PyMOL 3
};
void PrintTo(const PyMolCase& c, std::ostream* out) { *out << c.name; }

const PyMolCase kPyMolCases[] = {
    {"surface"},
    {.name = "surface_of_3", .named = true},
    {"surface_clear", true, false},
    {"surface_one_light", true, true, false, 1},
    {"surface_eight_lights", true, true, false, 8},
    {"surface_inside", true, true, true},
    {"surface_inside_lit", true, true, true, 2, 1},
    {"surface_picked", true, true, false, 2, 0, nullptr, "isPicking", 0},
    {"surface_occluded", true, true, false, 2, 0, nullptr, "accessibility_mode_on", 0},
    {"surface_interior", true, true, true, 2, 0, nullptr, "use_interior_color"},
    {"surface_interior_outside", true, true, false, 2, 0, nullptr, "use_interior_color"},
    {"default", false},
    {"default_clear_inside", false, false, true},
    {"default_inside_lit", false, true, true, 2, 1},
    {"default_unlit", false, true, false, 2, 0, "lighting_enabled"}};

GLuint pyMolProgram(Gl gl, const PyMolCase& c) {
  const char* const section = c.surface ? "PyMOL surface" : "PyMOL default";
  const std::string lights = codeOf("PyMOL lights", "statements");
  const std::string structures = c.named ? codeOf("PyMOL lights", "statements", 2)
                                         : lights.substr(0, lights.find("vec2 ComputeLighting"));
  const std::string varyings =
      "varying vec3 packed_data_0; varying float fog; varying vec2 bgTextureLookup;\n";
  const std::string vertex =
      varyings +
      "uniform mat3 g_NormalMatrix; uniform mat4 g_ModelViewMatrix, g_ProjectionMatrix; uniform float "
      "g_Fog_end, "
      "g_Fog_scale;\nattribute vec4 a_Vertex; attribute vec3 a_Normal; attribute vec4 a_Color; attribute "
      "float "
      "a_Accessibility;\nuniform float ambient_occlusion_scale, accessibility_mode_on; uniform int "
      "accessibility_mode; uniform bool isPicking;\nvoid main() {\n" +
      blockOf(section, 0) + "}\n";
  const std::string fragment = varyings + codeOf(section, "statements") +
                               "uniform bool lighting_enabled, two_sided_lighting_enabled, "
                               "use_interior_color, isPicking;\nuniform vec4 "
                               "interior_color; uniform vec3 bgSolidColor; uniform float shininess, "
                               "shininess_0, spec_value, spec_value_0;\n" +
                               codeOf("PyMOL effects", "statements") +
                               codeOf(c.cue ? "PyMOL depth cue" : "PyMOL no depth cue", "blocks") +
                               structures + functionAt(lights, "vec2 ComputeLighting", 1) +
                               functionAt(lights, "vec4 ApplyLighting", c.lights) + "void main() {\n" +
                               blockOf(section, 1) + "}\n";
  return makeProgram(gl, vertex, fragment);
}

void drawAsPyMol(Gl gl, const PyMolCase& c) {
  const GLuint program = pyMolProgram(gl, c);
  const ProgramMesh mesh = ball(24);
  connectMesh(gl, program, mesh, "a_Vertex", "a_Normal", "a_Color");
  beginFrame(gl);
  gl.UseProgram(program);
  const View view = perspectiveView(35);
  setMat4(gl, program, "g_ProjectionMatrix", glm::mat4(view.clipFromEye));
  setMat4(gl, program, "g_ModelViewMatrix", glm::mat4(view.eyeFromObject));
  setMat3(gl, program, "g_NormalMatrix", glm::mat3(view.eyeFromObject));
  setFloat(gl, program, "g_Fog_end", 4.4f), setFloat(gl, program, "g_Fog_scale", 0.8f);
  setVec3(gl, program, "bgSolidColor", {0.1f, 0.3f, 0.5f});
  const auto setVec4 = [&](const std::string& name, const glm::vec4& v) {
    gl.Uniform4fv(gl.GetUniformLocation(program, name.c_str()), 1, glm::value_ptr(v));
  };
  setVec4("g_LightModel.ambient", glm::vec4(0.14f)), setVec4("interior_color", {1, 0, 0, 1});
  for (int i = 0; i < c.lights; ++i) {
    const std::string light = "g_LightSource[" + std::to_string(i) + "].";
    const auto t = static_cast<float>(i);
    setVec4(light + "position", {std::sin(t), 0.5f * std::sin(2 * t), 1, 0});
    setVec4(light + "diffuse", glm::vec4(0.9f / static_cast<float>(c.lights)));
  }
  setFloat(gl, program, "spec_value_0", 0.3f), setFloat(gl, program, "spec_value", 0.5f);
  setFloat(gl, program, "shininess_0", 40), setFloat(gl, program, "shininess", 25);
  setInteger(gl, program, "two_sided_lighting_enabled", c.twoSided);
  setInteger(gl, program, "lighting_enabled", c.zero == nullptr);
  if (std::string_view(c.one ? c.one : "") == "accessibility_mode_on")
    setFloat(gl, program, c.one, 1);
  else if (c.one)
    setInteger(gl, program, c.one, 1);
  if (c.inside) gl.Enable(GL_CULL_FACE), gl.CullFace(GL_FRONT);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

class PyMolPrograms : public testing::TestWithParam<PyMolCase> {};

TEST_P(PyMolPrograms, AreTraced) {
  const PyMolCase& c = GetParam();
  expectBoth(
      std::string("pymol_") + c.name, [&](Gl gl) { drawAsPyMol(gl, c); }, c.traced, compatibleWish());
}

INSTANTIATE_TEST_SUITE_P(Cases, PyMolPrograms, testing::ValuesIn(kPyMolCases),
                         [](const auto& info) { return std::string(info.param.name); });

struct ChimeraXCase {
  enum Copies { none, shifted, placed };
  const char* name;
  Copies copies = none;
  bool cue = true, vertexColors = false, instanceColors = false;
  float alpha = 1;
  int traced = 1;
};
void PrintTo(const ChimeraXCase& c, std::ostream* out) { *out << c.name; }

const ChimeraXCase kChimeraXCases[] = {{"mesh"},
                                       {"mesh_clear_vertex_colors", ChimeraXCase::none, false, true},
                                       {"mesh_translucent", ChimeraXCase::none, true, false, false, 0.5f, 0},
                                       {"shifted_instance_colors", ChimeraXCase::shifted, true, false, true},
                                       {"shifted_clear_vertex_colors", ChimeraXCase::shifted, false, true},
                                       {"placed_instance_colors", ChimeraXCase::placed, true, false, true},
                                       {"placed_clear", ChimeraXCase::placed, false}};

GLuint chimeraXProgram(Gl gl, const ChimeraXCase& c) {
  const char* const section = c.copies == ChimeraXCase::none      ? "ChimeraX mesh"
                              : c.copies == ChimeraXCase::shifted ? "ChimeraX shifted mesh"
                                                                  : "ChimeraX placed mesh";
  const bool copies = c.copies != ChimeraXCase::none, colors = c.vertexColors || c.instanceColors;
  const std::string known = codeOf("ChimeraX", "statements");
  const size_t color = known.find("color = vcolor;"), block = known.find("layout(std140)");
  const std::string attributes = known.substr(0, colors ? color : known.find("layout(location = 3)"));
  const std::string vertex = "#version 330 core\n" + attributes + (copies ? blockOf(section, 0) : "") +
                             "uniform mat4 model_view_matrix, projection_matrix; out vec3 v, N;\n" +
                             (colors ? "out vec4 color;\n" : "") + "void main() {\n" +
                             blockOf(section, copies ? 1 : 0) + blockOf("ChimeraX", 0) +
                             blockOf(section, copies ? 2 : 1) + blockOf("ChimeraX", 1) +
                             (colors ? "color = vcolor;\n" : "") + blockOf("ChimeraX", 2) + "}\n";
  const std::string fragment =
      "#version 330 core\nin vec3 v, N;\nuniform vec3 depth_cue_color; uniform vec2 depth_cue_range;\n" +
      known.substr(block) + (colors ? "in" : "uniform") +
      " vec4 color; out vec4 frag_color;\nvoid main() {\n" + blockOf("ChimeraX", 3) +
      (c.cue ? codeOf("ChimeraX depth cue", "blocks") : "") + blockOf("ChimeraX", 4) + "}\n";
  return makeProgram(gl, vertex, fragment);
}

/// Twelve copies: places with scales, or matrices; and their colours.
void connectCopies(Gl gl, GLuint program, const ChimeraXCase& c, int count) {
  std::vector<float> spots, matrices;
  std::vector<uint32_t> colors;
  for (int i = 0; i < count; ++i) {
    const auto t = static_cast<float>(i);
    const glm::vec4 spot(1.2f * std::sin(2 * t), 0.9f * std::cos(3 * t), std::sin(t), 0.2f + 0.02f * t);
    spots.insert(spots.end(), glm::value_ptr(spot), glm::value_ptr(spot) + 4);
    const glm::mat4 matrix({0, spot.w, 0, 0}, {-spot.w, 0, 0, 0}, {0, 0, spot.w, 0},
                           glm::vec4(glm::vec3(spot), 1));
    matrices.insert(matrices.end(), glm::value_ptr(matrix), glm::value_ptr(matrix) + 16);
    colors.push_back(0xff4060c0u + 0x0d0800u * static_cast<uint32_t>(i));
  }
  connect(gl, program, "instance_shift_and_scale", spots, 4, GL_FLOAT, 1);
  connect(gl, program, "instance_placement", matrices, 16, GL_FLOAT, 1);
  if (c.instanceColors) connect(gl, program, "vcolor", colors, 4, GL_UNSIGNED_BYTE, 1);
}

void setChimeraXLights(Gl gl, GLuint program) {
  const GLfloat values[28] = {0.48f, -0.6f,  -0.64f, 0, 0.8f, 0.75f, 0.7f, 0, 0.3f, 0.3f,  0.25f, 30,
                              -0.6f, -0.48f, -0.64f, 0, 0.3f, 0.35f, 0.4f, 0, 0.3f, 0.25f, 0.2f};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_UNIFORM_BUFFER, buffer);
  gl.BufferData(GL_UNIFORM_BUFFER, sizeof values, values, GL_STATIC_DRAW);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 1, buffer);
  gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "lighting_block"), 1);
}

void drawAsChimeraX(Gl gl, const ChimeraXCase& c) {
  constexpr int kCopies = 12;
  const GLuint program = chimeraXProgram(gl, c);
  const ProgramMesh mesh = ball(16);
  connectMesh(gl, program, mesh, "position", "normal", c.vertexColors ? "vcolor" : nullptr);
  connectCopies(gl, program, c, kCopies);
  beginFrame(gl);
  gl.Disable(GL_BLEND);
  gl.UseProgram(program);
  const View view = perspectiveView(35);
  setMat4(gl, program, "projection_matrix", glm::mat4(view.clipFromEye));
  setMat4(gl, program, "model_view_matrix", glm::mat4(view.eyeFromObject));
  setVec3(gl, program, "depth_cue_color", {0.9f, 0.9f, 0.8f});
  gl.Uniform2f(gl.GetUniformLocation(program, "depth_cue_range"), 3.2f, 4.8f);
  gl.Uniform4f(gl.GetUniformLocation(program, "color"), 0.8f, 0.5f, 0.3f, c.alpha);
  setChimeraXLights(gl, program);
  if (c.copies == ChimeraXCase::none)
    gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
  else
    gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, kCopies);
}

class ChimeraXPrograms : public testing::TestWithParam<ChimeraXCase> {};

TEST_P(ChimeraXPrograms, AreTraced) {
  const ChimeraXCase& c = GetParam();
  expectBoth(
      std::string("chimerax_") + c.name, [&](Gl gl) { drawAsChimeraX(gl, c); }, c.traced, coreWish(3, 3));
}

INSTANTIATE_TEST_SUITE_P(Cases, ChimeraXPrograms, testing::ValuesIn(kChimeraXCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
