// Surfaces with edges, painted by VTK's geometry shader.
#include "tests/reference/programs/program_stage.h"
#include "tests/support/edges_text.h"
#include "tests/support/replaced_text.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

const char* const kEdgesGeometry =
    "#version 150\nuniform int PrimitiveIDOffset;\nin vec4 vertexVCVSOutput[];\nout vec4 vertexVCGSOutput;\n"
    "in vec3 normalVCVSOutput[];\nout vec3 normalVCGSOutput;\n"
    "layout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n"
    "uniform vec4 vpDims;\nout vec4 edgeEqn[3];\nuniform float lineWidth;\nuniform samplerBuffer "
    "edgeTexture;\n"
    "void main()\n{\n  vec2 pos[4];\n  for (int i = 0; i < 3; i++)\n  {\n"
    "    pos[i] = gl_in[i].gl_Position.xy/gl_in[i].gl_Position.w;\n"
    "    pos[i] = pos[i]*vec2(0.5) + vec2(0.5);\n    pos[i] = pos[i]*vpDims.zw + vpDims.xy;\n  }\n"
    "  pos[3] = pos[0];\n"
    "  float ccw = sign(cross(vec3(pos[1] - pos[0], 0.0), vec3(pos[2] - pos[0], 0.0)).z);\n"
    "  for (int i = 0; i < 3; i++)\n  {\n    vec2 tmp = normalize(pos[i+1] - pos[i]);\n"
    "    tmp = ccw*vec2(-tmp.y, tmp.x);\n    float d = dot(pos[i], tmp);\n"
    "    edgeEqn[i] = vec4(tmp.x, tmp.y, 0.0, -d);\n  }\n  vec2 offsets[3];\n"
    "  offsets[0] = edgeEqn[2].xy + edgeEqn[0].xy;\n  offsets[0] = -0.5*normalize(offsets[0])*lineWidth;\n"
    "  offsets[0] /= vpDims.zw;\n  offsets[1] = edgeEqn[0].xy + edgeEqn[1].xy;\n"
    "  offsets[1] = -0.5*normalize(offsets[1])*lineWidth;\n  offsets[1] /= vpDims.zw;\n"
    "  offsets[2] = edgeEqn[1].xy + edgeEqn[2].xy;\n  offsets[2] = -0.5*normalize(offsets[2])*lineWidth;\n"
    "  offsets[2] /= vpDims.zw;\n"
    "  float edgeValues = 255.0*texelFetch(edgeTexture, gl_PrimitiveIDIn + PrimitiveIDOffset).r;\n"
    "  if (edgeValues < 4.0) edgeEqn[2].z = lineWidth;\n"
    "  if (mod(edgeValues, 4.0) < 2.0) edgeEqn[1].z = lineWidth;\n"
    "  if (mod(edgeValues, 2.0) < 1.0) edgeEqn[0].z = lineWidth;\n"
    "  for (int i = 0; i < 3; i++)\n    {\n    gl_PrimitiveID = gl_PrimitiveIDIn;\n"
    "    normalVCGSOutput = normalVCVSOutput[i];\n    vertexVCGSOutput = vertexVCVSOutput[i];\n"
    "    gl_Position = gl_in[i].gl_Position;\n"
    "    gl_Position.xy = gl_Position.xy + offsets[i]*gl_Position.w;\n    EmitVertex();\n    }\n"
    "  EndPrimitive();\n}\n";

/// VTK's variants: 9.1's, 9.1's of strips, whose edges are all painted, 9.3's with an opacity, and since 9.4
/// corners that stay.
enum class EdgeWay { opaque, all, faint, corners };

std::string without(std::string text, const std::string& from, const std::string& to) {
  const size_t start = text.find(from), end = text.find(to, start);
  EXPECT_NE(end, std::string::npos);
  return text.erase(start, end - start);
}

std::string geometryText(EdgeWay way) {
  if (way == EdgeWay::all)
    return without(without(kEdgesGeometry, "uniform samplerBuffer", "void main"), "  float edgeValues",
                   "  for (int i = 0; i < 3; i++)\n    {");
  if (way != EdgeWay::corners) return kEdgesGeometry;
  std::string text = without(kEdgesGeometry, "  vec2 offsets[3];", "  float edgeValues");
  text = without(text, "    gl_Position.xy = ", "    EmitVertex");
  return text.replace(text.find("out vec4 edgeEqn"), 3, "noperspective out");
}

