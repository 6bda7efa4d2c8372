// Point Gaussian as in VTK since 9.4: a billboard from a ball's covariance in normalised device coordinates.
#include "tests/reference/programs/impostors/own_impostors.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gluray::test {
namespace {

const char* const kSplatsVertex =
    "#version 150\nuniform float scaleFactor; uniform int cameraParallel; uniform vec3 lowpassMatrix;\n"
    "in vec4 vertexMC; in float radiusMC; in vec4 scalarColor; out vec4 vertexColorVSOutput;\n"
    "out mat2 transformVCVSOutput; uniform mat4 VCDCMatrix; uniform mat4 MCVCMatrix;\n"
    "mat3 getProjectionMatrix(vec3 positionVC)\n{\n  if (cameraParallel != 0)\n  {\n    return mat3(\n"
    "      VCDCMatrix[0][0], 0., 0.,\n      0., VCDCMatrix[1][1], 0.,\n      0., 0., 0.);\n  }\n"
    "  return mat3(\n    VCDCMatrix[0][0] / positionVC.z, 0., 0.,\n    0., VCDCMatrix[1][1] / positionVC.z, "
    "0.,\n"
    "    -(VCDCMatrix[0][0] * positionVC.x) / (positionVC.z * positionVC.z), "
    "-(VCDCMatrix[1][1] * positionVC.y) / (positionVC.z * positionVC.z), 0.);\n}\n"
    "void main()\n{\n  vertexColorVSOutput = scalarColor;\n  vec4 posVC = MCVCMatrix * vertexMC;\n"
    "  mat3 J = getProjectionMatrix(posVC.xyz);\n  mat3 W = mat3(MCVCMatrix);\n  mat3 T = J * W;\n"
    "  float radius = scaleFactor * radiusMC;\nmat3 cov = (radius * radius) * T * transpose(T);\n"
    "  mat2 cov2d = mat2(cov);\n"
    "  cov2d += mat2(lowpassMatrix.x, lowpassMatrix.y, lowpassMatrix.y, lowpassMatrix.z);\n"
    "  if (abs(cov2d[0][1]) > 1e-6)\n  {\n    float halfTrace = 0.5 * (cov2d[0][0] + cov2d[1][1]);\n"
    "    float term = sqrt(halfTrace * halfTrace - determinant(cov2d));\n"
    "    float eigenValue1 = halfTrace + term;\n    float eigenValue2 = halfTrace - term;\n"
    "    vec2 eigenVector1 = normalize(vec2(eigenValue1 - cov2d[1][1], cov2d[0][1]));\n"
    "    vec2 eigenVector2 = vec2(eigenVector1.y, -eigenVector1.x);\n"
    "    transformVCVSOutput = mat2(sqrt(eigenValue1) * eigenVector1, sqrt(eigenValue2) * eigenVector2);\n"
    "  }\n  else\n  {\n"
    "    transformVCVSOutput = mat2(sqrt(cov2d[0][0]), 0.0, 0.0, sqrt(cov2d[1][1]));\n  }\n"
    "  vec4 posDC = VCDCMatrix * posVC;\n"
    "  if (posDC.x < -1.3*posDC.w || posDC.x > 1.3*posDC.w || posDC.y < -1.3*posDC.w || posDC.y > "
    "1.3*posDC.w)\n"
    "  {\n    transformVCVSOutput = mat2(0);\n  }\n  gl_Position = posDC;\n}\n";

const char* const kSplatsGeometry =
    "#version 150\nlayout(points) in;\nlayout(triangle_strip, max_vertices = 4) out;\n"
    "uniform float boundScale;\nin mat2 transformVCVSOutput[];\nout vec2 offsetVCGSOutput;\n"
    "in vec4 vertexColorVSOutput[]; out vec4 vertexColorGSOutput;\n"
    "void main()\n{\n  int i = 0;\n  vertexColorGSOutput = vertexColorVSOutput[i];\n"
    "  vec2 offsets[4] = vec2[](vec2(-boundScale, -boundScale),\n    vec2(boundScale, -boundScale),\n"
    "    vec2(-boundScale, boundScale),\n    vec2(boundScale, boundScale));\n"
    "  vec4 posNDC = gl_in[0].gl_Position;\n  posNDC = posNDC / posNDC.w;\n"
    "  for (int i = 0; i < 4; i++)\n  {\n    vec2 offset = transformVCVSOutput[0] * offsets[i];\n"
    "    offsetVCGSOutput = offsets[i];\n    gl_Position = vec4(posNDC.xy + offset, posNDC.zw);\n"
    "    EmitVertex();\n  }\n  EndPrimitive();\n}\n";

const char* const kFragment =
    "#version 150\nuniform float ambientIntensity, diffuseIntensity, opacityUniform;\n"
    "uniform float cOffset, cFactor; in vec2 offsetVCGSOutput; in vec4 vertexColorGSOutput; out vec4 "
    "fragOutput0;\n"
    "void main()\n{\n  float cscale = length(vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z)));\n"
    "  gl_FragDepth = gl_FragCoord.z + cFactor*cscale + 1.0*cOffset/65000.0;\n"
    "  vec3 ambientColor = ambientIntensity * vertexColorGSOutput.rgb;\n"
    "  vec3 diffuseColor = diffuseIntensity * vertexColorGSOutput.rgb;\n"
    "  float opacity = opacityUniform * vertexColorGSOutput.a;\n"
    "\nfloat dist = dot(offsetVCGSOutput.xy,offsetVCGSOutput.xy);\nif (dist > 1.0) {\n  discard;\n} else {\n"
    "  float scale = (1.0 - dist);\n  ambientColor *= scale;\n  diffuseColor *= scale;\n}\n"
    "  fragOutput0 = vec4(ambientColor + diffuseColor, opacity);\n"
    "  if (fragOutput0.a <= 0.0)\n    {\n    discard;\n    }\n}\n";

struct SplatCase {
  const char* name;
  bool parallel = false;
  glm::vec3 stretch{1};  // scale of object space
  float radius = 0.25f, field = 40, offset = 0, lowpass = 0, bounds = 2;
  bool flat = false;  // all centres in one plane that faces the viewer
  int draws = 1;
};
void PrintTo(const SplatCase& c, std::ostream* out) { *out << c.name; }

const SplatCase kSplatCases[] = {
    {.name = "splats"},
    {.name = "splats_parallel", .parallel = true},
    {.name = "splats_stretched", .stretch = {1.5f, 0.4f, 0.8f}},
    {.name = "splats_parallel_stretched", .parallel = true, .stretch = {1.5f, 0.4f, 0.8f}},
    // The farther from the middle, the longer they are.
    {.name = "splats_wide_angle", .radius = 0.2f, .field = 110},
    // Off-diagonal covariances below 1e-6.
    {.name = "splats_small", .stretch = {2, 0.5f, 1}, .radius = 0.006f},
    {.name = "splats_offset", .offset = -8},
    {.name = "splats_parallel_offset", .parallel = true, .offset = -8},
    {.name = "splats_in_one_plane", .flat = true},
    {.name = "splats_lowpass", .lowpass = 0.01f, .draws = 0},
    {.name = "splats_cut_by_their_cards", .bounds = 0.7f, .draws = 0},
    {.name = "splats_pushed_back", .offset = 5, .draws = 0},
};

void drawSplatCase(Gl gl, const SplatCase& c) {
  const GLuint program = linkImpostors(gl, kSplatsVertex, kSplatsGeometry, kFragment);
  GLuint array = 0;
  gl.GenVertexArrays(1, &array), gl.BindVertexArray(array);
  std::vector<float> places, colors, radii;
  for (int i = 0; i < kImpostors; ++i) {
    const auto t = static_cast<float>(i);
    for (const float v : {std::sin(1.7f * t), std::sin(2.3f * t + 1), c.flat ? 0 : std::cos(0.9f * t)})
      places.push_back(v);
    for (const float v : {1.0f, 0.5f + 0.5f * std::sin(t), 0.3f, 1.0f}) colors.push_back(v);
    radii.push_back(1 + 0.5f * std::sin(5 * t));
  }
  addImpostorValues(gl, program, "vertexMC", 3, places),
      addImpostorValues(gl, program, "scalarColor", 4, colors);
  addImpostorValues(gl, program, "radiusMC", 1, radii);
  View view = c.parallel ? parallelView(35) : perspectiveView(c.flat ? 0 : 35);
  if (!c.parallel) view.clipFromEye = glm::perspective(glm::radians(double{c.field}), 4.0 / 3, 1.0, 10.0);
  view.eyeFromObject = glm::scale(view.eyeFromObject, glm::dvec3(c.stretch));
  beginFrame(gl);
  gl.UseProgram(program);
  setMat4(gl, program, "VCDCMatrix", glm::mat4(view.clipFromEye));
  setMat4(gl, program, "MCVCMatrix", glm::mat4(view.eyeFromObject));
  setInteger(gl, program, "cameraParallel", c.parallel);
  setFloat(gl, program, "scaleFactor", c.radius), setFloat(gl, program, "boundScale", c.bounds);
  setVec3(gl, program, "lowpassMatrix", {c.lowpass, 0, c.lowpass});
  setFloat(gl, program, "cOffset", c.offset), setFloat(gl, program, "cFactor", 2);
  setFloat(gl, program, "ambientIntensity", 0.1f), setFloat(gl, program, "diffuseIntensity", 0.8f);
  setFloat(gl, program, "opacityUniform", 1);
  gl.DrawArrays(GL_POINTS, 0, kImpostors);
}

class ProgramSplats : public testing::TestWithParam<SplatCase> {};

TEST_P(ProgramSplats, AreWhatTheProgramComputes) {
  expectBoth(
      GetParam().name, [](Gl gl) { drawSplatCase(gl, GetParam()); }, GetParam().draws);
}

INSTANTIATE_TEST_SUITE_P(Cases, ProgramSplats, testing::ValuesIn(kSplatCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
