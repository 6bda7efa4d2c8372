// Instances that VTK's glyph mapper places and colours, cut by planes, against the real OpenGL.
#include "tests/reference/programs/program_mutants.h"
#include "tests/reference/programs/program_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gluray::test {
namespace {

const char* const kGlyphVertex = R"(#version 150
in vec4 vertexMC; in vec3 normalMC; in mat4 GCMCMatrix; in mat3 glyphNormalMatrix; in vec4 glyphColor;
uniform mat4 MCDCMatrix; uniform mat4 MCVCMatrix; uniform mat3 normalMatrix;
uniform int numClipPlanes; uniform vec4 clipPlanes[6]; out float clipDistancesVSOutput[6];
out vec4 vertexVCVSOutput; out vec4 vertexColorVSOutput; out vec3 normalVCVSOutput;
void main()
{
  vec4 vertex = GCMCMatrix * vertexMC;
  for (int planeNum = 0; planeNum < numClipPlanes; planeNum++)
    {
    clipDistancesVSOutput[planeNum] = dot(clipPlanes[planeNum], vertex);
    }
  vertexColorVSOutput = glyphColor;
  normalVCVSOutput = normalMatrix * glyphNormalMatrix * normalMC;
  vertexVCVSOutput = MCVCMatrix * vertex;
  gl_Position = MCDCMatrix * vertex;
}
)";
const char* const kGlyphFragment = R"(#version 150
uniform float ambientIntensity, diffuseIntensity, opacityUniform, specularIntensity, specularPowerUniform;
uniform vec3 ambientColorUniform, diffuseColorUniform, specularColorUniform, lightColor0;
uniform int numClipPlanes; in float clipDistancesVSOutput[6];
in vec4 vertexVCVSOutput; in vec4 vertexColorVSOutput; in vec3 normalVCVSOutput;
out vec4 fragOutput0;
void main()
{
  for (int planeNum = 0; planeNum < numClipPlanes; planeNum++)
    {
    if (clipDistancesVSOutput[planeNum] < 0.0) discard;
    }
  vec3 specularColor = specularIntensity * specularColorUniform;
  float specularPower = specularPowerUniform;
  vec3 ambientColor = ambientIntensity * ambientColorUniform;
  vec3 diffuseColor = diffuseIntensity * diffuseColorUniform;
  float opacity = opacityUniform;
  diffuseColor = diffuseIntensity * vertexColorVSOutput.rgb;
  ambientColor = ambientIntensity * vertexColorVSOutput.rgb;
  opacity = opacity * vertexColorVSOutput.a;
  vec3 normalVCVSOutput = normalize(normalVCVSOutput);
  if (gl_FrontFacing == false) { normalVCVSOutput = -normalVCVSOutput; }
  float df = max(0.0, normalVCVSOutput.z);
  float sf = pow(df, specularPower);
  vec3 diffuse = df * diffuseColor * lightColor0;
  vec3 specular = sf * specularColor * lightColor0;
  fragOutput0 = vec4(ambientColor + diffuse + specular, opacity);
  if (fragOutput0.a <= 0.0)
    {
    discard;
    }
}
)";

constexpr int kGlyphs = 12;

/// An attribute with one value of `columns` vectors of `rows` numbers for each glyph.
void addGlyphValues(Gl gl, GLuint program, const char* name, int columns, int rows,
                    const std::vector<float>& values) {
  const GLint location = gl.GetAttribLocation(program, name);
  if (location < 0) return;  // a mutant does not read it
  makeBuffer(gl, GL_ARRAY_BUFFER, values);
  for (int k = 0; k < columns; ++k) {
    const auto at = static_cast<GLuint>(location + k);
    const auto offset = static_cast<size_t>(k * rows) * sizeof(float);
    gl.EnableVertexAttribArray(at);
    gl.VertexAttribPointer(at, rows, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(columns * rows * 4),
                           reinterpret_cast<const void*>(offset));
    gl.VertexAttribDivisor(at, 1);
  }
}

void addGlyphs(Gl gl, GLuint program) {
  std::vector<float> places, turns, colors;
  const auto append = [](std::vector<float>& to, const float* from, int count) {
    to.insert(to.end(), from, from + count);
  };
  for (int i = 0; i < kGlyphs; ++i) {
    const auto t = static_cast<float>(i);
    glm::mat4 place =
        glm::translate(glm::mat4(1), {std::sin(1.9f * t), std::sin(2.6f * t + 1), std::cos(1.3f * t)});
    place = glm::rotate(place, t, glm::vec3(0.6f, 0.8f, 0));
    place = glm::scale(place, glm::vec3(0.45f, 0.3f, 0.6f));
    const glm::mat3 turn = glm::transpose(glm::inverse(glm::mat3(place)));
    append(places, &place[0].x, 16), append(turns, &turn[0].x, 9);
    const glm::vec4 color(0.5f + 0.5f * std::sin(t), 0.4f, 0.5f + 0.5f * std::cos(t), 1);
    append(colors, &color.x, 4);
  }
  addGlyphValues(gl, program, "GCMCMatrix", 4, 4, places);
  addGlyphValues(gl, program, "glyphNormalMatrix", 3, 3, turns);
  addGlyphValues(gl, program, "glyphColor", 1, 4, colors);
}

void drawGlyphs(Gl gl, GLuint program, int planes, float opacity = 1) {
  const ProgramMesh mesh = ball(10);
  upload(gl, mesh, program);
  const View view = perspectiveView(35);
  addGlyphs(gl, program);
  beginFrame(gl);
  setAll(gl, program, view, Surface{});
  const glm::vec4 of[] = {{0.8f, 0.3f, 0.5f, 0.2f}, {-0.3f, 0.9f, 0, 0.3f}};
  gl.Uniform4fv(gl.GetUniformLocation(program, "clipPlanes"), 2, &of[0].x);
  setInteger(gl, program, "numClipPlanes", planes), setFloat(gl, program, "opacityUniform", opacity);
  gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, kGlyphs);
}

TEST(ProgramGlyphs, AreCutWhereTheyStand) {
  for (const int planes : {0, 1, 2})
    expectBoth(
        "glyphs_cut_by_" + std::to_string(planes),
        [&](Gl gl) {
          const GLuint program = makeProgram(gl, kGlyphVertex, kGlyphFragment);
          gl.UseProgram(program);
          drawGlyphs(gl, program, planes);
        },
        1, coreWish(3, 3));
}

/// Planes of the glyph's own space: no family describes that.
TEST(ProgramGlyphs, ThatAreCutBeforeTheyArePlacedAreRasterised) {
  std::string vertex = kGlyphVertex;
  const std::string placed = "dot(clipPlanes[planeNum], vertex)";
  vertex.replace(vertex.find(placed), placed.size(), "dot(clipPlanes[planeNum], vertexMC)");
  expectSame(
      "glyphs_cut_before",
      [&](Gl gl) {
        const GLuint program = makeProgram(gl, vertex, kGlyphFragment);
        gl.UseProgram(program);
        drawGlyphs(gl, program, 2);
      },
      0, coreWish(3, 3));
}

TEST(ProgramGlyphs, MutantsAreNotTakenForThem) {
  expectMutantsSeen(
      "glyphs_cut", {{GL_VERTEX_SHADER, kGlyphVertex}, {GL_FRAGMENT_SHADER, kGlyphFragment}},
      [](Gl gl, GLuint program) {
        gl.UseProgram(program);
        drawGlyphs(gl, program, 2);
      },
      coreWish(3, 3));
}

}  // namespace
}  // namespace gluray::test
