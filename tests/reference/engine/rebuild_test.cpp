// Geometry outlives the frame: only changes of shape rebuild an acceleration structure.
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace gluray::test {
namespace {

constexpr int kRebuiltSize = 64;

/// A bumpy sheet of n x n squares with a colour at each vertex.
struct Sheet {
  std::vector<GLfloat> positions, normals, colors;
  std::vector<GLuint> indices;

  explicit Sheet(GLuint n) {
    for (GLuint y = 0; y <= n; ++y)
      for (GLuint x = 0; x <= n; ++x) {
        const float u = 2.0f * static_cast<float>(x) / static_cast<float>(n) - 1,
                    v = 2.0f * static_cast<float>(y) / static_cast<float>(n) - 1;
        positions.insert(positions.end(), {u, v, 0.2f * std::sin(5 * u) * std::cos(4 * v)});
        normals.insert(normals.end(), {0, 0, 1});
        colors.insert(colors.end(), {0.5f + 0.5f * u, 0.25f, 0.5f, 1});
      }
    for (GLuint y = 0; y < n; ++y)
      for (GLuint x = 0; x < n; ++x) {
        const GLuint a = y * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
        indices.insert(indices.end(), {a, b, d, a, d, c});
      }
  }
  GLsizei count() const { return static_cast<GLsizei>(indices.size()); }
};

void light(const gl::RealGl& gl, float brightness, float x) {
  const GLfloat position[4] = {x, 0, 1, 0}, diffuse[4] = {brightness, brightness, brightness, 1};
  gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0), gl.Enable(GL_COLOR_MATERIAL);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, diffuse);
}

/// One frame: cleared, drawn from a camera that turns with `frame`, read back.
DrawnImage frameImage(TracedContext& context, int frame, const std::function<void()>& draw) {
  const gl::RealGl& gl = context.gl();
  gl.Viewport(0, 0, kRebuiltSize, kRebuiltSize);
  gl.Enable(GL_DEPTH_TEST);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.MatrixMode(GL_PROJECTION), gl.LoadIdentity(), gl.Frustum(-1, 1, -1, 1, 2, 10);
  gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity(), gl.Translatef(0, 0, -4),
      gl.Rotatef(static_cast<float>(frame * 10), 0, 1, 0);
  light(gl, 0.5f + 0.05f * static_cast<float>(frame), 0.1f * static_cast<float>(frame));
  draw();
  gl.Finish();
  return context.read();
}

/// Draws eight frames and returns how many structures were built. Every frame must differ from the one
/// before.
uint64_t buildsOver(TracedContext& context, const std::function<void(int frame)>& draw) {
  const uint64_t before = context.context().counts.statistics.blasBuilds;
  DrawnImage last;
  for (int frame = 0; frame < 8; ++frame) {
    const DrawnImage image = frameImage(context, frame, [&] { draw(frame); });
    EXPECT_FALSE(frame > 0 && image == last) << "frame " << frame << " looks like the one before";
    last = image;
  }
  EXPECT_GT(context.context().counts.statistics.drawsTraced, 0u);
  EXPECT_EQ(context.context().counts.statistics.drawsRasterised, 0u);
  return context.context().counts.statistics.blasBuilds - before;
}

void sendImmediate(const gl::RealGl& gl, const Sheet& sheet, float red) {
  gl.Begin(GL_TRIANGLES);
  for (const GLuint i : sheet.indices) {
    gl.Color3f(red, sheet.colors[4 * i], 0.5f);
    gl.Normal3fv(&sheet.normals[3 * i]);
    gl.Vertex3fv(&sheet.positions[3 * i]);
  }
  gl.End();
}

TEST(Rebuild, ListIsBuiltOnceForAllCamerasAndLights) {
  TracedContext context({kRebuiltSize, kRebuiltSize});
  const Sheet sheet(20);
  context.gl().NewList(1, GL_COMPILE), sendImmediate(context.gl(), sheet, 0.5f), context.gl().EndList();
  EXPECT_EQ(buildsOver(context, [&](int) { context.gl().CallList(1); }), 1u);
}

TEST(Rebuild, ListCompiledAgainWithOtherColoursKeepsItsStructure) {
  TracedContext context({kRebuiltSize, kRebuiltSize});
  const Sheet sheet(21);
  EXPECT_EQ(buildsOver(context,
                       [&](int frame) {
                         const gl::RealGl& gl = context.gl();
                         gl.NewList(1, GL_COMPILE),
                             sendImmediate(gl, sheet, 0.1f * static_cast<float>(frame)), gl.EndList();
                         gl.CallList(1);
                       }),
            1u);
}

