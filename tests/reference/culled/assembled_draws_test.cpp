// Culled draws of strips, fans and restarted primitives: the triangles, and the vertices that colour flat
// ones, are those of whole draws.
#include "tests/reference/culled/turned_draws.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

using namespace culled;

constexpr GLuint kRestart = 7;  // also a vertex

/// Pieces of some triangles of the mesh, with `restart` between them, some of them too short.
std::vector<GLuint> pieces(const ProgramMesh& mesh, GLuint restart) {
  std::vector<GLuint> all;
  for (size_t i = 0; i + 6 <= mesh.indices.size(); i += 6) {
    const GLuint* const two = &mesh.indices[i];  // triangles of a square, which share a side
    for (const size_t corner : {0, 1, 2, 5})
      if (corner != 5 || i % 5 != 0) all.push_back(two[corner]);
    all.push_back(restart);
    if (i % 4 == 0) all.push_back(two[0]), all.push_back(two[1]), all.push_back(restart);
  }
  return all;
}

struct Drawn {
  std::string name;
  GLenum mode = GL_TRIANGLE_STRIP;
  std::vector<GLuint> indices;
  GLenum type = GL_UNSIGNED_INT;
  GLint base = 0;
  std::function<void(Gl)> state = [](Gl) {};
};

/// The indices as bytes of their type.
std::vector<std::byte> bytesOf(const Drawn& drawn) {
  std::vector<std::byte> bytes;
  for (const GLuint i : drawn.indices) {
    const size_t size = drawn.type == GL_UNSIGNED_SHORT ? 2 : 4;
    const auto* const from = reinterpret_cast<const std::byte*>(&i);
    bytes.insert(bytes.end(), from, from + size);
  }
  return bytes;
}

gl::Statistics compareDrawn(const ProgramMesh& mesh, const Drawn& drawn) {
  TurnedDraw how;
  how.vertex = replacedIn(kCulledVertex, "out vec3 place, n;", "flat out vec3 place; out vec3 n;");
  how.fragment = replacedIn(kCulledFragment, "in vec3 place, n;", "flat in vec3 place; in vec3 n;");
  how.prepare = [&](Gl gl) {
    const std::vector<std::byte> bytes = bytesOf(drawn);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(),
                  GL_STATIC_DRAW);
  };
  const auto draw = [&](Gl gl) {
    drawn.state(gl);
    gl.DrawElementsBaseVertex(drawn.mode, static_cast<GLsizei>(drawn.indices.size()), drawn.type, nullptr,
                              drawn.base);
  };
  return compareTurned("assembled_" + drawn.name, 4, mesh, draw, how);
}

void firstProvokes(Gl gl) { gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION); }

void restarts(Gl gl) { gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(kRestart); }

TEST(CulledPrimitives, WhereTheFirstVertexProvokes) {
  const ProgramMesh mesh = shells(5, 60);
  for (const GLenum mode : {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN})
    for (const bool first : {false, true}) {
      Drawn drawn{.name = "provoking" + std::to_string(mode), .mode = mode, .indices = mesh.indices};
      if (mode == GL_TRIANGLE_FAN) drawn.indices.resize(1200);
      if (first) drawn.state = firstProvokes;
      EXPECT_GT(compareDrawn(mesh, drawn).drawsCulled, 0u) << mode;
    }
}

TEST(CulledPrimitives, ThatRestart) {
  const ProgramMesh mesh = shells(4, 60);
  for (const GLenum mode : {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN})
    for (const bool first : {false, true}) {
      const auto state = [&](Gl gl) {
        restarts(gl);
        if (first) firstProvokes(gl);
      };
      const std::string name = "restart" + std::to_string(mode);
      const Drawn at{.name = name, .mode = mode, .indices = pieces(mesh, kRestart), .state = state};
      EXPECT_GT(compareDrawn(mesh, at).drawsCulled, 0u) << name;
    }
}

TEST(CulledPrimitives, ThatRestartAtFixedIndices) {
  const ProgramMesh mesh = shells(4, 60);  // less than 65535 vertices
  ASSERT_LT(mesh.positions.size(), 60000u);
  const auto state = [](Gl gl) { gl.Enable(GL_PRIMITIVE_RESTART_FIXED_INDEX); };
  EXPECT_GT(compareDrawn(mesh, {.name = "fixed", .indices = pieces(mesh, ~0u), .state = state}).drawsCulled,
            0u);
  const Drawn shorts{
      .name = "shorts", .indices = pieces(mesh, 0xFFFF), .type = GL_UNSIGNED_SHORT, .state = state};
  EXPECT_GT(compareDrawn(mesh, shorts).drawsCulled, 0u);
}

/// An index is compared before the base is added; an index that no number of the type is never restarts.
TEST(CulledPrimitives, ThatRestartBelowABase) {
  const ProgramMesh mesh = shells(4, 60);
  const auto back = static_cast<GLuint>(20);
  std::vector<GLuint> lower = pieces(mesh, ~0u);
  for (GLuint& i : lower) i = i == ~0u ? kRestart : i >= back ? i - back : 0;
  const Drawn base{.name = "base", .indices = lower, .base = static_cast<GLint>(back), .state = restarts};
  EXPECT_GT(compareDrawn(mesh, base).drawsCulled, 0u);
  const auto beyond = [](Gl gl) { gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(0x10007); };
  const Drawn never{
      .name = "never", .indices = pieces(mesh, kRestart), .type = GL_UNSIGNED_SHORT, .state = beyond};
  EXPECT_GT(compareDrawn(mesh, never).drawsCulled, 0u);
}

/// Vertices in order never restart; GLuRay draws them by indices.
TEST(CulledPrimitives, InOrderDoNotRestart) {
  const ProgramMesh mesh = shells(5, 60);
  const gl::Statistics counts = compareTurned("assembled_in_order", 4, mesh, [&](Gl gl) {
    gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(300);
    gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.positions.size() / 3 * 3));
  });
  EXPECT_GT(counts.drawsCulled, 0u);
}

TEST(CulledPrimitives, OfSeveralDrawsAtOnce) {
  const ProgramMesh mesh = shells(4, 60);
  const GLsizei half = mesh.count() / 6 * 3;
  const gl::Statistics counts = compareTurned("assembled_several", 4, mesh, [&](Gl gl) {
    const std::array<GLsizei, 2> sizes{half, mesh.count() - half};
    const std::array<const void*, 2> offsets{nullptr, reinterpret_cast<const void*>(half * sizeof(GLuint))};
    const std::array<GLint, 2> bases{}, firsts{0, 3000};
    gl.MultiDrawElements(GL_TRIANGLES, sizes.data(), GL_UNSIGNED_INT, offsets.data(), 2);
    gl.MultiDrawElementsBaseVertex(GL_TRIANGLES, sizes.data(), GL_UNSIGNED_INT, offsets.data(), 2,
                                   bases.data());
    const std::array<GLsizei, 2> some{2400, 3000};
    gl.MultiDrawArrays(GL_TRIANGLES, firsts.data(), some.data(), 2);
    gl.DrawRangeElementsBaseVertex(GL_TRIANGLES, 0, static_cast<GLuint>(mesh.positions.size()) - 1,
                                   mesh.count(), GL_UNSIGNED_INT, nullptr, 0);
  });
  EXPECT_GE(counts.drawsCulled, 3u * 7);
}

}  // namespace
}  // namespace gluray::test
