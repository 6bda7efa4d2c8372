// glBegin and lists while programs of later stages are in use: patches, and primitives that are errors though
// they draw nothing.
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace gluray::test {
namespace {

constexpr ContextWish kOld{kProgramWidth, kProgramHeight, false, 0, 0};

GLuint linked(Gl gl, const std::vector<std::pair<GLenum, const char*>>& shaders) {
  const GLuint program = gl.CreateProgram();
  for (const auto& [kind, text] : shaders) {
    const GLuint shader = gl.CreateShader(kind);
    gl.ShaderSource(shader, 1, &text, nullptr), gl.CompileShader(shader), gl.AttachShader(program, shader);
  }
  gl.LinkProgram(program);
  GLint fine = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &fine);
  EXPECT_TRUE(fine);
  return program;
}

GLuint tessellating(Gl gl) {
  return linked(gl, {{GL_VERTEX_SHADER, R"(#version 150 compatibility
void main() { gl_Position = gl_Vertex; })"},
                     {GL_TESS_CONTROL_SHADER, R"(#version 150
#extension GL_ARB_tessellation_shader : require
layout(vertices = 3) out;
void main() {
  gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;
  gl_TessLevelOuter = float[4](4, 4, 4, 0), gl_TessLevelInner = float[2](4, 0);
})"},
                     {GL_TESS_EVALUATION_SHADER, R"(#version 150
#extension GL_ARB_tessellation_shader : require
layout(triangles) in;
out vec3 at;
void main() {
  at = gl_TessCoord;
  gl_Position = gl_TessCoord.x * gl_in[0].gl_Position + gl_TessCoord.y * gl_in[1].gl_Position +
                gl_TessCoord.z * gl_in[2].gl_Position;
})"},
                     {GL_FRAGMENT_SHADER, R"(#version 150
in vec3 at;
out vec4 color;
void main() { color = vec4(at, 1.0); })"}});
}

void sendPatch(Gl gl, float z) {
  gl.Begin(GL_PATCHES);
  gl.Vertex3f(-0.8f, -0.7f, z), gl.Vertex3f(0.8f, -0.6f, z), gl.Vertex3f(0.1f, 0.8f, z);
  gl.End();
}

TEST(BegunPrograms, SendPatches) {
  const Outcome o = expectSame(
      "begun_patches",
      [](Gl gl) {
        const GLuint program = tessellating(gl);
        beginFrame(gl);
        gl.UseProgram(program), gl.PatchParameteri(GL_PATCH_VERTICES, 3);
        sendPatch(gl, 0.2f);
        gl.UseProgram(0);
        gl.Begin(GL_TRIANGLES);  // in front of a part
        gl.Color3f(1, 1, 0), gl.Vertex3f(-0.9f, 0, -0.5f), gl.Vertex3f(0, -0.9f, 0.4f),
            gl.Vertex3f(0, 0, 0.3f);
        gl.End(), gl.Color3f(1, 1, 1);
      },
      -1, kOld);
  EXPECT_GT(o.statistics.drawsTraced, 0u);
}

TEST(BegunPrograms, SendPatchesInLists) {
  expectSame(
      "begun_patches_in_list",
      [](Gl gl) {
        const GLuint program = tessellating(gl), list = gl.GenLists(1);
        gl.PatchParameteri(GL_PATCH_VERTICES, 3);
        gl.NewList(list, GL_COMPILE), sendPatch(gl, 0.1f), gl.EndList();
        for (int frame = 0; frame < 2; ++frame) {
          beginFrame(gl);
          gl.UseProgram(program), gl.CallList(list), gl.UseProgram(0);
        }
      },
      -1, kOld);
}

/// Outside of glBegin and glEnd, attribute 0 is a value like those of the other attributes.
TEST(BegunPrograms, TakeAttributeZeroAsAValue) {
  expectSame(
      "begun_attribute_zero",
      [](Gl gl) {
        const GLuint program = linked(gl, {{GL_VERTEX_SHADER, R"(#version 130
in vec4 value, place;
flat out vec4 paint;
uniform float shift;
void main() { paint = value, gl_Position = place + vec4(shift, 0, 0, 0); })"},
                                           {GL_FRAGMENT_SHADER, R"(#version 130
flat in vec4 paint;
out vec4 color;
void main() { color = paint; })"}});
        gl.BindAttribLocation(program, 0, "value"), gl.BindAttribLocation(program, 1, "place");
        gl.LinkProgram(program);
        const std::array<GLfloat, 9> corners{-0.2f, -0.5f, 0.1f, 0.2f, -0.5f, 0.2f, 0, 0.5f, 0.3f};
        GLuint buffer = 0;
        gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
        gl.BufferData(GL_ARRAY_BUFFER, sizeof corners, corners.data(), GL_STATIC_DRAW);
        const GLuint list = gl.GenLists(1);
        gl.NewList(list, GL_COMPILE), gl.VertexAttrib4f(0, 0, 0, 1, 1), gl.EndList();
        beginFrame(gl);
        gl.UseProgram(program);
        gl.EnableVertexAttribArray(1), gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        const auto draw = [&](float shift) {
          gl.Uniform1f(gl.GetUniformLocation(program, "shift"), shift), gl.DrawArrays(GL_TRIANGLES, 0, 3);
        };
        gl.VertexAttrib4f(0, 1, 0, 0, 1), draw(-0.6f);
        gl.VertexAttrib2f(0, 0, 1), draw(-0.2f);
        gl.CallList(list), draw(0.2f);
        gl.Begin(GL_TRIANGLES), gl.VertexAttrib4f(0, 0, 0, 0, 1), gl.End();  // a vertex
        gl.VertexAttrib3f(0, 1, 1, 0), draw(0.6f);
        gl.DisableVertexAttribArray(1), gl.UseProgram(0), gl.BindBuffer(GL_ARRAY_BUFFER, 0);
      },
      -1, kOld);
}

TEST(BegunPrograms, RefuseInstancesBeforeTheArrays) {
  expectSame(
      "begun_negative_first",
      [](Gl gl) {
        static const std::array<GLfloat, 9> corners{-0.2f, -0.5f, 0.1f, 0.2f, -0.5f, 0.2f, 0, 0.5f, 0.3f};
        beginFrame(gl);
        gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, corners.data());
        gl.DrawArraysInstanced(GL_TRIANGLES, -1, 3, 2);
        EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_VALUE));
        gl.DisableClientState(GL_VERTEX_ARRAY);
      },
      -1, kOld);
}

TEST(BegunPrograms, TakeBlockBindingsFromLists) {
  expectSame(
      "begun_block_bindings",
      [](Gl gl) {
        const GLuint program = linked(gl, {{GL_VERTEX_SHADER, R"(#version 140
uniform Place { vec4 shift; };
in vec4 at;
void main() { gl_Position = at + shift; })"},
                                           {GL_FRAGMENT_SHADER, R"(#version 140
out vec4 color;
void main() { color = vec4(1); })"}});
        const GLuint block = gl.GetUniformBlockIndex(program, "Place"), list = gl.GenLists(1);
        const auto expectBinding = [&](GLint expected) {
          GLint binding = -1;
          gl.GetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_BINDING, &binding);
          EXPECT_EQ(binding, expected);
        };
        beginFrame(gl);
        gl.UniformBlockBinding(program, block, 1);
        gl.NewList(list, GL_COMPILE), gl.UniformBlockBinding(program, block, 2), gl.EndList();
        expectBinding(1);
        gl.CallList(list), expectBinding(2);
      },
      -1, kOld);
}

/// Lists keep changes of a pipeline's programs, but not its binding (ARB_separate_shader_objects, issue 9).
TEST(BegunPrograms, TakeStagesFromLists) {
  expectSame(
      "begun_stages",
      [](Gl gl) {
        const char* const vertex = "void main() { gl_Position = gl_Vertex; }";
        const char* const red = "void main() { gl_FragColor = vec4(1, 0, 0, 1); }";
        const char* const green =
            "uniform float rest; void main() { gl_FragColor = vec4(rest, 1, rest, 1); }";
        const GLuint list = gl.GenLists(1), first = gl.CreateShaderProgramv(GL_VERTEX_SHADER, 1, &vertex),
                     second = gl.CreateShaderProgramv(GL_FRAGMENT_SHADER, 1, &red),
                     third = gl.CreateShaderProgramv(GL_FRAGMENT_SHADER, 1, &green);
        GLuint pipeline = 0;
        GLint current = 0;
        beginFrame(gl);
        gl.GenProgramPipelines(1, &pipeline);
        gl.UseProgramStages(pipeline, GL_VERTEX_SHADER_BIT, first);
        gl.UseProgramStages(pipeline, GL_FRAGMENT_SHADER_BIT, second);
        gl.NewList(list, GL_COMPILE);
        gl.BindProgramPipeline(pipeline);  // at once
        gl.UseProgramStages(pipeline, GL_FRAGMENT_SHADER_BIT, third);
        gl.ActiveShaderProgram(pipeline, third);
        gl.Uniform1f(0, 0.5f);
        gl.EndList();
        gl.GetProgramPipelineiv(pipeline, GL_FRAGMENT_SHADER, &current);
        EXPECT_EQ(static_cast<GLuint>(current), second);
        gl.Rectf(-0.9f, -0.9f, -0.1f, 0.9f);
        gl.CallList(list);
        gl.GetProgramPipelineiv(pipeline, GL_FRAGMENT_SHADER, &current);
        EXPECT_EQ(static_cast<GLuint>(current), third);
        gl.Rectf(0.1f, -0.9f, 0.9f, 0.9f);
        gl.BindProgramPipeline(0), gl.DeleteProgramPipelines(1, &pipeline);
      },
      -1, kOld);
}

/// Two colours of one fragment are blended, but more buffers are drawn into than can be then.
TEST(BegunPrograms, RaiseErrorsWithoutVertices) {
  std::array<std::vector<GLenum>, 2> raised;
  size_t run = 0;
  expectSame(
      "begun_error",
      [&](Gl gl) {
        std::vector<GLenum>& errors = raised[run++ % 2];
        beginFrame(gl);
        std::array<GLuint, 2> textures{};
        GLuint framebuffer = 0;
        gl.GenFramebuffers(1, &framebuffer), gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        gl.GenTextures(2, textures.data());
        for (GLuint i = 0; i < 2; ++i) {
          gl.BindTexture(GL_TEXTURE_2D, textures[i]);
          gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
          gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + i, GL_TEXTURE_2D, textures[i], 0);
        }
        const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
        gl.DrawBuffers(2, both);
        gl.Enable(GL_BLEND), gl.BlendFunc(GL_SRC_COLOR, GL_SRC1_COLOR);
        gl.Begin(GL_TRIANGLES), gl.End(), errors.push_back(gl.GetError());
        gl.DrawBuffers(1, both);
        gl.Begin(GL_TRIANGLES), gl.End(), errors.push_back(gl.GetError());
        gl.Disable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ZERO);
        gl.BindTexture(GL_TEXTURE_2D, 0), gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
      },
      -1, kOld);
  EXPECT_EQ(raised[0], raised[1]);
  ASSERT_EQ(raised[0].size(), 2u);
  EXPECT_EQ(raised[0][0], static_cast<GLenum>(GL_INVALID_OPERATION));
}

}  // namespace
}  // namespace gluray::test
