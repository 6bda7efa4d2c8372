// Names that glGen* gives the program: the same as without GLuRay, although GLuRay takes names, too. Programs
// use them as array indices.
#include "scenes/stage.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <vector>

namespace gluray::test {
namespace {

std::vector<GLuint> namesAfterAFrame(const gl::RealGl& gl) {
  using namespace scenes;
  std::vector<GLuint> names;
  for (int frame = 0; frame < 3; ++frame) {
    begin(gl, 64, 64);
    camera(gl, 64, 64);
    keyLight(gl);
    send(gl, sphere(8, 12));
    gl.Finish();
    const auto generate = [&](auto function) {
      GLuint made[3];
      function(3, made);
      names.insert(names.end(), made, made + 3);
    };
    generate(gl.GenTextures);
    generate(gl.GenBuffers);
    generate(gl.GenFramebuffers);
    generate(gl.GenRenderbuffers);
    generate(gl.GenVertexArrays);
    generate(gl.GenQueries);
    names.push_back(gl.GenLists(3));
    gl.BindTexture(GL_TEXTURE_2D, names[static_cast<size_t>(frame)]);
  }
  return names;
}

TEST(Names, AreThoseOfTheRealOne) {
  const auto real = OsmesaContext::create({64, 64});
  const std::vector<GLuint> expected = namesAfterAFrame(real->real());
  TracedContext ours({64, 64});
  EXPECT_EQ(namesAfterAFrame(ours.gl()), expected);
  EXPECT_GT(ours.context().counts.statistics.drawsTraced, 0u);
}

/// Programs make windows one after the other, and several at a time.
TEST(Names, AreThoseOfTheRealOneInLaterContexts) {
  const auto real = OsmesaContext::create({64, 64});
  const std::vector<GLuint> expected = namesAfterAFrame(real->real());
  for (int i = 0; i < 6; ++i) {
    TracedContext ours({64, 64});
    EXPECT_EQ(namesAfterAFrame(ours.gl()), expected) << "context " << i;
    TracedContext sharing({64, 64}, TracedContext::vertexShading(), nullptr, &ours);
    namesAfterAFrame(sharing.gl());
    EXPECT_GT(sharing.context().counts.statistics.drawsTraced, 0u);
    GLuint next = 0;
    sharing.gl().GenTextures(1, &next);
    EXPECT_LT(next, 1000u);
  }
}

}  // namespace
}  // namespace gluray::test
