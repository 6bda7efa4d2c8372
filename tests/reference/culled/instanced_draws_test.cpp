// Instanced draws, made without the instances that cannot be seen: images are those of whole draws to the
// bit.
#include "tests/reference/culled/instanced_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

using namespace culled;

TEST(CulledInstances, AreTheSameHoweverTheyArePlaced) {
  for (const Placing& placing : kPlacings) expectCulled({.name = placing.name, .placing = placing});
}

TEST(CulledInstances, OfAllDivisors) {
  for (const GLuint divisor : {2u, 3u, 7u}) {
    Instanced of{.name = "divisor" + std::to_string(divisor), .divisor = divisor};
    of.draw = [=](Gl gl, const ProgramMesh& mesh, const Swarm& s) {
      gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr,
                               countOf(s) * static_cast<GLsizei>(divisor) - 1);
    };
    of.swarm = swarm(6);
    EXPECT_EQ(compareInstanced(of).drawsCulled, 4u) << divisor;
  }
}

TEST(CulledInstances, WithBaseInstances) {
  Instanced of{.name = "base"};
  of.draw = [](Gl gl, const ProgramMesh& mesh, const Swarm& s) {
    gl.DrawElementsInstancedBaseInstance(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr,
                                         countOf(s) - 40, 33);
  };
  expectCulled(of, 0.25);
  of.name = "base_vertex", of.mesh = shells(2, 8);
  of.draw = [](Gl gl, const ProgramMesh& mesh, const Swarm& s) {
    const auto half = static_cast<GLint>(mesh.positions.size() / 2);
    gl.DrawElementsInstancedBaseVertexBaseInstance(GL_TRIANGLES, mesh.count() / 2, GL_UNSIGNED_INT, nullptr,
                                                   countOf(s) - 40, half, 40);
    gl.DrawElementsInstancedBaseVertex(GL_TRIANGLES, mesh.count() / 2, GL_UNSIGNED_INT, nullptr, 40, half);
  };
  EXPECT_EQ(compareInstanced(of).drawsCulled, 8u);
}

TEST(CulledInstances, OfAllForms) {
  Instanced of{.name = "arrays"};
  of.draw = [](Gl gl, const ProgramMesh& mesh, const Swarm& s) {
    gl.DrawArraysInstanced(GL_TRIANGLES, 3, static_cast<GLsizei>(mesh.positions.size() / 3 * 3 - 3),
                           countOf(s));
  };
  EXPECT_EQ(compareInstanced(of).drawsCulled, 4u);
  of.name = "arrays_base";
  of.draw = [](Gl gl, const ProgramMesh& mesh, const Swarm& s) {
    gl.DrawArraysInstancedBaseInstance(GL_TRIANGLE_STRIP, 0, static_cast<GLsizei>(mesh.positions.size()),
                                       countOf(s) - 12, 12);
  };
  EXPECT_EQ(compareInstanced(of).drawsCulled, 4u);
  of.name = "strips";
  of.draw = [](Gl gl, const ProgramMesh& mesh, const Swarm& s) {
    gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(17);
    gl.DrawElementsInstanced(GL_TRIANGLE_STRIP, mesh.count(), GL_UNSIGNED_INT, nullptr, countOf(s));
  };
  EXPECT_EQ(compareInstanced(of).drawsCulled, 4u);
}

/// The values of instances change in each frame, and so does their number.
TEST(CulledInstances, ThatMove) {
  for (const bool replaced : {false, true}) {
    Swarm now = swarm(7);
    GLsizei drawn = 0;
    Instanced of{.name = replaced ? "replaced" : "moving", .placing = kPlacings[1]};
    of.before = [&](Gl gl, GLuint program, int frame) {
      GLint buffer = 0;
      gl.GetVertexAttribiv(static_cast<GLuint>(gl.GetAttribLocation(program, "moved")),
                           GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &buffer);
      for (size_t i = 0; i < now.count(); ++i)
        now.moved[i] = of.swarm.moved[(i + static_cast<size_t>(37 * frame)) % now.count()];
      drawn = countOf(now) - 21 * (frame % 3);
      gl.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(buffer));
      const auto size = static_cast<GLsizeiptr>(now.count() * sizeof(glm::vec4));
      if (replaced)
        gl.BufferData(GL_ARRAY_BUFFER, size, now.moved.data(), GL_STREAM_DRAW);
      else
        gl.BufferSubData(GL_ARRAY_BUFFER, 0, size, now.moved.data());
    };
    of.draw = [&](Gl gl, const ProgramMesh& mesh, const Swarm&) {
      gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, drawn);
    };
    expectCulled(of, 0.15);
  }
}

