#include "tests/reference/programs/impostors/point_gaussian.h"

#include <glm/gtc/matrix_transform.hpp>

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

const char* const kDiscsVertex =
    "#version 150\nin vec4 vertexMC; in float radiusMC; out float radiusVCVSOutput; in vec4 scalarColor; out "
    "vec4 "
    "vertexColorVSOutput; uniform mat4 VCDCMatrix; uniform mat4 MCVCMatrix;\n"
    "void main()\n{\n  vertexColorVSOutput = scalarColor;\n  radiusVCVSOutput = radiusMC;\n"
    "  gl_Position = MCVCMatrix * vertexMC;\n}\n";

/// One corner of a disc's triangle.
std::string cornerText(const char* offset) {
  return std::string("  offset = vec4(") + offset +
         ", 0.0, 0.0);\n  offsetVCGSOutput = offset.xy/radius;\n"
         "  gl_Position = VCDCMatrix * (gl_in[0].gl_Position + offset.x*base1 + offset.y*base2);\n"
         "  EmitVertex();\n";
}

std::string discsGeometry() {
  return "#version 150\nlayout(points) in;\nlayout(triangle_strip, max_vertices = 3) out;\n"
         "uniform int cameraParallel; uniform float triangleScale; uniform mat4 VCDCMatrix;\n"
         "in float radiusVCVSOutput[]; out vec2 offsetVCGSOutput;\n"
         "in vec4 vertexColorVSOutput[]; out vec4 vertexColorGSOutput;\n"
         "void main()\n{\n  float radius = radiusVCVSOutput[0]/triangleScale;\n  int i = 0;\n  vec4 offset;\n"
         "  vec4 base1 = vec4(1.0,0.0,0.0,0.0);\n  vec4 base2 = vec4(0.0,1.0,0.0,0.0);\n"
         "  if (cameraParallel == 0)\n  {\n    vec3 dir = normalize(-gl_in[0].gl_Position.xyz);\n"
         "    base2 = vec4(normalize(cross(dir,vec3(1.0,0.0,0.0))), 0.0);\n"
         "    base1 = vec4(cross(base2.xyz,dir),0.0);\n  }\n  vertexColorGSOutput = "
         "vertexColorVSOutput[i];\n" +
         cornerText("-1.73205*radiusVCVSOutput[0], -radiusVCVSOutput[0]") +
         cornerText("1.73205*radiusVCVSOutput[0], -radiusVCVSOutput[0]") +
         cornerText("0.0, 2.0*radiusVCVSOutput[0]") + "  EndPrimitive();\n}\n";
}

const char* const kRoundLook =
    "\nfloat dist = dot(offsetVCGSOutput.xy,offsetVCGSOutput.xy);\nif (dist > 1.0) {\n  discard;\n} else {\n"
    "  float scale = (1.0 - dist);\n  ambientColor *= scale;\n  diffuseColor *= scale;\n}\n";
const char* const kGaussianLook =
    "  float dist2 = dot(offsetVCGSOutput.xy,offsetVCGSOutput.xy);\n  float gaussian = exp(-0.5*dist2);\n"
    "  opacity = opacity*gaussian;\n";

const char* const kSpriteLook =
    "\nfloat dist = sdCircle(offsetVCVSOutput, 1.0);\nopacity = fill(dist);\n"
    "diffuseColor *= clamp(-dist, 0.0, 1.0);\n";
const char* const kOutlineLook = "\nopacity = stroke(sdCircle(offsetVCVSOutput, 1.0), 2.0);\n";
const char* const kOutlineFunctions =
    "float stroke(float sd, float thickness)\n{\n    float w = fwidth(sd);\n    float halfStroke = 0.5 * "
    "thickness * w;\n    return 1.0 - smoothstep(halfStroke - w, halfStroke + w, abs(sd));\n}\n";
