// Vertex and index buffers whose contents change in every way that OpenGL has, between two draws from them:
// by copies, by name, through mappings, by the GPU.
#include "tests/reference/hostile/habits.h"
#include "tests/reference/programs/program_stage.h"
#include "tests/reference/triangle_field.h"

#include <gtest/gtest.h>

#include <cstring>

namespace gluray::test {
namespace {

using namespace triangle_field;
using namespace twenty_points;

/// One way to change the contents of `buffer` to those of field(1).
struct Write {
  const char* name;
  void (*write)(Gl gl, GLuint buffer);
  bool traced = true;                               // whether the draw after it is traced
  bool before = true;                               // whether the draw before it is traced
  void (*prepare)(Gl gl, GLuint buffer) = nullptr;  // instead of glBufferData
};
void PrintTo(const Write& w, std::ostream* out) { *out << w.name; }

/// A buffer with the new contents, bound to `target`.
GLuint source(Gl gl, GLenum target) {
  const std::vector<float> contents = field(1);
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  gl.BindBuffer(target, name);
  gl.BufferData(target, kBytes, contents.data(), GL_STATIC_DRAW);
  return name;
}

void fill(void* mapped) {
  if (mapped) std::memcpy(mapped, field(1).data(), kBytes);
}

GLuint compileOne(Gl gl, GLenum kind, const char* text) {
  const GLuint shader = gl.CreateShader(kind);
  gl.ShaderSource(shader, 1, &text, nullptr), gl.CompileShader(shader);
  GLint fine = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &fine);
  EXPECT_TRUE(fine) << text;
  return shader;
}

/// Runs a compute shader over all floats of a field; `text` writes those of field(1).
void compute(Gl gl, const std::string& declaration, const std::string& store) {
  const std::string text = "#version 430\nlayout(local_size_x = 100) in;\n" + declaration +
                           "layout(std430, binding = 3) buffer From { float from[]; };\n"
                           "void main() { uint i = gl_GlobalInvocationID.x; " +
                           store + " }\n";
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program, compileOne(gl, GL_COMPUTE_SHADER, text.c_str()));
  gl.LinkProgram(program);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, source(gl, GL_COPY_READ_BUFFER));
  gl.UseProgram(program);
  gl.DispatchCompute(3 * kVertices / 100, 1, 1);
  gl.UseProgram(0);
  gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
}

void feedBack(Gl gl, GLuint buffer) {
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program, compileOne(gl, GL_VERTEX_SHADER,
                                      "#version 150\nin vec3 p;\nout vec3 q;\nvoid main() { q = p; "
                                      "gl_Position = vec4(0); }\n"));
  const char* out = "q";
  gl.TransformFeedbackVaryings(program, 1, &out, GL_INTERLEAVED_ATTRIBS);
  gl.BindAttribLocation(program, 5, "p");
  gl.LinkProgram(program);
  const GLuint from = source(gl, GL_ARRAY_BUFFER);
  gl.BindBuffer(GL_ARRAY_BUFFER, from);
  gl.VertexAttribPointer(5, 3, GL_FLOAT, GL_FALSE, 0, nullptr), gl.EnableVertexAttribArray(5);
  gl.DisableClientState(GL_VERTEX_ARRAY);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  gl.UseProgram(program);
  gl.Enable(GL_RASTERIZER_DISCARD), gl.BeginTransformFeedback(GL_TRIANGLES);
  gl.DrawArrays(GL_TRIANGLES, 0, kVertices);
  gl.EndTransformFeedback(), gl.Disable(GL_RASTERIZER_DISCARD);
  gl.UseProgram(0);
  gl.DisableVertexAttribArray(5), gl.EnableClientState(GL_VERTEX_ARRAY);
}

void clearTo(Gl gl, GLuint buffer, bool byName) {
  // The triangles between the tenth and the fortieth become points.
  constexpr GLintptr kFirst = 90 * sizeof(float);
  constexpr GLsizeiptr kSize = 270 * sizeof(float);
  const float value = 0.25f;
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, buffer);
  if (byName)
    gl.ClearNamedBufferSubData(buffer, GL_R32F, kFirst, kSize, GL_RED, GL_FLOAT, &value);
  else
    gl.ClearBufferSubData(GL_COPY_WRITE_BUFFER, GL_R32F, kFirst, kSize, GL_RED, GL_FLOAT, &value);
}