/// Each instance three times, in other colours: which one shows depends on the order.
TEST(CulledInstances, KeepTheOrderOfEqualDepths) {
  Instanced of{.name = "equal"};
  const Swarm one = swarm(6);
  for (const size_t start : {size_t{50}, size_t{131}})
    for (size_t i = 0; i < one.count(); ++i) {
      of.swarm.matrices.push_back(one.matrices[(i + start) % one.count()]);
      of.swarm.tints.push_back(one.tints[(3 * i + start) % one.count()]);
    }
  for (const GLenum function : {GL_LESS, GL_LEQUAL})
    for (const int samples : {1, 4}) {
      of.samples = samples;
      of.before = [&](Gl gl, GLuint, int) { gl.DepthFunc(function); };
      EXPECT_EQ(compareInstanced(of).drawsCulled, 4u);
    }
}

TEST(CulledInstances, InMultisampledFramebuffers) {
  for (const int verify : {0, 1}) expectCulled({.name = "samples", .samples = 4, .verify = verify});
  // What the first draw has left cannot be put back.
  Instanced of{.name = "samples_above", .samples = 4};
  of.draw = [](Gl gl, const ProgramMesh& mesh, const Swarm& s) {
    const GLsizei half = countOf(s) / 2;
    gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, half);
    gl.DrawElementsInstancedBaseInstance(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, half,
                                         static_cast<GLuint>(half));
  };
  EXPECT_EQ(compareInstanced(of).drawsCulled, 8u);
}

TEST(CulledInstances, AreVerified) { expectCulled({.name = "verified", .verify = 1}); }

TEST(CulledInstances, KeepDiscardedFragmentsAndOtherState) {
  Instanced of{.name = "holes"};
  of.fragment = replacedIn(tintedFragment(), "vec3 light = vec3(0.1);",
                           "if (fract(4.0 * part.x) < 0.4) discard;\n"
                           "  vec3 light = vec3(0.1) + 3.0 * fwidth(part);");
  of.before = [](Gl gl, GLuint, int) { gl.Enable(GL_CULL_FACE), gl.Viewport(20, 10, 150, 170); };
  EXPECT_EQ(compareInstanced(of).drawsCulled, 4u);
  Instanced reversed{.name = "reversed"};
  reversed.before = [](Gl gl, GLuint, int) {
    gl.ClearDepth(0), gl.Clear(GL_DEPTH_BUFFER_BIT), gl.DepthRange(1, 0), gl.DepthFunc(GL_GREATER);
  };
  expectCulled(reversed);
}

/// A single instance is one mesh, whose clusters are culled; a draw without instances uses the first element.
TEST(CulledInstances, SingleOnes) {
  Instanced of{.name = "single", .mesh = shells(5, 60)};
  of.swarm.matrices[5] = of.swarm.matrices[0] = glm::rotate(glm::mat4(1), 0.4f, glm::vec3(0, 0, 1));
  of.draw = [](Gl gl, const ProgramMesh& mesh, const Swarm&) {
    gl.DrawElementsInstancedBaseInstance(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, 1, 5);
  };
  const uint64_t triangles = of.mesh.triangles();
  gl::Statistics counts = compareInstanced(of);
  EXPECT_EQ(counts.drawsCulled, 4u);
  EXPECT_GT(counts.trianglesLeftOut, 2 * triangles);
  of.name = "without";
  of.draw = [](Gl gl, const ProgramMesh& mesh, const Swarm&) {
    gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
  };
  counts = compareInstanced(of);
  EXPECT_EQ(counts.drawsCulled, 4u);
  EXPECT_GT(counts.trianglesLeftOut, 2 * triangles);
}

