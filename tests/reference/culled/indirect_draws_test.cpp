// Draws whose parameters are in a buffer object, culled as the draws that these describe: images, state and
// errors are those of the real OpenGL.
#include "tests/reference/culled/swarm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

using namespace culled;

struct ArraysCommand {
  GLuint count = 0, instances = 1, first = 0, baseInstance = 0;
};
struct ElementsCommand {
  GLuint count = 0, instances = 1, firstIndex = 0;
  GLint baseVertex = 0;
  GLuint baseInstance = 0;
};

template <class Command>
GLuint sendCommands(Gl gl, const std::vector<Command>& commands, size_t step = sizeof(Command),
                    size_t before = 0) {
  std::vector<char> bytes(before + step * commands.size(), 1);
  for (size_t i = 0; i < commands.size(); ++i)
    std::memcpy(&bytes[before + step * i], &commands[i], sizeof(Command));
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer);
  gl.BufferData(GL_DRAW_INDIRECT_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
  return buffer;
}

const void* offset(size_t bytes) { return reinterpret_cast<const void*>(bytes); }

struct Indirect {
  std::string name;
  std::function<void(Gl, const ProgramMesh&)> prepare;
  std::function<void(Gl, const ProgramMesh&, int frame)> draw;
  std::string vertex = vertexOf(kPlacings[0]);
  std::string fragment = tintedFragment();
  int samples = 1;
  ProgramMesh mesh = shells(4, 30);
  Swarm places = swarm(5);
};

gl::Statistics compareIndirect(const Indirect& of, const ContextWish& wish = {kSide, kSide, true, 4, 3}) {
  GLuint program = 0, array = 0;
  return compareSamples(
      "indirect_" + of.name, 4, of.samples, GL_DEPTH24_STENCIL8,
      [&](Gl gl) {
        program = makeProgram(gl, of.vertex, of.fragment);
        array = send(gl, of.mesh, program).array;
        sendSwarm(gl, program, of.places);
        of.prepare(gl, of.mesh);
      },
      [&](Gl gl, int frame) {
        clear(gl);
        gl.UseProgram(program), gl.BindVertexArray(array);
        turn(gl, program, frame);
        of.draw(gl, of.mesh, frame);
      },
      nullptr, wish);
}

/// One command for each shell.
std::vector<ElementsCommand> shellsOf(const ProgramMesh& mesh, GLuint instances = 1) {
  const auto each = static_cast<GLuint>(mesh.indices.size() / 4);
  std::vector<ElementsCommand> all;
  for (GLuint i = 0; i < 4; ++i) all.push_back({each, instances, i * each, 0, 3 * i});
  return all;
}

TEST(CulledIndirectDraws, AreThoseOfTheirCommands) {
  Indirect of{.name = "elements"};
  of.prepare = [](Gl gl, const ProgramMesh& mesh) { sendCommands(gl, shellsOf(mesh, 30)); };
  of.draw = [](Gl gl, const ProgramMesh&, int) {
    for (size_t i = 0; i < 4; ++i)
      gl.DrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, offset(i * sizeof(ElementsCommand)));
  };
  gl::Statistics counts = compareIndirect(of);
  EXPECT_EQ(counts.drawsCulled, 3u * 4);
  EXPECT_GT(counts.trianglesLeftOut, 0u);
  of.name = "multi_elements";
  of.draw = [](Gl gl, const ProgramMesh&, int) {
    gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, 4, 0);
  };
  EXPECT_EQ(compareIndirect(of).drawsCulled, 3u * 4);
  of.name = "arrays";
  of.prepare = [](Gl gl, const ProgramMesh& mesh) {
    const auto count = static_cast<GLuint>(mesh.positions.size() / 3 * 3);
    sendCommands(gl, std::vector<ArraysCommand>{{count - 6, 50, 3, 7}});
  };
  of.draw = [](Gl gl, const ProgramMesh&, int) { gl.DrawArraysIndirect(GL_TRIANGLES, nullptr); };
  EXPECT_EQ(compareIndirect(of).drawsCulled, 3u);
}

