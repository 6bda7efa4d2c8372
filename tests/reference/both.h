// Draws with the real OpenGL and through GLuRay, and compares colours, alpha, depth and state.
#pragma once
#include "scenes/scene.h"
#include "tests/support/gl_state.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>

namespace gluray::test {

using Draw = std::function<void(scenes::Gl)>;

/// Both draw into contexts of this size; differing images are written to `folder` of the tests' output.
struct BothStage {
  int width = 120, height = 90;
  std::string folder;
  Draw prepare;  // before each
  scenes::Tolerance tolerance = {};
  Settings settings = TracedContext::vertexShading();
};

/// Returns GLuRay's counts.
inline gl::Statistics compareBoth(const BothStage& stage, const std::string& name, const Draw& draw,
                                  std::unique_ptr<gl::Presenter> presenter = nullptr) {
  SCOPED_TRACE(name);
  const auto seenBy = [&](scenes::Gl gl) {
    stage.prepare(gl);
    draw(gl);
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    GlState state = queryState(gl);
    return std::pair(readImage(gl, stage.width, stage.height), std::move(state));
  };
  const auto expected = [&] {
    const auto real = OsmesaContext::create({stage.width, stage.height});
    return seenBy(real->real());
  }();
  TracedContext ours({stage.width, stage.height}, stage.settings, std::move(presenter));
  const auto got = seenBy(ours.gl());
  for (const std::string& line : differences(expected.second, got.second)) ADD_FAILURE() << line;
  const Comparison c = compare(expected.first, got.first, stage.tolerance);
  EXPECT_TRUE(c.accepted) << c.text;
  if (!c.accepted) writeFailure(TEST_OUTPUT "/" + stage.folder, name, expected.first, got.first);
  return ours.context().counts.statistics;
}

}  // namespace gluray::test