std::string edgedFragmentText(EdgeWay way) {
  std::string text = afterGeometry(fragmentText(Surface{.lightCount = 2}));
  text.insert(text.find("void main()"),
              "in vec4 edgeEqn[3];\nuniform float lineWidth;\nuniform vec3 edgeColor;\n");
  if (way == EdgeWay::faint || way == EdgeWay::corners)
    text.insert(text.find("void main()"), "uniform float edgeOpacity;\n");
  if (way == EdgeWay::corners) text.replace(text.find("in vec4 edgeEqn"), 2, "noperspective in");
  std::string painting = edgePainting();
  if (way == EdgeWay::opaque || way == EdgeWay::all) painting = replacedInAll(painting, " * edgeOpacity", "");
  return text.insert(text.find("  vec3 normalVCGSOutput = normalize"), painting);
}

/// Compiles and links the three shaders.
GLuint makeEdged(Gl gl, EdgeWay way) {
  const GLuint program =
      makeProgram(gl, vertexText(Surface{.lightCount = 2}), fragmentText(Surface{.lightCount = 2}));
  GLuint shaders[2] = {};
  gl.GetAttachedShaders(program, 2, nullptr, shaders);
  for (const GLuint shader : shaders) gl.DetachShader(program, shader);
  const std::string texts[] = {vertexText(Surface{.lightCount = 2}), geometryText(way),
                               edgedFragmentText(way)};
  const GLenum kinds[] = {GL_VERTEX_SHADER, GL_GEOMETRY_SHADER, GL_FRAGMENT_SHADER};
  for (int i = 0; i < 3; ++i) {
    const GLuint shader = gl.CreateShader(kinds[i]);
    const char* start = texts[i].c_str();
    gl.ShaderSource(shader, 1, &start, nullptr);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
  }
  gl.LinkProgram(program);
  GLint linked = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  EXPECT_TRUE(linked);
  return program;
}

void edgeFlags(Gl gl, const std::vector<uint8_t>& flags, int unit) {
  GLuint buffer = 0, texture = 0;
  gl.GenBuffers(1, &buffer), gl.GenTextures(1, &texture);
  gl.BindBuffer(GL_TEXTURE_BUFFER, buffer);
  gl.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(flags.size()), flags.data(), GL_STATIC_DRAW);
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(GL_TEXTURE_BUFFER, texture);
  gl.TexBuffer(GL_TEXTURE_BUFFER, GL_R8, buffer);
  gl.ActiveTexture(GL_TEXTURE0);
}

