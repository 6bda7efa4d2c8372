// The shaders of polyscope's surface meshes, against the real OpenGL.
#include "tests/reference/programs/viewers/viewer_stage.h"

#include <gtest/gtest.h>

#include <ostream>

namespace gluray::test {
namespace {

// Follows each shader's own text.
const char* const kPolyscopeCommon = R"(
const vec3 RGB_TEAL     = vec3(0., 178./255., 178./255.);
float LARGE_FLOAT() { return 1e25; }
float length2(vec3 a) { return dot(a,a); }

vec3 lightSurfaceMat(vec3 normal, vec3 color, sampler2D t_mat_r, sampler2D t_mat_g, sampler2D t_mat_b, sampler2D t_mat_k) {

  // ensure color is in range [0,1]
  color = clamp(color, vec3(0.), vec3(1.));

  normal = normalize(normal);
  normal.y = -normal.y;
  normal *= 0.98; // pull slightly inward, to reduce sampling artifacts near edges
  vec2 matUV = normal.xy/2.0 + vec2(.5, .5);
  
  vec3 mat_r = texture(t_mat_r, matUV).rgb;
  vec3 mat_g = texture(t_mat_g, matUV).rgb;
  vec3 mat_b = texture(t_mat_b, matUV).rgb;
  vec3 mat_k = texture(t_mat_k, matUV).rgb;
  vec3 colorCombined = color.r * mat_r + color.g * mat_g + color.b * mat_b + 
                       (1. - color.r - color.g - color.b) * mat_k;

  return colorCombined;
}

vec3 fragmentViewPosition(vec4 viewport, vec2 depthRange, mat4 invProjMat, vec4 fragCoord) {
  vec4 ndcPos;
  ndcPos.xy = ((2.0 * fragCoord.xy) - (2.0 * viewport.xy)) / (viewport.zw) - 1;
  ndcPos.z = (2.0 * fragCoord.z - depthRange.x - depthRange.y) / (depthRange.y - depthRange.x);
  ndcPos.w = 1.0;

  vec4 clipPos = ndcPos / fragCoord.w;
  vec4 eyePos = invProjMat * clipPos;
  return eyePos.xyz / eyePos.w;
}
)";

enum class MatcapColor { uniform, vertices, map };
struct MatcapCase {
  const char* name;
  MatcapColor color = MatcapColor::uniform;
  bool flat = false, darkens = true, parallel = false;
};
void PrintTo(const MatcapCase& c, std::ostream* out) { *out << c.name; }

std::string polyscopeVertex(const MatcapCase& c) {
  const char* const more[] = {"", "          in vec3 a_color;\n          out vec3 a_colorToFrag;\n",
                              "          in float a_value;\n          out float a_valueToFrag;\n"};
  const char* const assign[] = {"", "a_colorToFrag = a_color;\n", "a_valueToFrag = a_value;\n"};
  const auto k = static_cast<size_t>(c.color);
  return std::string(
             "#version 330 core\nuniform mat4 u_modelView;\nuniform mat4 u_projMatrix;\nin uint a_faceInds;\n"
             "in vec3 a_vertexPositions;\nin vec3 a_vertexNormals;\nin vec3 a_barycoord;\n"
             "out vec3 a_barycoordToFrag;\nout vec3 a_vertexNormalToFrag;\n") +
         more[k] +
         "void main()\n{\n    gl_Position = u_projMatrix * u_modelView * vec4(a_vertexPositions,1.);\n"
         "    a_vertexNormalToFrag = mat3(u_modelView) * a_vertexNormals;\n"
         "    a_barycoordToFrag = a_barycoord;\n" +
         assign[k] + "}\n" + kPolyscopeCommon;
}

std::string polyscopeFragment(const MatcapCase& c) {
  const char* const declared[] = {"uniform vec3 u_baseColor;\n", "in vec3 a_colorToFrag;\n",
                                  ("in float a_valueToFrag;\nuniform float u_rangeHigh;\nuniform float "
                                   "u_rangeLow;\nuniform sampler1D t_colormap;\n")};
  const char* const value[] = {"", "vec3 shadeColor = a_colorToFrag;\n",
                               "float shadeValue = a_valueToFrag;\n"};
  const char* const shade[] = {"vec3 albedoColor = u_baseColor;\n", "vec3 albedoColor = shadeColor;\n",
                               ("float rangeTVal = (shadeValue - u_rangeLow) / (u_rangeHigh - u_rangeLow);\n"
                                "rangeTVal = clamp(rangeTVal, 0.f, 1.f);\n"
                                "vec3 albedoColor = texture(t_colormap, rangeTVal).rgb;\n")};
  const auto k = static_cast<size_t>(c.color);
  std::string text =
      "#version 330 core\nin vec3 a_vertexNormalToFrag;\nin vec3 a_barycoordToFrag;\n"
      "layout(location = 0) out vec4 outputF;\nuniform sampler2D t_mat_r;\nuniform sampler2D t_mat_g;\n"
      "uniform sampler2D t_mat_b;\nuniform sampler2D t_mat_k;\nvec3 lightSurfaceMat(vec3 normal, vec3 color, "
      "sampler2D "
      "t_mat_r, sampler2D t_mat_g, sampler2D t_mat_b, sampler2D t_mat_k);\n";
  text += declared[k];
  if (c.flat)
    text +=
        "vec3 fragmentViewPosition(vec4 viewport, vec2 depthRange, mat4 invProjMat, vec4 fragCoord);\n"
        "uniform mat4 u_invProjMatrix;\nuniform vec4 u_viewport;\n";
  text += "void main()\n{\n   float depth = gl_FragCoord.z;\n   // do nothing, for now\n";
  text += "   vec3 shadeNormal = a_vertexNormalToFrag;\n";
  text += value[k];
  if (c.flat)
    text +=
        "vec2 depthRange_fornormal = vec2(gl_DepthRange.near, gl_DepthRange.far);\n"
        "vec3 viewPos_fornormal = fragmentViewPosition(u_viewport, depthRange_fornormal, u_invProjMatrix, "
        "gl_FragCoord);\nshadeNormal = normalize(cross(dFdx(viewPos_fornormal),dFdy(viewPos_fornormal)));\n";
  text += shade[k];
  text += "if(!gl_FrontFacing) {\n  shadeNormal *= -1.;\n}\n";
  text += "vec3 litColor = lightSurfaceMat(shadeNormal, albedoColor, t_mat_r, t_mat_g, t_mat_b, t_mat_k);\n";
  text += "float alphaOut = 1.0;\n";
  if (c.darkens) text += "if(!gl_FrontFacing) {\n  litColor *= .7;\n}\n";
  return text + "litColor *= alphaOut; // premultiplied alpha\noutputF = vec4(litColor, alphaOut);\n}\n" +
         kPolyscopeCommon;
}

/// Smooth images of 32 x 32 floats, some above 1.
void matcapImages(Gl gl, GLuint program) {
  constexpr int kSize = 32;
  const char* const names[] = {"t_mat_r", "t_mat_g", "t_mat_b", "t_mat_k"};
  for (int k = 0; k < 4; ++k) {
    std::vector<glm::vec3> texels;
    for (int i = 0; i < kSize * kSize; ++i) {
      const float x = static_cast<float>(i % kSize) / kSize, y = static_cast<float>(i / kSize) / kSize;
      texels.emplace_back(k == 0 ? 1.2f * x : 0.2f * y, k == 1 ? 1 - 0.5f * x : 0.1f, k == 2 ? y : 0.3f * x);
    }
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(k));
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB16F, kSize, kSize, 0, GL_RGB, GL_FLOAT, texels.data());
    for (const GLenum what : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      gl.TexParameteri(GL_TEXTURE_2D, what, GL_LINEAR);
    for (const GLenum what : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      gl.TexParameteri(GL_TEXTURE_2D, what, GL_CLAMP_TO_EDGE);
    setInteger(gl, program, names[k], k);
  }
}

void valueMap(Gl gl, GLuint program) {
  const std::vector<glm::vec3> texels = {
      {0.2f, 0, 0.4f}, {0, 0.5f, 0.5f}, {0.4f, 0.8f, 0.2f}, {1, 0.9f, 0.1f}};
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.ActiveTexture(GL_TEXTURE4);
  gl.BindTexture(GL_TEXTURE_1D, name);
  gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGB32F, 4, 0, GL_RGB, GL_FLOAT, texels.data());
  for (const GLenum what : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_1D, what, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  setInteger(gl, program, "t_colormap", 4);
  setFloat(gl, program, "u_rangeLow", -0.7f), setFloat(gl, program, "u_rangeHigh", 0.8f);
}

DrawViewer drawPolyscope(const MatcapCase& c) {
  return [c](Gl gl, GLuint program) {
    beginFrame(gl);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // on, with an alpha of 1
    gl.UseProgram(program);
    const View view = c.parallel ? parallelView(35) : perspectiveView(35);
    setMat4(gl, program, "u_modelView", glm::mat4(view.eyeFromObject));
    setMat4(gl, program, "u_projMatrix", glm::mat4(view.clipFromEye));
    setMat4(gl, program, "u_invProjMatrix", glm::mat4(glm::inverse(view.clipFromEye)));
    const glm::vec4 viewport(0, 0, kProgramWidth, kProgramHeight);
    gl.Uniform4fv(gl.GetUniformLocation(program, "u_viewport"), 1, &viewport.x);
    setVec3(gl, program, "u_baseColor", {0.9f, 0.6f, 0.3f});
    matcapImages(gl, program), valueMap(gl, program);
    const Bowl bowl = bowlWithColors();
    const BowlDraw arrays(gl, bowl);
    std::vector<float> values;
    for (const glm::vec3& p : bowl.mesh.positions) values.push_back(p.x + 0.1f * p.y);
    setArray(gl, program, "a_vertexPositions", bowl.mesh.positions);
    setArray(gl, program, "a_vertexNormals", bowl.mesh.normals);
    setArray(gl, program, "a_color", bowl.colors), setArray(gl, program, "a_value", values);
    arrays.draw();
    gl.ActiveTexture(GL_TEXTURE0);
  };
}

const MatcapCase kMatcapCases[] = {
    {.name = "color"},
    {.name = "color_equal_sides", .darkens = false},
    {.name = "color_flat", .flat = true},
    {.name = "color_flat_equal_sides", .flat = true, .darkens = false},
    {.name = "color_flat_parallel", .flat = true, .parallel = true},
    {.name = "vertices", .color = MatcapColor::vertices},
    {.name = "vertices_flat", .color = MatcapColor::vertices, .flat = true},
    {.name = "map", .color = MatcapColor::map},
    {.name = "map_flat", .color = MatcapColor::map, .flat = true},
    {.name = "map_equal_sides", .color = MatcapColor::map, .darkens = false},
};

class PolyscopePrograms : public testing::TestWithParam<MatcapCase> {};

TEST_P(PolyscopePrograms, AreTraced) {
  const MatcapCase& c = GetParam();
  expectTraced(std::string("polyscope_") + c.name, polyscopeVertex(c), polyscopeFragment(c),
               drawPolyscope(c));
}
INSTANTIATE_TEST_SUITE_P(All, PolyscopePrograms, testing::ValuesIn(kMatcapCases),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(PolyscopePrograms, MutantsAreSeen) {
  for (const MatcapCase& c : {kMatcapCases[0], kMatcapCases[7]})
    expectViewerMutantsSeen(std::string("polyscope_") + c.name, polyscopeVertex(c), polyscopeFragment(c),
                            drawPolyscope(c));
}

}  // namespace
}  // namespace gluray::test
