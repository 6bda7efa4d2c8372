// Layers that are blended over surfaces of equal depth, which were traced or are drawn again.
#include "tests/reference/layers/drawn_layers_stage.h"

#include <string>
#include <vector>

namespace gluray::test::drawn_layers {
namespace {

/// Triangles of a model one after the other: positions and normals, after colours and texture coordinates if
/// `colored`.
std::vector<float> interleaved(const scenes::Model& model, bool colored) {
  std::vector<float> all;
  for (const uint32_t i : model.indices) {
    if (colored) all.insert(all.end(), {0, 0, 0.2f, 0.6f, 0.9f, 1});
    for (const std::vector<float>* from : {&model.normals, &model.positions})
      all.insert(all.end(), from->begin() + 3 * i, from->begin() + 3 * i + 3);
  }
  return all;
}

// Depths of two tracings differ in the last bits, whatever the second one writes.
TEST(DrawnLayersDepths, OverTheSameTrianglesOfOtherArrays) {
  for (const GLenum function : {GL_LESS, GL_LEQUAL})
    for (const bool blended : {false, true}) {
      const auto draw = [&](Gl gl) {
        gl.DepthFunc(function);
        const scenes::Model model = scenes::sphere(12, 18);
        gl.PushMatrix();
        gl.Rotatef(166, 0.56f, -0.33f, 1);
        for (const bool first : {true, false}) {
          const std::vector<float> arrays = interleaved(model, first);
          gl.InterleavedArrays(first ? GL_T2F_C4F_N3F_V3F : GL_N3F_V3F, 0, arrays.data());
          if (!first) gl.Color4f(0.9f, 0.2f, 0.1f, 0.5f), gl.DepthMask(GL_FALSE);
          if (!first && blended) blendOver(gl);
          gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(model.indices.size()));
        }
        // The arrays end here.
        for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY}) gl.DisableClientState(array);
        gl.VertexPointer(3, GL_FLOAT, 0, nullptr), gl.NormalPointer(GL_FLOAT, 0, nullptr);
        gl.ColorPointer(4, GL_FLOAT, 0, nullptr), gl.TexCoordPointer(2, GL_FLOAT, 0, nullptr);
        gl.PopMatrix();
      };
      compareBoth(theStage(), "same triangles" + std::to_string(function) + (blended ? " blended" : ""),
                  draw);
    }
}

TEST(DrawnLayersDepths, OverASurfaceWhoseDepthIsDrawnAgain) {
  for (const GLenum function : {GL_LESS, GL_LEQUAL}) {
    const auto draw = [&](Gl gl) {
      gl.DepthFunc(function);
      gl.Rotatef(166, 0.56f, -0.33f, 1);
      ball(gl, {0, 0, {0.2f, 0.6f, 0.9f, 1}});
      blendOver(gl);
      gl.DepthMask(GL_FALSE);
      ball(gl, {0, 0, {0.9f, 0.2f, 0.1f, 0.5f}});
      gl.Enable(GL_STENCIL_TEST);
      ball(gl, {0, 0, {0.1f, 0.9f, 0.1f, 0.5f}});
      gl.Disable(GL_STENCIL_TEST);
    };
    compareBoth(theStage(), "again" + std::to_string(function), draw);
  }
}

}  // namespace
}  // namespace gluray::test::drawn_layers