/// Draws the mesh with edges of that width; every third triangle lacks one of them.
void drawEdged(Gl gl, const ProgramMesh& mesh, float width, const View& view, EdgeWay way = EdgeWay::opaque,
               float opacity = 1) {
  const GLuint program = makeEdged(gl, way);
  const Upload up = upload(gl, mesh, program);
  std::vector<uint8_t> flags(mesh.triangles(), 7);
  for (size_t i = 0; i < flags.size(); i += 3) flags[i] = static_cast<uint8_t>(7 ^ 1 << i % 3);
  edgeFlags(gl, flags, 2);
  beginFrame(gl);
  gl.UseProgram(program);
  setAll(gl, program, view, Surface{.lightCount = 2});
  setInteger(gl, program, "edgeTexture", 2);
  setFloat(gl, program, "lineWidth", width);
  setFloat(gl, program, "edgeOpacity", opacity);
  setVec3(gl, program, "edgeColor", {0.8f, 0.1f, 0.1f});
  const GLint location = gl.GetUniformLocation(program, "vpDims");
  const GLfloat viewport[] = {0, 0, kProgramWidth, kProgramHeight};
  gl.Uniform4fv(location, 1, viewport);
  gl.BindVertexArray(up.array);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

constexpr scenes::Tolerance kEdgeTolerance = {
    8, 0.003, 1e-4f, "outlines; which of two triangles that grow over each other is nearer is rounding"};

TEST(ProgramEdges, ThinLines) {
  expectBoth(
      "edges_thin", [](Gl gl) { drawEdged(gl, sheet(8), 1, perspectiveView(30)); }, 1, {}, kEdgeTolerance);
}

TEST(ProgramEdges, WideLinesGrowBeyondTheOutline) {
  expectBoth(
      "edges_wide", [](Gl gl) { drawEdged(gl, ball(8), 4, perspectiveView(30)); }, 1, {}, kEdgeTolerance);
}

TEST(ProgramEdges, InParallelProjection) {
  expectBoth(
      "edges_parallel", [](Gl gl) { drawEdged(gl, ball(10), 2, parallelView(50)); }, 1, {}, kEdgeTolerance);
}

TEST(ProgramEdges, Faint) {
  for (const float opacity : {1.0f, 0.4f, 0.0f})
    expectBoth(
        "edges_faint",
        [&](Gl gl) { drawEdged(gl, sheet(8), 3, perspectiveView(30), EdgeWay::faint, opacity); }, 1, {},
        kEdgeTolerance);
}

TEST(ProgramEdges, BetweenCornersThatStay) {
  for (const float width : {1.0f, 4.0f})
    for (const View& view : {perspectiveView(30), parallelView(50)})
      expectBoth(
          "edges_staying", [&](Gl gl) { drawEdged(gl, ball(8), width, view, EdgeWay::corners, 0.7f); }, 1);
}

/// Programs of support/edges_text.h.
void drawOther(Gl gl, const Surface& surface, float opacity) {
  const ProgramMesh mesh = ball(8);
  const GLuint program = makeProgram(gl, surface);
  const Upload up = upload(gl, mesh, program);
  beginFrame(gl);
  gl.UseProgram(program);
  setAll(gl, program, perspectiveView(30), surface);
  setFloat(gl, program, "opacityUniform", opacity);
  gl.BindVertexArray(up.array);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

TEST(ProgramEdges, BetweenCornersOfOtherSurfaces) {
  using Lights = Surface::Lights;
  for (const Lights lights : {Lights::none, Lights::directional, Lights::pbr})
    for (const bool recent : {false, true})
      for (const float opacity : {1.0f, 0.5f}) {
        const Surface surface{.lights = lights, .recent = recent, .edges = true};
        expectBoth(
            "edges_of_others", [&](Gl gl) { drawOther(gl, surface, opacity); }, 1, coreWish());
      }
}

TEST(ProgramEdges, AllOfThem) {
  expectBoth(
      "edges_all", [](Gl gl) { drawEdged(gl, ball(8), 3, perspectiveView(30), EdgeWay::all); }, 1, {},
      kEdgeTolerance);
}

/// A ball that is compressed to a needle thinner than a pixel: its edges alone make it visible.
TEST(ProgramEdges, ThinnerThanAPixel) {
  for (const float radius : {0.02f, 0.004f, 0.0005f}) {
    ProgramMesh tube = ball(8);
    for (glm::vec3& p : tube.positions) p.x *= radius, p.y *= radius;
    for (const float width : {1.0f, 3.0f})
      for (const View& view : {perspectiveView(30), parallelView(50)})
        expectBoth(
            "edges_needle", [&](Gl gl) { drawEdged(gl, tube, width, view); }, 1, {}, kEdgeTolerance);
  }
}

TEST(ProgramEdges, PartlyBehindTheViewer) {
  for (const double near : {2.4, 2.9, 3.2}) {
    View view = perspectiveView(30);
    view.eyeFromObject = glm::translate(glm::dmat4(1), {0, 0, near}) * view.eyeFromObject;
    expectBoth(
        "edges_inside", [&](Gl gl) { drawEdged(gl, ball(8), 2, view); }, 1, {}, kEdgeTolerance);
  }
}

TEST(ProgramEdges, CulledOnesHideNothing) {
  for (const GLenum face : {GL_FRONT, GL_BACK}) {
    expectSame(
        "edges_culled",
        [&](Gl gl) {
          gl.Enable(GL_CULL_FACE), gl.CullFace(face);
          drawEdged(gl, ball(8), 2, perspectiveView(30));
        },
        1);
  }
}

}  // namespace
}  // namespace gluray::test