/// Few instances of large meshes are culled by their clusters.
TEST(CulledInstances, FewLargeOnes) {
  for (const GLuint divisor : {1u, 2u})
    for (const int samples : {1, 4}) {
      Instanced of{.name = "few", .divisor = divisor, .samples = samples, .verify = samples / 4};
      of.mesh = shells(4, 40);
      for (size_t i = 0; i < 9; ++i) {
        const glm::vec3 at(0.5f * float(i % 3) - 0.5f, 0.5f * float(i / 3) - 0.5f, 0.1f * float(i));
        of.swarm.matrices[i] = glm::scale(glm::translate(glm::mat4(1), at), glm::vec3(0.45f));
      }
      of.draw = [=](Gl gl, const ProgramMesh& mesh, const Swarm&) {
        gl.DrawElementsInstancedBaseInstance(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr,
                                             static_cast<GLsizei>(8 * divisor) - 1, 1);
      };
      const gl::Statistics counts = compareInstanced(of);
      EXPECT_EQ(counts.drawsCulled, 4u);
      EXPECT_GT(counts.trianglesLeftOut, 2 * (8 * divisor - 1) * of.mesh.triangles());
    }
}

TEST(CulledInstances, AllAtOnePlace) {
  Instanced of{.name = "one_place", .mesh = shells(3, 40)};
  of.vertex = replacedIn(vertexOf(kPlacings[0]), "(place * vec4(position, 1.0)).xyz", "position");
  of.draw = [](Gl gl, const ProgramMesh& mesh, const Swarm&) {
    gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, 3);
  };
  EXPECT_EQ(compareInstanced(of).drawsCulled, 4u);
}

TEST(CulledInstances, WithValuesThatNoShaderCanUse) {
  Instanced of{.name = "endless", .placing = kPlacings[1]};
  of.swarm.moved[20].x = std::numeric_limits<float>::quiet_NaN();
  of.swarm.moved[21].y = std::numeric_limits<float>::infinity();
  of.swarm.moved[22].w = 1e20f;
  of.swarm.moved[23].w = 0;
  EXPECT_EQ(compareInstanced(of).drawsCulled, 4u);
}

TEST(CulledInstances, AreNotMadeWhereTheyWouldNotBeExact) {
  const std::string usual = vertexOf(kPlacings[0]);
  const auto colored = [&](const std::string& by) {
    return replacedIn(usual, "color = tint;", "color = " + by);
  };
  expectWhole({.name = "numbered", .vertex = colored("tint * float(gl_InstanceID % 3);")});
  expectWhole({.name = "numbered_fed",
               .vertex = replacedIn(vertexOf(kFedPlacings[0]), "color = tint;",
                                    "color = tint * float(gl_InstanceID % 3);")});
  expectWhole({.name = "fixed", .draw = [](Gl gl, const ProgramMesh& mesh, const Swarm&) {
                 // Elements that do not exist.
                 gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, 400);
               }});
  // Several divisors, and an array that ends before the draw does.
  const auto mixed = [](Gl gl, GLuint program, int) {
    gl.VertexAttribDivisor(static_cast<GLuint>(gl.GetAttribLocation(program, "tint")), 2);
    gl.VertexAttribDivisor(static_cast<GLuint>(gl.GetAttribLocation(program, "normal")), 1);
  };
  expectWhole({.name = "mixed", .before = mixed});
}

TEST(CulledInstances, KeepTheErrorsOfThePrograms) {
  for (const Culling how : {Culling::off, Culling::always}) {
    TracedContext context({kSide, kSide, true, 3, 3}, culling(how));
    Gl gl = context.gl();
    const ProgramMesh mesh = ball(10);
    const Swarm all = swarm(5);
    const GLuint program = makeProgram(gl, vertexOf(kPlacings[0]), tintedFragment());
    send(gl, mesh, program), sendSwarm(gl, program, all);
    for (int frame = 0; frame < 3; ++frame) {
      clear(gl);
      gl.UseProgram(program);
      turn(gl, program, frame);
      gl.Enable(GL_TEXTURE_MIN_FILTER);  // names nothing that can be enabled
      gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, countOf(all));
      EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_ENUM)) << frame;
      gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, -1);
      EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_VALUE)) << frame;
      EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR)) << frame;
    }
    EXPECT_EQ(context.context().counts.statistics.drawsCulled > 0, how == Culling::always);
  }
}

}  // namespace
}  // namespace gluray::test