/// Immutable storage, mapped persistently.
void* g_persistent = nullptr;
void keepMapped(Gl gl, GLuint buffer, bool byName) {
  constexpr GLbitfield kBits = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  const std::vector<float> contents = field(0.5f);
  if (byName) {
    gl.NamedBufferStorage(buffer, kBytes, contents.data(), kBits);
    g_persistent = gl.MapNamedBufferRange(buffer, 0, kBytes, kBits);
  } else {
    gl.BufferStorage(GL_ARRAY_BUFFER, kBytes, contents.data(), kBits);
    g_persistent = gl.MapBufferRange(GL_ARRAY_BUFFER, 0, kBytes, kBits);
  }
}

const Write kWrites[] = {
    {"CopyBufferSubData",
     [](Gl gl, GLuint buffer) {
       source(gl, GL_COPY_READ_BUFFER), gl.BindBuffer(GL_COPY_WRITE_BUFFER, buffer);
       gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, kBytes);
     }},
    {"CopyNamedBufferSubData",
     [](Gl gl, GLuint buffer) {
       gl.CopyNamedBufferSubData(source(gl, GL_ARRAY_BUFFER), buffer, 0, 0, kBytes);
     }},
    {"BufferSubDataOfAnotherTarget",
     [](Gl gl, GLuint buffer) {
       gl.BindBuffer(GL_TEXTURE_BUFFER, buffer);
       gl.BufferSubData(GL_TEXTURE_BUFFER, 0, kBytes, field(1).data());
     }},
    {"BufferDataOfAnotherTarget",
     [](Gl gl, GLuint buffer) {
       gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
       gl.BufferData(GL_PIXEL_UNPACK_BUFFER, kBytes, field(1).data(), GL_STREAM_DRAW);
       gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
     }},
    {"NamedBufferSubData",
     [](Gl gl, GLuint buffer) { gl.NamedBufferSubData(buffer, 0, kBytes, field(1).data()); }},
    {"NamedBufferData",
     [](Gl gl, GLuint buffer) { gl.NamedBufferData(buffer, kBytes, field(1).data(), GL_STATIC_DRAW); }},
    {"MapNamedBuffer",
     [](Gl gl, GLuint buffer) {
       fill(gl.MapNamedBuffer(buffer, GL_WRITE_ONLY)), gl.UnmapNamedBuffer(buffer);
     }},
    {"MapNamedBufferRangeAndUnmapBuffer",
     [](Gl gl, GLuint buffer) {
       fill(gl.MapNamedBufferRange(buffer, 0, kBytes, GL_MAP_WRITE_BIT));
       gl.BindBuffer(GL_ARRAY_BUFFER, buffer), gl.UnmapBuffer(GL_ARRAY_BUFFER);
     }},
    {"MapBufferAndUnmapNamedBuffer",
     [](Gl gl, GLuint buffer) {
       gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
       void* mapped = gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
       void* told = nullptr;
       GLint is = 0;
       gl.GetNamedBufferPointerv(buffer, GL_BUFFER_MAP_POINTER, &told);
       gl.GetNamedBufferParameteriv(buffer, GL_BUFFER_MAPPED, &is);
       EXPECT_EQ(told, mapped);
       EXPECT_EQ(is, GL_TRUE);
       fill(mapped);
       EXPECT_EQ(gl.UnmapNamedBuffer(buffer), GL_TRUE);
     }},
    {"NamedBufferDataWhileMapped",
     [](Gl gl, GLuint buffer) {
       gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
       fill(gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY));
       gl.NamedBufferData(buffer, kBytes, field(1).data(), GL_STATIC_DRAW);
     }},
    {"MapBufferOfAnotherTarget",
     [](Gl gl, GLuint buffer) {
       gl.BindBuffer(GL_COPY_WRITE_BUFFER, buffer);
       fill(gl.MapBuffer(GL_COPY_WRITE_BUFFER, GL_WRITE_ONLY)), gl.UnmapBuffer(GL_COPY_WRITE_BUFFER);
     }},
    {"ClearBufferSubData", [](Gl gl, GLuint buffer) { clearTo(gl, buffer, false); }},
    {"ClearNamedBufferSubData", [](Gl gl, GLuint buffer) { clearTo(gl, buffer, true); }},
    {"TransformFeedback", feedBack, false},
    {"BindBuffersBaseAndAComputeShader",
     [](Gl gl, GLuint buffer) {
       gl.BindBuffersBase(GL_SHADER_STORAGE_BUFFER, 2, 1, &buffer);
       compute(gl, "layout(std430, binding = 2) buffer To { float to[]; };\n", "to[i] = from[i];");
     },
     false},
    {"ImageOfABufferTexture",
     [](Gl gl, GLuint buffer) {
       GLuint texture = 0;
       gl.GenTextures(1, &texture), gl.BindTexture(GL_TEXTURE_BUFFER, texture);
       gl.TexBuffer(GL_TEXTURE_BUFFER, GL_R32F, buffer);
       gl.BindImageTexture(1, texture, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
       compute(gl, "layout(r32f, binding = 1) writeonly uniform imageBuffer to;\n",
               "imageStore(to, int(i), vec4(from[i]));");
     }},
    {"PersistentMapping", [](Gl, GLuint) { fill(g_persistent); }, false, false,
     [](Gl gl, GLuint buffer) { keepMapped(gl, buffer, false); }},
    {"PersistentMappingByName", [](Gl, GLuint) { fill(g_persistent); }, false, false,
     [](Gl gl, GLuint buffer) { keepMapped(gl, buffer, true); }},
};

