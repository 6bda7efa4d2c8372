// The keys of family files, each tested by a program that computes exactly that.
#include "tests/reference/programs/program_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

/// A program, its family, and the uniforms it sets besides the matrices `mvp` and `modelview`.
struct FamilyCase {
  const char *name, *vertex, *fragment, *family;
  void (*set)(Gl, GLuint program);
  bool ball = true;
};
void PrintTo(const FamilyCase& c, std::ostream* out) { *out << c.name; }

const char* const kHead =
    "[[family]]\nname = \"own\"\nmatch.active = \"vertexMC\"\nvertex.position = \"vertexMC\"\n"
    "transform.clip_from_object = \"mvp\"\n";

const FamilyCase kFamilyCases[] = {
    // Direction towards the light, of any length; ambient light only of the material; normals by the inverse
    // transpose.
    {"sun",
     "in vec3 vertexMC, normalMC; in vec4 scalarColor; uniform mat4 mvp, modelview; out vec3 n, p; out vec4 "
     "c;\n"
     "void main() { n = transpose(inverse(mat3(modelview))) * normalMC; p = (modelview * vec4(vertexMC, "
     "1)).xyz;\n"
     "  c = scalarColor; gl_Position = mvp * vec4(vertexMC, 1); }\n",
     "in vec3 n, p; in vec4 c; uniform vec3 sun; uniform float shine; out vec4 color;\n"
     "void main() { vec3 l = normalize(sun), m = normalize(n), h = normalize(l - normalize(p));\n"
     "  float d = max(dot(m, l), 0.0), s = d > 0.0 ? pow(max(dot(m, h), 0.0), shine) : 0.0;\n"
     "  color = vec4(vec3(0.1, 0.1, 0.2) + d * c.rgb + s * vec3(0.3), 1); }\n",
     "vertex.normal = \"normalMC\"\nvertex.color = \"scalarColor\"\ntransform.eye_from_object = "
     "\"modelview\"\n"
     "lights.direction = \"sun\"\nlights.direction_towards_light = true\nlights.specular = \"half\"\n"
     "material.ambient_color = [0.1, 0.1, 0.2]\nmaterial.specular_color = 0.3\nmaterial.shininess = "
     "\"shine\"\n"
     "color.diffuse_only = true\n",
     [](Gl gl, GLuint program) {
       setVec3(gl, program, "sun", {3, 9, 6}), setFloat(gl, program, "shine", 12);
     }},
    // An image without light.
    {"textured",
     "in vec3 vertexMC; in vec2 tcoord; uniform mat4 mvp; out vec2 t;\n"
     "void main() { t = tcoord; gl_Position = mvp * vec4(vertexMC, 1); }\n",
     "in vec2 t; uniform sampler2D picture; uniform vec3 tint; out vec4 color;\n"
     "void main() { color = vec4(tint * texture(picture, t).rgb, 1); }\n",
     "vertex.texcoord = \"tcoord\"\nlights.model = \"unlit\"\nmaterial.diffuse_color = \"tint\"\n"
     "color.textures = \"picture\"\n",
     [](Gl gl, GLuint program) {
       chequers(gl, 3), setInteger(gl, program, "picture", 3), setVec3(gl, program, "tint", {1, 0.8f, 0.5f});
     },
     false},
    // Lamps in arrays, of which two are on.
    {"lamps",
     "in vec4 vertexMC; in vec3 normalMC; uniform mat4 mvp, modelview; out vec3 n, p;\n"
     "void main() { n = mat3(modelview) * normalMC; p = (modelview * vertexMC).xyz; gl_Position = mvp * "
     "vertexMC; }\n",
     "in vec3 n, p; uniform vec3 place[3], glow[3], falloff[3]; uniform int on; uniform vec3 base; out vec4 "
     "color;\n"
     "void main() { vec3 sum = vec3(0);\n  for (int i = 0; i < on; ++i) { vec3 l = place[i] - p; float r = "
     "length(l);\n"
     "    sum += glow[i] * max(dot(normalize(n), l / r), 0.0) / (falloff[i].x + r * falloff[i].y + r * r * "
     "falloff[i].z); }\n"
     "  color = vec4(sum * base, 1); }\n",
     "vertex.normal = \"normalMC\"\ntransform.eye_from_object = \"modelview\"\ntransform.normal_matrix = "
     "\"modelview\"\n"
     "lights.count = \"on\"\nlights.position = \"place[{}]\"\nlights.color = \"glow[{}]\"\n"
     "lights.attenuation = \"falloff[{}]\"\nmaterial.diffuse_color = \"base\"\n",
     [](Gl gl, GLuint program) {
       const GLfloat places[] = {1, 2, -2, -2, 0, -1.5f, 0, 0, 0},
                     glows[] = {1, 0.9f, 0.7f, 0.5f, 0.6f, 2, 9, 0, 0},
                     falloffs[] = {0.3f, 0.2f, 0, 0.2f, 0, 0.4f, 1, 0, 0};
       gl.Uniform3fv(gl.GetUniformLocation(program, "place"), 3, places);
       gl.Uniform3fv(gl.GetUniformLocation(program, "glow"), 3, glows);
       gl.Uniform3fv(gl.GetUniformLocation(program, "falloff"), 3, falloffs);
       setInteger(gl, program, "on", 2), setVec3(gl, program, "base", {0.8f, 0.7f, 0.9f});
     }},
    // A block in row-major order with a mat3 and an array.
    {"blocks",
     "in vec3 vertexMC, normalMC; layout(std140, row_major) uniform Own { mat3 turn; mat4 mvp; vec3 ways[2]; "
     "} own;\n"
     "out vec3 n;\nvoid main() { n = own.turn * normalMC; gl_Position = own.mvp * vec4(vertexMC, 1); }\n",
     "in vec3 n; layout(std140, row_major) uniform Own { mat3 turn; mat4 mvp; vec3 ways[2]; } own; uniform "
     "vec3 base;\n"
     "out vec4 color;\nvoid main() { vec3 sum = vec3(0);\n"
     "  for (int i = 0; i < 2; ++i) sum += max(dot(normalize(n), -normalize(own.ways[i])), 0.0) * base;\n"
     "  color = vec4(0.2 * base + 0.5 * sum, 1); }\n",
     "vertex.normal = \"normalMC\"\ntransform.normal_matrix = \"Own.turn\"\nlights.direction = "
     "\"Own.ways[{}]\"\n"
     "material.ambient_intensity = 0.2\nmaterial.ambient_color = \"base\"\nmaterial.diffuse_intensity = 0.5\n"
     "material.diffuse_color = \"base\"\n",
     [](Gl gl, GLuint program) {
       const View view = perspectiveView(35);
       const glm::mat4 mvp = glm::transpose(glm::mat4(view.clipFromEye * view.eyeFromObject));
       const glm::mat3 turn = glm::transpose(glm::mat3(view.eyeFromObject));
       std::vector<GLfloat> words(7, 3);  // before the block's part of the buffer
       words.resize(64, 7);
       for (int row = 0; row < 3; ++row)
         for (int k = 0; k < 4; ++k) words.push_back(k < 3 ? turn[row][k] : -1);
       words.insert(words.end(), glm::value_ptr(mvp), glm::value_ptr(mvp) + 16);
       for (const GLfloat way : {0.3f, -2.0f, -1.0f, 9.0f, -0.5f, 0.1f, -0.5f, 9.0f}) words.push_back(way);
       GLuint buffer = 0;
       gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_UNIFORM_BUFFER, buffer);
       gl.BufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(4 * words.size()), words.data(),
                     GL_STATIC_DRAW);
       gl.BindBufferRange(GL_UNIFORM_BUFFER, 3, buffer, 256, static_cast<GLsizeiptr>(4 * words.size() - 256));
       gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "Own"), 3);
       setVec3(gl, program, "base", {0.9f, 0.6f, 0.3f});
     }},
    // The headlight of a program without any uniform for it but its colour, and constants for all else.
    {"constants",
     "in vec3 vertexMC, normalMC; uniform mat4 mvp; uniform mat3 turn; out vec3 n;\n"
     "void main() { n = turn * normalMC; gl_Position = mvp * vec4(vertexMC, 1); }\n",
     "in vec3 n; uniform vec3 glow; out vec4 color;\nvoid main() { vec3 m = normalize(n);\n"
     "  if (!gl_FrontFacing) m = -m;\n  float d = max(m.z, 0.0);\n"
     "  color = vec4(vec3(0.05) + glow * (d * vec3(0.2, 0.5, 0.7) + 0.25 * pow(d, 9.0)), 1); }\n",
     "vertex.normal = \"normalMC\"\ntransform.normal_matrix = \"turn\"\nnormals.flip_back_faces = true\n"
     "lights.color = \"glow\"\nmaterial.ambient_color = 0.05\nmaterial.diffuse_color = [0.2, 0.5, 0.7]\n"
     "material.specular_intensity = 0.25\nmaterial.shininess = 9\n",
     [](Gl gl, GLuint program) {
       setVec3(gl, program, "glow", {1, 0.9f, 0.8f});
       setMat3(gl, program, "turn", glm::mat3(perspectiveView(35).eyeFromObject));
       gl.Enable(GL_CULL_FACE), gl.CullFace(GL_FRONT);
     }},
};

