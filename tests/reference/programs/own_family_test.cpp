// A program of a family that this test writes itself: uniforms in blocks, lights in arrays, light in the
// world's space.
#include "tests/reference/programs/program_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

const char* const kOwnVertex =
    "#version 150\nin vec3 position;\nin vec3 normal;\nout vec3 place;\nout vec3 n;\n"
    "layout(std140) uniform Camera { mat4 projection; mat4 view; vec3 eye; };\nuniform mat4 model;\n"
    "void main() { place = (model * vec4(position, 1)).xyz; n = mat3(model) * normal;\n"
    "  gl_Position = projection * view * vec4(place, 1); }\n";
const char* const kOwnFragment =
    "#version 150\nin vec3 place;\nin vec3 n;\nout vec4 color;\n"
    "layout(std140) uniform Camera { mat4 projection; mat4 view; vec3 eye; };\n"
    "struct Light { vec3 where; vec3 color; };\nuniform Light lights[4];\nuniform int lightCount;\n"
    "layout(std140) uniform Material { vec3 base; float shininess; } material;\n"
    "void main() { vec3 sum = 0.1 * material.base;\n"
    "  for (int i = 0; i < lightCount; ++i) {\n"
    "    vec3 l = normalize(lights[i].where - place), h = normalize(l + normalize(eye - place));\n"
    "    float d = max(dot(normalize(n), l), 0.0);\n"
    "    sum += lights[i].color * (d * material.base);\n"
    "    if (d > 0.0) sum += 0.5 * lights[i].color * pow(max(dot(normalize(n), h), 0.0), "
    "material.shininess); }\n"
    "  color = vec4(sum, 1); }\n";
const char* const kDescribedFamily = R"([[family]]
name = "own"
match.active = ["position", "projection", "model"]
vertex.position = "position"
vertex.normal = "normal"
transform.clip_from_object = ["projection", "view", "model"]
transform.eye_from_object = "model"
transform.viewer = "eye"
transform.normal_matrix = "model"
lights.specular = "half"
lights.count = "lightCount"
lights.color = "lights[{}].color"
lights.position = "lights[{}].where"
material.ambient_intensity = 0.1
material.ambient_color = "Material.base"
material.diffuse_color = "Material.base"
material.specular_intensity = 0.5
material.shininess = "Material.shininess"
)";

struct Block {
  GLuint buffer = 0;
  void set(Gl gl, const std::vector<GLfloat>& values) const {
    gl.BindBuffer(GL_UNIFORM_BUFFER, buffer);
    gl.BufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(4 * values.size()), values.data(),
                  GL_DYNAMIC_DRAW);
  }
};

void setCamera(Gl gl, const Block& block, double degrees) {
  const View view = perspectiveView(degrees);
  const glm::mat4 p(view.clipFromEye), v(view.eyeFromObject);
  const glm::vec4 eye = glm::inverse(v)[3];
  std::vector<GLfloat> values(glm::value_ptr(p), glm::value_ptr(p) + 16);
  values.insert(values.end(), glm::value_ptr(v), glm::value_ptr(v) + 16);
  values.insert(values.end(), glm::value_ptr(eye), glm::value_ptr(eye) + 4);
  block.set(gl, values);
}

void drawOwn(Gl gl) {
  const GLuint program = makeProgram(gl, kOwnVertex, kOwnFragment);
  ProgramMesh mesh = ball(20);
  const Upload up = [&] {
    Upload u = upload(gl, mesh, program);  // finds no VTK names: positions and normals are set below
    const auto add = [&](const char* name, const std::vector<glm::vec3>& values) {
      GLuint made = 0;
      const auto place = static_cast<GLuint>(gl.GetAttribLocation(program, name));
      gl.GenBuffers(1, &made), gl.BindBuffer(GL_ARRAY_BUFFER, made);
      gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(12 * values.size()), values.data(),
                    GL_STATIC_DRAW);
      gl.EnableVertexAttribArray(place), gl.VertexAttribPointer(place, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    };
    add("position", mesh.positions), add("normal", mesh.normals);
    return u;
  }();
  Block camera, material;
  gl.GenBuffers(1, &camera.buffer), gl.GenBuffers(1, &material.buffer);
  gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "Camera"), 2);
  gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "Material"), 5);
  beginFrame(gl);
  gl.UseProgram(program), gl.BindVertexArray(up.array);
  setCamera(gl, camera, 30);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 2, camera.buffer);
  setInteger(gl, program, "lightCount", 2);
  setVec3(gl, program, "lights[0].where", {3, 2, 3}),
      setVec3(gl, program, "lights[0].color", {0.8f, 0.7f, 0.6f});
  setVec3(gl, program, "lights[1].where", {-3, 1, 2}),
      setVec3(gl, program, "lights[1].color", {0.1f, 0.2f, 0.5f});
  setVec3(gl, program, "lights[2].color", {1, 0, 0});
  for (int i = 0; i < 3; ++i) {
    const auto f = static_cast<float>(i);
    material.set(gl, {0.9f - 0.4f * f, 0.3f, 0.1f + 0.4f * f, 5 + 20 * f});
    gl.BindBufferBase(GL_UNIFORM_BUFFER, 5, material.buffer);
    const glm::mat4 model =
        glm::scale(glm::translate(glm::mat4(1), glm::vec3(1.1f * f - 1.1f, 0, 0.3f * f)), glm::vec3(0.5f));
    setMat4(gl, program, "model", model);
    gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
  }
}

TEST(ProgramFamilies, UniformsInBlocksLightsInArraysAndTheWorldsSpace) {
  expectBoth("own", drawOwn, 3, {}, kProgramTolerance, kDescribedFamily);
}

TEST(ProgramFamilies, ProgramsOfNoFamilyAreLeftToTheRealOne) { expectBoth("unknown", drawOwn, 0); }

}  // namespace
}  // namespace gluray::test