/// Small draws between large ones, gaps between commands, a base vertex, and several samples.
TEST(CulledIndirectDraws, OfManySizes) {
  constexpr size_t kStep = 32, kBefore = 12;
  Indirect of{.name = "sizes"};
  of.prepare = [&](Gl gl, const ProgramMesh& mesh) {
    const auto each = static_cast<GLuint>(mesh.indices.size() / 4);
    const auto vertices = static_cast<GLint>(mesh.positions.size() / 4);
    const std::vector<ElementsCommand> commands{
        {30, 2, 0, 0, 1},   {60, 1, 9, 5, 0},   {each, 40, 0, vertices, 3}, {0, 9, 0, 0, 0},
        {each, 0, 0, 0, 0}, {90, 3, 300, 0, 9}, {each, 1, each, 0, 8},      {12, 1, 0, 0, 0}};
    sendCommands(gl, commands, kStep, kBefore);
  };
  of.draw = [&](Gl gl, const ProgramMesh&, int) {
    gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, offset(kBefore), 8, kStep);
  };
  for (const int samples : {1, 4}) {
    of.samples = samples;
    EXPECT_EQ(compareIndirect(of).drawsCulled, 3u * 2);
  }
}

/// The commands change: by the program, through another binding, and by a copy that the real OpenGL makes.
TEST(CulledIndirectDraws, FollowChangesOfTheirCommands) {
  for (const int way : {0, 1, 2}) {
    Indirect of{.name = "changes" + std::to_string(way)};
    of.prepare = [](Gl gl, const ProgramMesh& mesh) { sendCommands(gl, shellsOf(mesh, 20)); };
    of.draw = [&](Gl gl, const ProgramMesh& mesh, int frame) {
      std::vector<ElementsCommand> commands = shellsOf(mesh, 20 + 3 * static_cast<GLuint>(frame));
      std::rotate(commands.begin(), commands.begin() + frame % 4, commands.end());
      const GLsizeiptr bytes = sizeof(ElementsCommand) * 4;
      GLint name = 0;
      gl.GetIntegerv(GL_DRAW_INDIRECT_BUFFER_BINDING, &name);
      if (way == 0) gl.BufferSubData(GL_DRAW_INDIRECT_BUFFER, 0, bytes, commands.data());
      if (way == 1) {
        gl.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(name));
        void* const to = gl.MapBufferRange(GL_ARRAY_BUFFER, 0, bytes, GL_MAP_WRITE_BIT);
        std::memcpy(to, commands.data(), static_cast<size_t>(bytes));
        gl.UnmapBuffer(GL_ARRAY_BUFFER);
      }
      if (way == 2) {
        GLuint source = 0;
        gl.GenBuffers(1, &source), gl.BindBuffer(GL_COPY_READ_BUFFER, source);
        gl.BufferData(GL_COPY_READ_BUFFER, bytes, commands.data(), GL_STATIC_DRAW);
        gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_DRAW_INDIRECT_BUFFER, 0, 0, bytes);
        gl.DeleteBuffers(1, &source);
      }
      gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, 4, 0);
    };
    EXPECT_GE(compareIndirect(of).drawsCulled, 3u * 4);
  }
}

TEST(CulledIndirectDraws, AreLeftWhereTheirCommandsAreNotKnown) {
  Indirect of{.name = "storage"};
  of.prepare = [](Gl gl, const ProgramMesh& mesh) {
    const GLuint buffer = sendCommands(gl, shellsOf(mesh, 20));
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);  // any shader may write it
  };
  of.draw = [](Gl gl, const ProgramMesh&, int) {
    gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, 4, 0);
  };
  EXPECT_EQ(compareIndirect(of).drawsCulled, 0u);
  // The numbers of draws go on where parts of them are made.
  of.name = "numbers";
  of.prepare = [](Gl gl, const ProgramMesh& mesh) { sendCommands(gl, shellsOf(mesh, 20)); };
  of.vertex = replacedIn(of.vertex, "#version 150",
                         "#version 150\n#extension GL_ARB_shader_draw_parameters : require");
  of.vertex = replacedIn(of.vertex, "color = tint;", "color = tint * float(gl_DrawIDARB % 3);");
  EXPECT_EQ(compareIndirect(of).drawsCulled, 0u);
}