const char* const kSpriteFunctions =
    "float sdCircle(vec2 p, float radius)\n{\n  return length(p) - radius;\n}\n"
    "float fill(float sd)\n{\n    float w = fwidth(sd);\n    return 1.0 - smoothstep(0.0, w, sd);\n}\n";

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// The splats' vertex shader with the billboards' corners.
std::string instancesVertex() {
  std::string text = kSplatsVertex;
  replaceAll(text, "out mat2 transformVCVSOutput;",
             "uniform float boundScale; out vec2 offsetVCVSOutput; flat out int instanceId;");
  replaceAll(text, "  if (abs(cov2d", "  mat2 transform;\n  if (abs(cov2d");
  replaceAll(text, "transformVCVSOutput", "transform");
  replaceAll(text, "  gl_Position = posDC;\n",
             "  vec2 offsets[4] = vec2[](vec2(-boundScale, -boundScale), vec2(boundScale, -boundScale),\n"
             "    vec2(-boundScale, boundScale), vec2(boundScale, boundScale));\n"
             "  offsetVCVSOutput = offsets[gl_VertexID % 4];\n  vec4 posNDC = posDC;\n"
             "  posNDC = posNDC / posNDC.w;\n"
             "  gl_Position = vec4(posNDC.xy + transform * offsetVCVSOutput, posNDC.zw);\n"
             "  instanceId = gl_InstanceID;\n");
  return text;
}

/// Without the colours that the fragment shader does not read.
std::string withoutColors(std::string text) {
  for (const char* part :
       {"  vertexColorVSOutput = scalarColor;\n", "  vertexColorGSOutput = vertexColorVSOutput[i];\n"})
    if (const size_t at = text.find(part); at != std::string::npos) text.erase(at, std::string(part).size());
  return text;
}

}  // namespace

std::string vertexText(const PointGaussian& points) {
  const std::string text = points.instances ? instancesVertex()
                           : points.splats  ? kSplatsVertex
                                            : kDiscsVertex;
  if (points.oneColor) return withoutColors(text);
  std::string more = text;
  if (points.fromZero)
    replaceAll(more, "  vertexColorVSOutput = scalarColor;\n",
               "  vertexColorVSOutput = scalarColor;\n"
               "  vertexColorVSOutput.rgb = max(vertexColorVSOutput.rgb, vec3(0.));\n");
  return more;
}

std::string geometryText(const PointGaussian& points) {
  if (points.instances) return "";
  const std::string text = points.splats ? kSplatsGeometry : discsGeometry();
  return points.oneColor ? withoutColors(text) : text;
}

std::string fragmentText(const PointGaussian& points) {
  const auto rgb = [&](const std::string& of) {
    return points.oneColor ? of + "ColorUniform" : "vertexColorGSOutput.rgb";
  };
  std::string text =
      "#version 150\nuniform float ambientIntensity, diffuseIntensity, opacityUniform;\n"
      "uniform vec3 ambientColorUniform, diffuseColorUniform; uniform float cOffset, cFactor;\n"
      "in vec2 offsetVCGSOutput; in vec4 vertexColorGSOutput; out vec4 fragOutput0;\n";
  if (points.sums) text += "out vec4 fragOutput1;\n";
  const bool outline = points.look == PointGaussian::Look::outline;
  if (outline || points.look == PointGaussian::Look::sprite) text += kSpriteFunctions;
  if (outline) text += kOutlineFunctions;
  text += "void main()\n{\n";
  if (points.splats)
    text +=
        "  float cscale = length(vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z)));\n"
        "  gl_FragDepth = gl_FragCoord.z + cFactor*cscale + 1.0*cOffset/65000.0;\n";
  text += "  vec3 ambientColor = ambientIntensity * " + rgb("ambient") +
          ";\n  vec3 diffuseColor = diffuseIntensity * " + rgb("diffuse") +
          ";\n  float opacity = opacityUniform" + (points.oneColor ? "" : " * vertexColorGSOutput.a") + ";\n";
  using Look = PointGaussian::Look;
  text += points.look == Look::round    ? kRoundLook
          : points.look == Look::sprite ? kSpriteLook
          : outline                     ? kOutlineLook
                                        : kGaussianLook;
  text +=
      "  fragOutput0 = vec4(ambientColor + diffuseColor, opacity);\n"
      "  if (fragOutput0.a <= 0.0)\n    {\n    discard;\n    }\n";
  if (points.sums)
    text +=
        "  fragOutput0 = vec4(fragOutput0.rgb*fragOutput0.a, fragOutput0.a);\n"
        "  fragOutput1.r = fragOutput0.a;\n";
  if (points.instances)
    replaceAll(text, "offsetVCGSOutput", "offsetVCVSOutput"),
        replaceAll(text, "vertexColorGSOutput", "vertexColorVSOutput");
  return text + "}\n";
}

