// State with which programs of families with gl_Vertex are left to the real OpenGL, and passes over what they
// draw.
#include "tests/reference/programs/built_in/built_in_stage.h"

#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

struct BuiltInStateCase {
  const char* name;
  const ShaderPair* shaders;
  void (*set)(Gl gl, GLuint program);
  int traced = 0;
};
void PrintTo(const BuiltInStateCase& c, std::ostream* out) { *out << c.name; }

const BuiltInStateCase kBuiltInStateCases[] = {
    {"flat", &kShaded, [](Gl gl, GLuint) { gl.ShadeModel(GL_FLAT); }},
    {"two_sided", &kShaded, [](Gl gl, GLuint) { gl.Enable(GL_VERTEX_PROGRAM_TWO_SIDE); }},
    {"unclamped", &kShaded, [](Gl gl, GLuint) { gl.ClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE); }},
    {"clip_plane", &kShaded,
     [](Gl gl, GLuint) {
       const GLdouble plane[] = {1, 0, 0, 0.2};
       gl.ClipPlane(GL_CLIP_PLANE0, plane), gl.Enable(GL_CLIP_PLANE0);
     }},
    {"alpha_test", &kShaded, [](Gl gl, GLuint) { gl.Enable(GL_ALPHA_TEST), gl.AlphaFunc(GL_GREATER, 0.5f); }},
    {"blended", &kShaded,
     [](Gl gl, GLuint) {
       gl.Enable(GL_BLEND), gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
       gl.Color4f(0.9f, 0.5f, 0.3f, 0.5f);
     },
     1},
    {"no_depth", &kShaded, [](Gl gl, GLuint) { gl.Disable(GL_DEPTH_TEST); }},
    {"lines", &kShaded, [](Gl gl, GLuint) { gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE); }},
    {"translucent_sum", &kOpenCtm, [](Gl gl, GLuint) { gl.Color4f(0.9f, 0.5f, 0.3f, 0.5f); }},
    {"ambient_alpha", &kOpenCtm,
     [](Gl gl, GLuint) {
       const GLfloat ambient[] = {0.2f, 0.2f, 0.2f, 0.3f};
       gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
     }},
    {"textured", &kOpenCtm,
     [](Gl gl, GLuint program) { chequers(gl, 0), setInteger(gl, program, "uUseTexture", 1); }, 1},
    {"texture_projected", &kOpenCtm,
     [](Gl gl, GLuint program) {
       chequers(gl, 0), setInteger(gl, program, "uUseTexture", 1);
       const GLfloat half[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2};
       gl.MatrixMode(GL_TEXTURE), gl.LoadMatrixf(half), gl.MatrixMode(GL_MODELVIEW);
     }},
    {"balloon_added", &kBalloon,
     [](Gl gl, GLuint) {
       gl.Enable(GL_BLEND), gl.BlendFunc(GL_SRC_ALPHA, GL_ONE), gl.DepthMask(GL_FALSE);
       gl.Color4f(0.3f, 0.5f, 0.9f, 0.2f);
     },
     1},
    {"offset_and_culled", &kShaded,
     [](Gl gl, GLuint) {
       gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(1, 1);
       gl.Enable(GL_CULL_FACE), gl.CullFace(GL_FRONT);
     },
     1},
    {"opaque_blending", &kShaded,
     [](Gl gl, GLuint) { gl.Enable(GL_BLEND), gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA); }, 1},
    {"fixed_function_off", &kShaded,
     [](Gl gl, GLuint) {
       // Not GL_COLOR_MATERIAL: in Mesa 25 materials keep their values until the next colour.
       gl.Enable(GL_FOG), gl.Enable(GL_LIGHTING), gl.Enable(GL_TEXTURE_2D), gl.Enable(GL_NORMALIZE);
     },
     1},
};

class BuiltInState : public testing::TestWithParam<BuiltInStateCase> {};

TEST_P(BuiltInState, IsRespected) {
  const BuiltInStateCase& c = GetParam();
  for (const Way way : {Way::clientElements, Way::immediate})
    expectBuiltIns(
        std::string("state-") + c.name + "-" + nameOf(way),
        [&](Gl gl) {
          const GLuint program = makeProgram(gl, c.shaders->vertex, c.shaders->fragment);
          beginBuiltInFrame(gl);
          gl.UseProgram(program);
          gl.Color4f(0.9f, 0.5f, 0.3f, 1);
          c.set(gl, program);
          sendMesh(gl, ball(16), way, false);
        },
        c.traced);
}

