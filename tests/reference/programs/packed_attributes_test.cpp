// Attributes that are packed into 32 bits: current values, vertices of glBegin and of lists.
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <vector>

namespace gluray::test {
namespace {

constexpr GLuint packed(GLuint x, GLuint y, GLuint z, GLuint w) {
  return (x & 1023u) | (y & 1023u) << 10 | (z & 1023u) << 20 | w << 30;
}
constexpr GLuint kSomeValue = packed(300, 900, 511, 1), kOtherValue = packed(512, 1023, 0, 2);

/// Sets every attribute that can be packed and appends their values, bit for bit.
void sendAndRead(Gl gl, std::vector<GLuint>& values) {
  std::array<GLfloat, 4> v{};
  const auto note = [&](size_t components = 4) {  // Mesa 22.3 may leave those not given as they were
    for (size_t i = 0; i < components; ++i) values.push_back(std::bit_cast<GLuint>(v[i]));
  };
  for (const GLenum type : {GL_INT_2_10_10_10_REV, GL_UNSIGNED_INT_2_10_10_10_REV}) {
    for (const GLuint value : {kSomeValue, kOtherValue}) {
      gl.ColorP4ui(type, value), gl.GetFloatv(GL_CURRENT_COLOR, v.data()), note();
      gl.ColorP3ui(type, value), gl.GetFloatv(GL_CURRENT_COLOR, v.data()), note(3);
      gl.NormalP3ui(type, value), gl.GetFloatv(GL_CURRENT_NORMAL, v.data()), note(3);
      gl.TexCoordP4ui(type, value), gl.GetFloatv(GL_CURRENT_TEXTURE_COORDS, v.data()), note();
      gl.SecondaryColorP3ui(type, value), gl.GetFloatv(GL_CURRENT_SECONDARY_COLOR, v.data()), note(3);
      for (const GLboolean normalise : {GL_FALSE, GL_TRUE}) {
        gl.VertexAttribP4ui(3, type, normalise, value);
        gl.GetVertexAttribfv(3, GL_CURRENT_VERTEX_ATTRIB, v.data()), note();
        gl.VertexAttribP2ui(3, type, normalise, value);
        gl.GetVertexAttribfv(3, GL_CURRENT_VERTEX_ATTRIB, v.data()), note(2);
      }
    }
  }
  for (const GLuint value : {0x12345678u, 0xF7FDFFBFu, 0x00200801u}) {
    gl.VertexAttribP3ui(3, GL_UNSIGNED_INT_10F_11F_11F_REV, GL_FALSE, value);
    gl.GetVertexAttribfv(3, GL_CURRENT_VERTEX_ATTRIB, v.data()), note(3);
  }
  gl.VertexAttrib1f(3, 0);
  gl.ColorP3ui(GL_UNSIGNED_INT_10F_11F_11F_REV, kSomeValue), values.push_back(gl.GetError());
  gl.ColorP4ui(GL_UNSIGNED_INT_2_10_10_10_REV, 0xFFFFFFFFu);
}

void sendTriangle(Gl gl, GLenum type, GLfloat left) {
  gl.Begin(GL_TRIANGLES);
  gl.ColorP4ui(type, packed(511, 1023, 100, 1)), gl.Vertex3f(left, -0.9f, 0);
  gl.ColorP4ui(type, packed(0, 400, 512, 2)), gl.Vertex3f(left + 0.4f, -0.9f, 0.1f);
  gl.ColorP4ui(type, packed(200, 1, 511, 3)), gl.Vertex3f(left, 0.9f, 0.2f);
  gl.End();
}

class PackedAttributes : public testing::TestWithParam<ContextWish> {};

TEST_P(PackedAttributes, HaveTheRealValues) {
  std::array<std::vector<GLuint>, 2> values;
  size_t run = 0;
  expectSame(
      "packed_values",
      [&](Gl gl) {
        beginFrame(gl);
        sendAndRead(gl, values[run++ % 2]);
      },
      -1, GetParam());
  ASSERT_EQ(values[0].size(), values[1].size());
  for (size_t i = 0; i < values[0].size(); ++i) EXPECT_EQ(values[0][i], values[1][i]) << "value " << i;
  EXPECT_GT(values[0].size(), 80u);
}

TEST_P(PackedAttributes, ColourVertices) {
  const Outcome o = expectSame(
      "packed_vertices",
      [](Gl gl) {
        beginFrame(gl);
        sendTriangle(gl, GL_INT_2_10_10_10_REV, -0.9f),
            sendTriangle(gl, GL_UNSIGNED_INT_2_10_10_10_REV, -0.4f);
        const GLuint list = gl.GenLists(1);
        gl.NewList(list, GL_COMPILE), sendTriangle(gl, GL_INT_2_10_10_10_REV, 0.1f), gl.EndList();
        gl.CallList(list), gl.DeleteLists(list, 1), gl.Color3f(1, 1, 1);
      },
      -1, GetParam());
  EXPECT_GT(o.statistics.drawsTraced, 0u);
}

INSTANTIATE_TEST_SUITE_P(Contexts, PackedAttributes,
                         testing::Values(ContextWish{kProgramWidth, kProgramHeight, false, 0, 0},
                                         ContextWish{kProgramWidth, kProgramHeight, false, 3, 1}));

}  // namespace
}  // namespace gluray::test