void preparePointGaussian(Gl gl, GLuint program, const PointGaussian& points, const PointGaussianView& v) {
  GLuint array = 0;
  gl.GenVertexArrays(1, &array), gl.BindVertexArray(array);
  std::vector<float> places, colors, radii;
  for (int i = 0; i < kImpostors; ++i) {
    const auto t = static_cast<float>(i);
    for (const float p : {std::sin(1.7f * t), std::sin(2.3f * t + 1), v.flat ? 0 : std::cos(0.9f * t)})
      places.push_back(p);
    for (const float c : {1.0f, 0.5f + 0.5f * std::sin(t), v.blue, v.alpha}) colors.push_back(c);
    radii.push_back((1 + 0.5f * std::sin(5 * t)) * (points.splats ? 1 : v.radius));
  }
  addImpostorValues(gl, program, "vertexMC", 3, places);
  addImpostorValues(gl, program, "scalarColor", 4, colors);
  addImpostorValues(gl, program, "radiusMC", 1, radii);
  for (const char* name : {"vertexMC", "scalarColor", "radiusMC"})
    if (const GLint at = gl.GetAttribLocation(program, name); points.instances && at >= 0)
      gl.VertexAttribDivisor(static_cast<GLuint>(at), 1);
  View view = v.parallel ? parallelView(35) : perspectiveView(v.flat ? 0 : 35);
  if (!v.parallel) view.clipFromEye = glm::perspective(glm::radians(double{v.field}), 4.0 / 3, 1.0, 10.0);
  view.eyeFromObject = glm::scale(view.eyeFromObject, glm::dvec3(v.stretch));
  gl.UseProgram(program);
  setMat4(gl, program, "VCDCMatrix", glm::mat4(view.clipFromEye));
  setMat4(gl, program, "MCVCMatrix", glm::mat4(view.eyeFromObject));
  setInteger(gl, program, "cameraParallel", v.parallel);
  setFloat(gl, program, "scaleFactor", v.radius), setFloat(gl, program, "boundScale", v.bounds);
  setFloat(gl, program, "triangleScale", v.bounds);
  setVec3(gl, program, "lowpassMatrix", {v.lowpass, 0, v.lowpass});
  setFloat(gl, program, "cOffset", v.offset), setFloat(gl, program, "cFactor", 2);
  setFloat(gl, program, "ambientIntensity", v.ambient), setFloat(gl, program, "diffuseIntensity", 0.8f);
  setVec3(gl, program, "ambientColorUniform", {1, 0.8f, 0.6f});
  setVec3(gl, program, "diffuseColorUniform", {0.9f, 0.5f, 0.3f});
  setFloat(gl, program, "opacityUniform", v.opacity);
}

void drawPrepared(Gl gl, const PointGaussian& points) {
  if (points.instances)
    gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, kImpostors);
  else
    gl.DrawArrays(GL_POINTS, 0, kImpostors);
}

void drawPointGaussian(Gl gl, const PointGaussian& points, const PointGaussianView& view) {
  const GLuint program = linkImpostors(gl, vertexText(points), geometryText(points), fragmentText(points));
  beginFrame(gl);
  preparePointGaussian(gl, program, points, view);
  drawPrepared(gl, points);
}

}  // namespace gluray::test