TEST(Rebuild, ImmediateModeIsFoundAgainWhateverItsColours) {
  TracedContext context({kRebuiltSize, kRebuiltSize});
  const Sheet sheet(22);
  EXPECT_EQ(
      buildsOver(context,
                 [&](int frame) { sendImmediate(context.gl(), sheet, 0.1f * static_cast<float>(frame)); }),
      1u);
}

TEST(Rebuild, ColourBufferMayChangeEveryFrame) {
  TracedContext context({kRebuiltSize, kRebuiltSize});
  const gl::RealGl& gl = context.gl();
  Sheet sheet(23);
  GLuint buffers[3];
  gl.GenBuffers(3, buffers);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sheet.positions.size() * 4), sheet.positions.data(),
                GL_STATIC_DRAW);
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[2]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(sheet.indices.size() * 4),
                sheet.indices.data(), GL_STATIC_DRAW);
  gl.EnableClientState(GL_VERTEX_ARRAY), gl.EnableClientState(GL_COLOR_ARRAY);
  EXPECT_EQ(buildsOver(context,
                       [&](int frame) {
                         for (size_t i = 0; i < sheet.colors.size(); i += 4)
                           sheet.colors[i] = 0.1f * static_cast<float>(frame);
                         gl.BindBuffer(GL_ARRAY_BUFFER, buffers[1]);
                         gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sheet.colors.size() * 4),
                                       sheet.colors.data(), GL_DYNAMIC_DRAW);
                         gl.ColorPointer(4, GL_FLOAT, 0, nullptr);
                         gl.DrawElements(GL_TRIANGLES, sheet.count(), GL_UNSIGNED_INT, nullptr);
                       }),
            1u);
}

TEST(Rebuild, ClientArraysAreFoundAgain) {
  TracedContext context({kRebuiltSize, kRebuiltSize});
  const gl::RealGl& gl = context.gl();
  Sheet sheet(24);
  gl.EnableClientState(GL_VERTEX_ARRAY), gl.EnableClientState(GL_COLOR_ARRAY);
  EXPECT_EQ(buildsOver(context,
                       [&](int frame) {
                         for (size_t i = 0; i < sheet.colors.size(); i += 4)
                           sheet.colors[i] = 0.1f * static_cast<float>(frame);
                         gl.VertexPointer(3, GL_FLOAT, 0, sheet.positions.data());
                         gl.ColorPointer(4, GL_FLOAT, 0, sheet.colors.data());
                         gl.DrawElements(GL_TRIANGLES, sheet.count(), GL_UNSIGNED_INT, sheet.indices.data());
                       }),
            1u);
}

TEST(Rebuild, MovedVerticesAreBuiltAgain) {
  TracedContext context({kRebuiltSize, kRebuiltSize});
  Sheet sheet(25);
  EXPECT_EQ(buildsOver(context,
                       [&](int frame) {
                         sheet.positions[2] = 0.01f * static_cast<float>(frame + 1);
                         sendImmediate(context.gl(), sheet, 0.5f);
                       }),
            8u);
}

TEST(Rebuild, ManySmallDrawsOfOneStateAreOneMesh) {
  TracedContext context({kRebuiltSize, kRebuiltSize});
  const gl::RealGl& gl = context.gl();
  const Sheet sheet(26);
  buildsOver(context, [&](int) {
    for (size_t t = 0; t < sheet.indices.size(); t += 3) {
      gl.Begin(GL_TRIANGLES);
      for (size_t k = 0; k < 3; ++k) gl.Vertex3fv(&sheet.positions[3 * sheet.indices[t + k]]);
      gl.End();
    }
  });
  EXPECT_EQ(context.context().counts.statistics.drawsTraced, 8u) << "one a frame";
}

TEST(Rebuild, ARepeatedListIsInstances) {
  TracedContext context({kRebuiltSize, kRebuiltSize});
  const gl::RealGl& gl = context.gl();
  const Sheet sheet(27);
  gl.NewList(1, GL_COMPILE), sendImmediate(gl, sheet, 0.5f), gl.EndList();
  EXPECT_EQ(buildsOver(context,
                       [&](int) {
                         for (int i = 0; i < 12; ++i) {
                           gl.PushMatrix();
                           gl.Translatef(0.3f * static_cast<float>(i % 4) - 0.5f,
                                         0.3f * static_cast<float>(i / 4) - 0.5f, 0);
                           gl.Scalef(0.1f, 0.1f, 0.1f);
                           gl.CallList(1);
                           gl.PopMatrix();
                         }
                       }),
            1u);
}

}  // namespace
}  // namespace gluray::test
