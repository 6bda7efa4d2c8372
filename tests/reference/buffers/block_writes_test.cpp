// Uniform blocks and buffer textures whose contents are written after binding, in every way that OpenGL has.
#include "tests/reference/programs/program_stage.h"
#include "tests/reference/triangle_field.h"

#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <cstring>

namespace gluray::test::triangle_field {
namespace {

/// A field; its program reads its matrix from a uniform block, or its offset from a buffer texture.
const char* const kBlockFamily =
    "[[family]]\nname = \"own\"\nmatch.active = \"vertexMC\"\nvertex.position = \"vertexMC\"\n"
    "transform.clip_from_object = \"Own.mvp\"\nlights.model = \"unlit\"\nmaterial.diffuse_color = \"tint\"\n";
const char* const kBlockVertex =
    "#version 150\nin vec3 vertexMC; layout(std140) uniform Own { mat4 mvp; } own;\n"
    "void main() { gl_Position = own.mvp * vec4(vertexMC, 1); }\n";
const char* const kBlockFragment =
    "#version 150\nuniform vec3 tint; out vec4 color; void main() { color = vec4(tint, 1); }\n";

struct BlockWrite {
  const char* name;
  void (*write)(Gl gl, GLuint buffer, const void* data, GLsizeiptr size);
};
void PrintTo(const BlockWrite& w, std::ostream* out) { *out << w.name; }

const BlockWrite kBlockWrites[] = {
    {"BufferData",
     [](Gl gl, GLuint buffer, const void* data, GLsizeiptr size) {
       gl.BindBuffer(GL_ARRAY_BUFFER, buffer), gl.BufferData(GL_ARRAY_BUFFER, size, data, GL_STATIC_DRAW);
     }},
    {"BufferSubData",
     [](Gl gl, GLuint buffer, const void* data, GLsizeiptr size) {
       gl.BindBuffer(GL_ARRAY_BUFFER, buffer), gl.BufferSubData(GL_ARRAY_BUFFER, 0, size, data);
     }},
    {"MapBuffer",
     [](Gl gl, GLuint buffer, const void* data, GLsizeiptr size) {
       gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
       void* mapped = gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
       if (mapped) std::memcpy(mapped, data, static_cast<size_t>(size));
       gl.UnmapBuffer(GL_ARRAY_BUFFER);
     }},
    {"NamedBufferSubData", [](Gl gl, GLuint buffer, const void* data,
                              GLsizeiptr size) { gl.NamedBufferSubData(buffer, 0, size, data); }},
    {"CopyBufferSubData",
     [](Gl gl, GLuint buffer, const void* data, GLsizeiptr size) {
       GLuint from = 0;
       gl.GenBuffers(1, &from), gl.BindBuffer(GL_ARRAY_BUFFER, from);
       gl.BufferData(GL_ARRAY_BUFFER, size, data, GL_STATIC_DRAW);
       gl.BindBuffer(GL_COPY_WRITE_BUFFER, buffer);
       gl.CopyBufferSubData(GL_ARRAY_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, size);
     }},
};

class BlockWrites : public testing::TestWithParam<BlockWrite> {};

/// One vertex array with the field at `program`'s attribute vertexMC.
void bindField(Gl gl, GLuint program) {
  GLuint array = 0, buffer = 0;
  gl.GenVertexArrays(1, &array), gl.BindVertexArray(array);
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, kBytes, field(0.5f).data(), GL_STATIC_DRAW);
  const auto place = static_cast<GLuint>(gl.GetAttribLocation(program, "vertexMC"));
  gl.VertexAttribPointer(place, 3, GL_FLOAT, GL_FALSE, 0, nullptr), gl.EnableVertexAttribArray(place);
}

TEST_P(BlockWrites, ReachAUniformBlockThatWasBoundBefore) {
  expectBoth(
      std::string("block_") + GetParam().name,
      [&](Gl gl) {
        beginFrame(gl);
        const GLuint program = makeProgram(gl, kBlockVertex, kBlockFragment);
        gl.UseProgram(program);
        gl.UniformBlockBinding(program, 0, 2);
        bindField(gl, program);
        GLuint buffer = 0;
        const glm::mat4 nothing(0.1f);
        gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
        gl.BufferData(GL_ARRAY_BUFFER, sizeof nothing, &nothing, GL_DYNAMIC_DRAW);
        gl.BindBuffersBase(GL_UNIFORM_BUFFER, 2, 1, &buffer);
        for (const double degrees : {20.0, -50.0}) {
          const View view = perspectiveView(degrees);
          const glm::mat4 mvp(view.clipFromEye * view.eyeFromObject);
          GetParam().write(gl, buffer, glm::value_ptr(mvp), sizeof mvp);
          setVec3(gl, program, "tint", {degrees > 0 ? 1.0f : 0.2f, 0.7f, 0.3f});
          gl.DrawArrays(GL_TRIANGLES, 0, kVertices);
        }
      },
      2, coreWish(4, 5), kProgramTolerance, kBlockFamily);
}

TEST_P(BlockWrites, ReachABufferTextureThatWasMadeBefore) {
  for (const bool traced : {true, false})  // false, without the family: rasterised draws must see them, too
    expectSame(
        std::string("buffer_texture_") + GetParam().name,
        [&](Gl gl) {
          beginFrame(gl);
          const Surface surface{.color = Surface::Color::cell, .lights = Surface::Lights::headlight};
          const GLuint program = makeProgram(gl, surface);
          const ProgramMesh mesh = ball(12);
          const Upload up = upload(gl, mesh, program);
          GLuint buffer = 0, texture = 0;
          std::vector<uint32_t> texels(mesh.triangles(), 0xff00ff00u);
          const auto size = static_cast<GLsizeiptr>(4 * texels.size());
          gl.GenBuffers(1, &buffer), gl.GenTextures(1, &texture);
          gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
          gl.BufferData(GL_ARRAY_BUFFER, size, texels.data(), GL_STATIC_DRAW);
          gl.ActiveTexture(GL_TEXTURE2), gl.BindTexture(GL_TEXTURE_BUFFER, texture);
          gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA8, buffer);
          gl.UseProgram(program), setInteger(gl, program, "textureC", 2);
          if (!traced) gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
          double degrees = 10;
          for (const uint32_t color : {0u, 0xff4020f0u, 0xfff0c010u}) {
            for (size_t i = 0; i < texels.size() && color; ++i) texels[i] = i % 3 ? color : 0xffffffffu;
            if (color) GetParam().write(gl, buffer, texels.data(), size);
            View view = perspectiveView(degrees += 30);
            view.eyeFromObject[3][0] += degrees / 100 - 0.7;
            drawSurface(gl, program, up, mesh, view, surface);
          }
        },
        traced ? 3 : 0, coreWish(4, 5));
}

INSTANTIATE_TEST_SUITE_P(All, BlockWrites, testing::ValuesIn(kBlockWrites),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test::triangle_field