INSTANTIATE_TEST_SUITE_P(Cases, BuiltInState, testing::ValuesIn(kBuiltInStateCases),
                         [](const auto& info) { return std::string(info.param.name); });

/// Later passes compare with the depth of the first one to the bit.
TEST(BuiltInPasses, OfOtherProgramsHitTheTracedDepth) {
  for (const Way way : {Way::clientElements, Way::immediate})
    expectBoth(
        "built-in-passes-" + nameOf(way),
        [&](Gl gl) {
          const GLuint shaded = makeProgram(gl, kShaded.vertex, kShaded.fragment);
          const GLuint glow = makeProgram(gl, kShaded.vertex,
                                          "varying vec3 normal;\nvoid main() { gl_FragColor = "
                                          "vec4(0.3 * normal.x * gl_Color.rgb, 0.5); }\n");
          const ProgramMesh round = ball(24);
          beginBuiltInFrame(gl);
          gl.UseProgram(shaded), sendMesh(gl, round, way);
          gl.UseProgram(glow);
          gl.DepthFunc(GL_EQUAL), gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE);
          sendMesh(gl, round, way);
        },
        -1, compatibleWish());
}

/// What changes behind a draw does not reach it.
TEST(BuiltInState, OfPendingDrawsIsKept) {
  for (const Way way : {Way::clientElements, Way::immediate, Way::list})
    expectBuiltIns(
        "state-kept-" + nameOf(way),
        [&](Gl gl) {
          const GLuint height = makeProgram(gl, kHeightColor.vertex, kHeightColor.fragment);
          const GLuint ctm = makeProgram(gl, kOpenCtm.vertex, kOpenCtm.fragment);
          const ProgramMesh round = ball(16);
          const GLint map = gl.GetUniformLocation(height, "colorMap");
          const GLfloat one[] = {0.5f, 1, 1, 0.5f, 1.5f, 1, 0.4f, 1, 2},
                        other[] = {0.9f, 1, 1, 0.1f, 1.5f, 1, 0.7f, 1, 1}, red[] = {1, 0.1f, 0, 1};
          beginBuiltInFrame(gl);
          gl.Scalef(0.5f, 0.5f, 0.5f);
          gl.UseProgram(height);
          gl.Uniform1fv(map, 9, one), sendMesh(gl, round, way);
          gl.Translatef(1.5f, 0, 0);
          gl.Uniform1fv(map, 9, other), sendMesh(gl, round, way, false);
          gl.UseProgram(ctm);
          gl.Color3f(0.2f, 0.9f, 0.4f), gl.Translatef(-3, 0, 0), sendMesh(gl, round, way, false);
          gl.Color3f(1, 0, 0), gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, red);
          gl.Enable(GL_VERTEX_PROGRAM_TWO_SIDE);
          gl.UseProgram(height);
          gl.Uniform1fv(map, 9, one);
          gl.UseProgram(0), gl.DeleteProgram(ctm);
        },
        3);
}

/// Materials within a primitive are uniforms that change between vertices.
TEST(BuiltInState, WithMaterialsWithinAPrimitiveIsLeftAlone) {
  expectBuiltIns(
      "state-materials-within",
      [](Gl gl) {
        const GLuint program = makeProgram(gl, kShaded.vertex, kShaded.fragment);
        const GLfloat red[] = {1, 0.1f, 0, 1};
        beginBuiltInFrame(gl);
        gl.UseProgram(program);
        gl.Begin(GL_TRIANGLES), gl.Normal3f(0.5f, -0.5f, -0.3f);
        gl.Vertex2f(-1, -1), gl.Materialfv(GL_FRONT, GL_DIFFUSE, red), gl.Vertex2f(1, -1);
        gl.Vertex2f(0, 1), gl.End();
      },
      0);
}

/// Attribute 0 takes the place of gl_Vertex.
TEST(BuiltInState, WithAttributeZeroIsLeftAlone) {
  expectBuiltIns(
      "attribute-zero",
      [](Gl gl) {
        const GLuint program = makeProgram(gl, kShaded.vertex, kShaded.fragment);
        const ProgramMesh round = ball(16), wavy = sheet(16);
        beginBuiltInFrame(gl);
        gl.UseProgram(program);
        gl.EnableVertexAttribArray(0);
        gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, wavy.positions.data());
        sendMesh(gl, round, Way::clientElements);
        gl.DisableVertexAttribArray(0);
        gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
      },
      0);
}

}  // namespace
}  // namespace gluray::test
