// A draw of instances in a few frames, whole and culled.
#pragma once
#include "tests/reference/culled/swarm.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace gluray::test::culled {

struct Instanced {
  std::string name;
  Placing placing = kPlacings[0];
  std::function<void(Gl, const ProgramMesh&, const Swarm&)> draw = [](Gl gl, const ProgramMesh& mesh,
                                                                      const Swarm& s) {
    gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, countOf(s));
  };
  GLuint divisor = 1;
  std::function<void(Gl, GLuint program, int frame)> before = [](Gl, GLuint, int) {};
  std::string vertex = {};    // instead of the placing's
  std::string fragment = {};  // instead of the usual one
  int samples = 1, verify = 0;
  Swarm swarm = culled::swarm(7);
  ProgramMesh mesh = ball(10);
};

inline constexpr int kInstancedFrames = 5;

inline gl::Statistics compareInstanced(const Instanced& of) {
  GLuint program = 0, array = 0;
  Settings settings = culling(Culling::always);
  settings.cull.verify = of.verify;
  return compareSamples(
      "instanced_" + of.name, kInstancedFrames, of.samples, GL_DEPTH24_STENCIL8,
      [&](Gl gl) {
        const std::string& vertex = of.vertex.empty() ? vertexOf(of.placing) : of.vertex;
        program = makeProgram(gl, vertex, of.fragment.empty() ? tintedFragment() : of.fragment);
        array = send(gl, of.mesh, program).array;
        sendSwarm(gl, program, of.swarm, of.divisor);
      },
      [&](Gl gl, int frame) {
        clear(gl);
        gl.UseProgram(program), gl.BindVertexArray(array);
        turn(gl, program, frame);
        of.before(gl, program, frame);
        of.draw(gl, of.mesh, of.swarm);
      },
      &settings, {kSide, kSide, true, 3, 3});
}

/// All frames but the first are culled, of at least `share` of their triangles.
inline void expectCulled(const Instanced& of, double share = 0.3) {
  const gl::Statistics counts = compareInstanced(of);
  const double all = double(kInstancedFrames - 1) * double(of.mesh.triangles() * of.swarm.count());
  EXPECT_EQ(counts.drawsCulled, uint64_t{kInstancedFrames - 1}) << of.name;
  EXPECT_GT(double(uint64_t{counts.trianglesLeftOut}), share * all) << of.name;
}

inline void expectWhole(const Instanced& of) { EXPECT_EQ(compareInstanced(of).drawsCulled, 0u) << of.name; }

}  // namespace gluray::test::culled
