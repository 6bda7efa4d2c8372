// Random swarms, programs that place them, and states: images of culled instances are those of whole draws
// to the bit.
#include "tests/reference/culled/swarm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <random>
#include <string>

namespace gluray::test {
namespace {

using namespace culled;

struct RandomSwarm {
  Swarm swarm;
  ProgramMesh mesh;
  Placing placing;
  std::string vertex;
  GLuint divisor = 1, tintDivisor = 1, baseInstance = 0;
  GLsizei instances = 0;
  GLenum function = GL_LESS, mode = GL_TRIANGLES;
  bool cullsFaces = false, changes = false, below = false;
  int samples = 1, verify = 0;

  explicit RandomSwarm(unsigned seed) {
    std::mt19937 random(seed);
    const auto upTo = [&](unsigned end) { return static_cast<unsigned>(random() % end); };
    swarm = culled::swarm(4 + static_cast<int>(upTo(4)), seed);
    mesh = upTo(2) ? ball(4 + static_cast<int>(upTo(14))) : shells(2, 4 + static_cast<int>(upTo(8)));
    const bool fed = !upTo(3);
    placing = fed ? kFedPlacings[upTo(static_cast<unsigned>(std::size(kFedPlacings)))]
                  : kPlacings[upTo(static_cast<unsigned>(std::size(kPlacings)))];
    vertex = vertexOf(placing);
    const std::array<GLuint, 4> divisors{1, 1, 2, 5};
    divisor = divisors[upTo(4)];
    baseInstance = upTo(3) ? 0 : upTo(30);
    const auto most = static_cast<GLuint>(swarm.count()) - baseInstance;
    instances = static_cast<GLsizei>(2 + upTo(divisor * most - 2));
    tintDivisor = upTo(2) ? divisor : 1 + upTo(9);
    if (!upTo(5)) readNumbers(random);
    const std::array<GLenum, 3> functions{GL_LESS, GL_LEQUAL, GL_GREATER};
    function = functions[upTo(3)];
    if (!upTo(4)) mode = GL_TRIANGLE_STRIP;
    cullsFaces = upTo(2), changes = upTo(2), below = upTo(2);
    samples = upTo(3) ? 1 : 4, verify = upTo(4) ? 0 : 1;
    if (!upTo(3)) makeTwins(random);
    if (!upTo(3)) addExtremes(random);
  }

 private:
  /// Few large instances, whose numbers the shader reads.
  void readNumbers(std::mt19937& random) {
    vertex = random() % 2
                 ? replacedIn(vertex, "color = tint;", "color = tint + 0.1 * float(gl_InstanceID % 4);")
                 : replacedIn(vertex, "vec4(world, 1.0)", "vec4(world + 0.03 * float(gl_InstanceID), 1.0)");
    mesh = shells(4, 40), instances = static_cast<GLsizei>(2 + random() % 20);
  }
  /// Instances at the places of others: the order decides which ones show.
  void makeTwins(std::mt19937& random) {
    for (size_t i = 0; i < swarm.count(); i += 1 + random() % 5) {
      const size_t j = random() % swarm.count();
      swarm.matrices[i] = swarm.matrices[j], swarm.moved[i] = swarm.moved[j];
      swarm.q[i] = swarm.q[j], swarm.shifts[i] = swarm.shifts[j];
      std::copy_n(swarm.rows.begin() + static_cast<ptrdiff_t>(12 * j), 12,
                  swarm.rows.begin() + static_cast<ptrdiff_t>(12 * i));
    }
  }
  void addExtremes(std::mt19937& random) {
    for (const float value : {0.0f, 1e6f, -1e12f, 1e30f}) {
      swarm.moved[random() % swarm.count()].w = value;
      swarm.matrices[random() % swarm.count()][1] *= value;
      swarm.shifts[random() % swarm.count()].z = value;
    }
  }
};

gl::Statistics compareRandomSwarm(unsigned seed) {
  const RandomSwarm of(seed);
  SCOPED_TRACE(std::string(of.placing.name) + ", divisors " + std::to_string(of.divisor) + " and " +
               std::to_string(of.tintDivisor) + "\n" + of.vertex);
  SCOPED_TRACE(std::to_string(of.samples) + " samples, seed " + std::to_string(seed));
  Settings settings = culling(Culling::always);
  settings.cull.verify = of.verify;
  GLuint program = 0, array = 0;
  return compareSamples(
      "random_instances" + std::to_string(seed), 4, of.samples, GL_DEPTH24_STENCIL8,
      [&](Gl gl) {
        program = makeProgram(gl, of.vertex, tintedFragment());
        array = send(gl, of.mesh, program).array;
        sendSwarm(gl, program, of.swarm, of.divisor);
        gl.VertexAttribDivisor(static_cast<GLuint>(gl.GetAttribLocation(program, "tint")), of.tintDivisor);
      },
      [&](Gl gl, int frame) {
        clear(gl);
        gl.UseProgram(program), gl.BindVertexArray(array);
        turn(gl, program, of.changes ? 5 * frame * frame : frame);
        gl.DepthFunc(of.function);
        if (of.function == GL_GREATER) gl.ClearDepth(0), gl.Clear(GL_DEPTH_BUFFER_BIT);
        of.cullsFaces ? gl.Enable(GL_CULL_FACE) : gl.Disable(GL_CULL_FACE);
        if (of.below)
          gl.DrawElementsInstanced(GL_TRIANGLES, of.mesh.count() / 6 * 3, GL_UNSIGNED_INT, nullptr, 3);
        gl.DrawElementsInstancedBaseInstance(of.mode, of.mesh.count(), GL_UNSIGNED_INT, nullptr,
                                             of.instances - (of.changes ? frame % 2 : 0), of.baseInstance);
      },
      &settings, {kSide, kSide, true, 3, 3});
}

TEST(RandomInstances, AreTheSameCulled) {
  uint64_t culled = 0, left = 0;
  // GLURAY_SEEDS: more of them.
  const char* const wish = std::getenv("GLURAY_SEEDS");
  const unsigned seeds = wish ? static_cast<unsigned>(std::strtoul(wish, nullptr, 10)) : 20;
  for (unsigned seed = 1; seed <= seeds && !HasFailure(); ++seed) {
    const gl::Statistics counts = compareRandomSwarm(seed);
    culled += counts.drawsCulled, left += counts.trianglesLeftOut;
  }
  EXPECT_GT(culled, 2 * uint64_t{seeds});
  EXPECT_GT(left, 1000 * uint64_t{seeds});
}

}  // namespace
}  // namespace gluray::test