/// Positions that are no polynomials of the instance's attributes, of each command by itself.
TEST(CulledIndirectDraws, WherePositionsAreFedBack) {
  Indirect of{.name = "sine"};
  of.prepare = [](Gl gl, const ProgramMesh& mesh) { sendCommands(gl, shellsOf(mesh, 20)); };
  of.vertex = replacedIn(of.vertex, "vec3 world =", "vec3 world = 0.1 * sin(tint) +");
  of.draw = [](Gl gl, const ProgramMesh&, int) {
    gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, 4, 0);
  };
  EXPECT_EQ(compareIndirect(of).drawsCulled, 3u * 4);
}

TEST(CulledIndirectDraws, KeepErrors) {
  for (const Culling how : {Culling::off, Culling::always}) {
    TracedContext context({kSide, kSide, true, 4, 3}, culling(how));
    Gl gl = context.gl();
    const ProgramMesh mesh = shells(4, 30);
    const GLuint program = makeProgram(gl, vertexOf(kPlacings[0]), tintedFragment());
    send(gl, mesh, program), sendSwarm(gl, program, swarm(5));
    clear(gl);
    gl.UseProgram(program);
    turn(gl, program, 0);
    const auto expectError = [&](GLenum error, int line) {
      EXPECT_EQ(gl.GetError(), error) << line << (how == Culling::off ? " whole" : " culled");
    };
    const GLenum elements = GL_UNSIGNED_INT;
    gl.MultiDrawElementsIndirect(GL_TRIANGLES, elements, nullptr, 4, 0);  // no buffer
    expectError(GL_INVALID_OPERATION, __LINE__);
    const GLuint buffer = sendCommands(gl, shellsOf(mesh, 20));
    gl.MultiDrawElementsIndirect(GL_TRIANGLES, elements, offset(2), 1, 0);
    expectError(GL_INVALID_VALUE, __LINE__);
    gl.MultiDrawElementsIndirect(GL_TRIANGLES, elements, nullptr, 1, 6);
    expectError(GL_INVALID_VALUE, __LINE__);
    gl.MultiDrawElementsIndirect(GL_TRIANGLES, elements, nullptr, -1, 0);
    expectError(GL_INVALID_VALUE, __LINE__);
    gl.MultiDrawElementsIndirect(GL_TRIANGLES, elements, nullptr, 5, 0);  // beyond the end
    expectError(GL_INVALID_OPERATION, __LINE__);
    gl.MultiDrawElementsIndirect(GL_TRIANGLES, 0, nullptr, 4, 0);
    expectError(GL_INVALID_ENUM, __LINE__);
    gl.DrawElementsIndirect(77, elements, nullptr);
    expectError(GL_INVALID_ENUM, __LINE__);
    gl.DrawElementsIndirect(GL_QUADS, elements, nullptr);
    expectError(GL_INVALID_ENUM, __LINE__);
    gl.MapBuffer(GL_DRAW_INDIRECT_BUFFER, GL_WRITE_ONLY);
    gl.DrawElementsIndirect(GL_TRIANGLES, elements, nullptr);
    expectError(GL_INVALID_OPERATION, __LINE__);
    gl.UnmapBuffer(GL_DRAW_INDIRECT_BUFFER);
    for (int i = 0; i < 2; ++i) gl.DrawElementsIndirect(GL_TRIANGLES, elements, nullptr);
    expectError(GL_NO_ERROR, __LINE__);
    EXPECT_EQ(context.context().counts.statistics.drawsCulled > 0, how == Culling::always);
    gl.DeleteBuffers(1, &buffer);
    gl.DrawElementsIndirect(GL_TRIANGLES, elements, nullptr);
    expectError(GL_INVALID_OPERATION, __LINE__);
  }
}

}  // namespace
}  // namespace gluray::test
