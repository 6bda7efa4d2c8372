// Instanced draws whose arrays have several divisors or signed fractions, whose positions are fed back, and
// whose shaders read numbers of instances: images are those of whole draws to the bit.
#include "tests/reference/culled/instanced_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

using namespace culled;

TEST(CulledInstances, WherePositionsAreFedBack) {
  for (const Placing& placing : kFedPlacings) expectCulled({.name = placing.name, .placing = placing});
  for (const int samples : {1, 4})
    expectCulled({.name = "fed_verified", .placing = kFedPlacings[0], .samples = samples, .verify = 1});
  Instanced of{.name = "fed_base", .placing = kFedPlacings[0]};
  of.draw = [](Gl gl, const ProgramMesh& mesh, const Swarm& s) {
    gl.DrawElementsInstancedBaseInstance(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr,
                                         countOf(s) - 40, 33);
  };
  expectCulled(of, 0.25);
  of.name = "fed_divisor", of.divisor = 3, of.swarm = swarm(6);
  of.draw = [](Gl gl, const ProgramMesh& mesh, const Swarm& s) {
    gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 3, static_cast<GLsizei>(mesh.positions.size()) - 3,
                           3 * countOf(s) - 1);
  };
  EXPECT_EQ(compareInstanced(of).drawsCulled, 4u);
  Instanced single{.name = "fed_single", .placing = kFedPlacings[0], .mesh = shells(5, 60)};
  single.swarm.moved[5] = glm::vec4(0, 0, 0, 1);
  single.draw = [](Gl gl, const ProgramMesh& mesh, const Swarm&) {
    gl.DrawElementsInstancedBaseInstance(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, 1, 5);
  };
  EXPECT_EQ(compareInstanced(single).drawsCulled, 4u);
}

/// Arrays that advance at other rates begin with later elements in parts of the draw.
TEST(CulledInstances, OfSeveralDivisors) {
  for (const GLuint tints : {2u, 3u, 50u, 1000u}) {
    Instanced of{.name = "mixed" + std::to_string(tints)};
    of.before = [=](Gl gl, GLuint program, int) {
      gl.VertexAttribDivisor(static_cast<GLuint>(gl.GetAttribLocation(program, "tint")), tints);
    };
    expectCulled(of);
  }
  Instanced of{.name = "mixed_places", .placing = kPlacings[4], .divisor = 2};
  of.before = [=](Gl gl, GLuint program, int) {
    gl.VertexAttribDivisor(static_cast<GLuint>(gl.GetAttribLocation(program, "moved")), 1);
    gl.VertexAttribDivisor(static_cast<GLuint>(gl.GetAttribLocation(program, "tint")), 3);
  };
  expectCulled(of);
}

/// Eight large instances.
Instanced fewOf(const std::string& name, const Placing& placing) {
  Instanced of{.name = name, .placing = placing, .mesh = shells(4, 40)};
  for (size_t i = 0; i < 8; ++i) {
    const glm::vec3 at(0.5f * float(i % 3) - 0.5f, 0.5f * float(i / 3) - 0.5f, 0.1f * float(i));
    of.swarm.matrices[i] = glm::scale(glm::translate(glm::mat4(1), at), glm::vec3(0.45f));
    of.swarm.moved[i] = glm::vec4(at, 0.45f);
  }
  of.draw = [](Gl gl, const ProgramMesh& mesh, const Swarm&) {
    gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, 8);
  };
  return of;
}

/// Clusters that show in any instance are drawn in all of them where shaders read their numbers.
TEST(CulledInstances, FewLargeOnesByFeedbackAndWithNumbers) {
  const Instanced fed = fewOf("few_fed", kFedPlacings[0]);
  gl::Statistics counts = compareInstanced(fed);
  EXPECT_EQ(counts.drawsCulled, 4u);
  EXPECT_GT(counts.trianglesLeftOut, 2 * 8 * fed.mesh.triangles());
  for (const Placing& placing : {kPlacings[1], kFedPlacings[0]})
    for (const int samples : {1, 4}) {
      Instanced numbered = fewOf(std::string("few_numbered_") + placing.name, placing);
      numbered.samples = samples;
      numbered.vertex = replacedIn(vertexOf(placing), "color = tint;",
                                   "color = tint * (0.5 + 0.1 * float(gl_InstanceID % 5));");
      counts = compareInstanced(numbered);
      EXPECT_EQ(counts.drawsCulled, 4u) << numbered.name;
      EXPECT_GT(counts.trianglesLeftOut, 8 * numbered.mesh.triangles()) << numbered.name;
    }
  Instanced placed = fewOf("few_placed_by_numbers", kPlacings[1]);
  placed.vertex =
      replacedIn(vertexOf(kPlacings[1]), "moved.xyz;", "moved.xyz + 0.02 * float(gl_InstanceID);");
  placed.verify = 1;
  counts = compareInstanced(placed);
  EXPECT_EQ(counts.drawsCulled, 4u);
  EXPECT_GT(counts.trianglesLeftOut, 8 * placed.mesh.triangles());
}

/// Places of bytes and shorts, with the lowest ones among them, which OpenGLs read in two ways.
TEST(CulledInstances, PlacedBySignedFractions) {
  for (const GLenum type : {GL_BYTE, GL_SHORT}) {
    Instanced of{.name = type == GL_BYTE ? "bytes" : "shorts", .placing = kPlacings[2]};
    std::vector<GLbyte> bytes;
    std::vector<GLshort> shorts;
    for (const glm::vec3& shift : of.swarm.shifts)
      for (int c = 0; c < 4; ++c) {
        const float value = c < 3 ? shift[c] : 0;
        bytes.push_back(static_cast<GLbyte>(std::lround(127 * value)));
        shorts.push_back(static_cast<GLshort>(std::lround(32767 * value)));
      }
    bytes[4] = -128, bytes[9] = -127, bytes[14] = 127;
    shorts[4] = -32768, shorts[9] = -32767, shorts[14] = 32767;
    of.before = [&, type](Gl gl, GLuint program, int frame) {
      if (frame > 0) return;
      GLuint buffer = 0;
      gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
      if (type == GL_BYTE)
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
      else
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(2 * shorts.size()), shorts.data(),
                      GL_STATIC_DRAW);
      gl.VertexAttribPointer(static_cast<GLuint>(gl.GetAttribLocation(program, "shift")), 3, type, GL_TRUE,
                             type == GL_BYTE ? 4 : 8, nullptr);
    };
    expectCulled(of);
  }
}

}  // namespace
}  // namespace gluray::test