class BufferWrites : public testing::TestWithParam<Write> {};

/// Drawn, changed, drawn elsewhere in other colours.
void drawTwice(Gl gl, const Write& write) {
  stage(gl);
  gl.Disable(GL_LIGHTING);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  if (write.prepare)
    write.prepare(gl, buffer);
  else
    gl.BufferData(GL_ARRAY_BUFFER, kBytes, field(0.5f).data(), GL_STATIC_DRAW);
  const auto draw = [&](float x, GLsizei count) {
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.VertexPointer(3, GL_FLOAT, 0, nullptr), gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.Color3f(0.5f + 0.5f * x, 1, 0);
    gl.PushMatrix(), gl.Translatef(x, 0, 0), gl.Scalef(0.3f, 0.3f, 0.3f);
    gl.DrawArrays(GL_TRIANGLES, 0, count);
    gl.PopMatrix();
  };
  draw(-0.7f, kVertices);
  write.write(gl, buffer);
  draw(0.7f, kVertices);
  draw(0, 30);  // so few that they are captured one by one
  gl.Finish();
}

TEST_P(BufferWrites, AreSeenByTheNextDraw) {
  const Write& write = GetParam();
  const uint64_t traced = (write.before ? 1 : 0) + (write.traced ? 2 : 0);
  const gl::Statistics s = expectSame([&](Gl gl, Seen&) { drawTwice(gl, write); }, {.traced = traced});
  EXPECT_EQ(s.rasterisedBecause[static_cast<size_t>(gl::Reason::foreignBuffer)] +
                s.rasterisedBecause[static_cast<size_t>(gl::Reason::persistentMapping)],
            (write.before ? 0u : 1u) + (write.traced ? 0u : 2u));
}

INSTANTIATE_TEST_SUITE_P(All, BufferWrites, testing::ValuesIn(kWrites),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(BufferWrites, SizesOfPendingBuffersAreReported) {
  const auto ask = [](Gl gl, Seen& seen) {
    stage(gl);
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, 100, nullptr, GL_STATIC_DRAW);
    GLint64 large = -1;
    GLint plain = -1, named = -1;
    gl.GetBufferParameteri64v(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &large);
    gl.GetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &plain);
    gl.GetNamedBufferParameteriv(buffer, GL_BUFFER_SIZE, &named);
    for (const double v : {double(large), double(plain), double(named)})
      seen.push_back(static_cast<float>(v));
  };
  twenty_points::expectSame(ask, {.traced = 0});
}

}  // namespace
}  // namespace gluray::test