void drawFamilyCase(Gl gl, const FamilyCase& c) {
  const std::string version = "#version 150\n";
  const ProgramMesh mesh = c.ball ? ball(24) : sheet(24);
  const GLuint program = makeProgram(gl, version + c.vertex, version + c.fragment);
  upload(gl, mesh, program);
  beginFrame(gl);
  gl.UseProgram(program);
  View view = perspectiveView(35);
  if (std::string(c.name) == "sun") view.eyeFromObject = glm::scale(view.eyeFromObject, {0.5, 1, 0.8});
  setMat4(gl, program, "mvp", glm::mat4(view.clipFromEye * view.eyeFromObject));
  setMat4(gl, program, "modelview", glm::mat4(view.eyeFromObject));
  c.set(gl, program);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

class ProgramFamily : public testing::TestWithParam<FamilyCase> {};

TEST_P(ProgramFamily, SaysWhatTheProgramComputes) {
  const FamilyCase& c = GetParam();
  std::string family = std::string(kHead) + c.family;
  if (std::string(c.name) == "blocks") family.replace(family.find("\"mvp\""), 5, "\"Own.mvp\"");
  expectBoth(
      c.name, [&](Gl gl) { drawFamilyCase(gl, c); }, 1, {}, kProgramTolerance, family);
}

INSTANTIATE_TEST_SUITE_P(Cases, ProgramFamily, testing::ValuesIn(kFamilyCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
