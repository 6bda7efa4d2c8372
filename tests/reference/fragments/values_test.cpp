// Values at the edges of single precision: vertices far from their origin; normals, colours and texture
// coordinates that are infinite or no numbers; normals of integers.
#include "tests/reference/both.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace gluray::test {
namespace {

constexpr scenes::Tolerance kToTheBit{0, 0, 0, "the real OpenGL draws both"};

void prepareValues(scenes::Gl gl) {
  gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0), gl.Enable(GL_COLOR_MATERIAL);
  gl.ClearColor(0.2f, 0.3f, 0.4f, 1), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.MatrixMode(GL_PROJECTION), gl.LoadIdentity(), gl.Ortho(-1.2, 1.2, -1.2, 1.2, -10, 10);
  gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity();
}

/// A wavy sheet over [-1, 1]^2, of arrays.
struct Sheet {
  static constexpr int kSide = 17;
  std::vector<float> positions, normals, colors, texcoords;
  std::vector<GLuint> indices;

  Sheet() {
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const float u = 2.0f * static_cast<float>(x) / (kSide - 1) - 1,
                    v = 2.0f * static_cast<float>(y) / (kSide - 1) - 1;
        positions.insert(positions.end(), {u, v, 0.2f * std::sin(5 * u) * std::cos(4 * v)});
        const float nx = -std::cos(5 * u) * std::cos(4 * v), ny = 0.8f * std::sin(5 * u) * std::sin(4 * v);
        const float length = std::sqrt(nx * nx + ny * ny + 1);
        normals.insert(normals.end(), {nx / length, ny / length, 1 / length});
        colors.insert(colors.end(), {0.7f, 0.6f, 0.9f});
        texcoords.insert(texcoords.end(), {u, v});
      }
    for (int y = 0; y + 1 < kSide; ++y)
      for (int x = 0; x + 1 < kSide; ++x) {
        const auto a = static_cast<GLuint>(y * kSide + x), b = a + kSide;
        indices.insert(indices.end(), {a, a + 1, b + 1, a, b + 1, b});
      }
  }

  void draw(scenes::Gl gl) const {
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY})
      gl.EnableClientState(array);
    gl.VertexPointer(3, GL_FLOAT, 0, positions.data()), gl.NormalPointer(GL_FLOAT, 0, normals.data());
    gl.ColorPointer(3, GL_FLOAT, 0, colors.data()), gl.TexCoordPointer(2, GL_FLOAT, 0, texcoords.data());
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, indices.data());
  }
};

const BothStage kValuesStage{120, 120, "values", prepareValues, kToTheBit};

uint64_t refusedBecause(const gl::Statistics& counts, gl::Reason reason) {
  return counts.rasterisedBecause[static_cast<size_t>(reason)];
}

TEST(OddValues, ThatAreNotFiniteAreDrawnByTheRealOpenGL) {
  constexpr float kBad[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(), 1e30f};
  for (const float bad : kBad)
    for (auto array : {&Sheet::normals, &Sheet::colors, &Sheet::texcoords}) {
      Sheet sheet;
      auto& values = sheet.*array;
      values[values.size() / 2] = bad;
      const gl::Statistics counts =
          compareBoth(kValuesStage, "bad value", [&](scenes::Gl gl) { sheet.draw(gl); });
      EXPECT_EQ(refusedBecause(counts, gl::Reason::notFinite), 1u) << bad;
    }
}

TEST(OddValues, ThatAreLargeButFiniteAreTraced) {
  Sheet sheet;
  for (float& n : sheet.normals) n *= 1e6f;
  BothStage stage = kValuesStage;
  stage.tolerance = {2, 0.002, 1e-6f, "edges fall on either side of a pixel's centre"};
  const gl::Statistics counts = compareBoth(stage, "long normals", [&](scenes::Gl gl) {
    gl.Enable(GL_NORMALIZE);
    sheet.draw(gl);
  });
  EXPECT_EQ(counts.drawsTraced, 1u);
}

/// They get no light of light sources, as in the real OpenGL; with lighting at pixels light fades towards
/// them.
TEST(OddValues, NormalsOfLengthZeroUnderNormalizeAreTraced) {
  for (const bool twoSided : {false, true})
    for (const Settings& settings : {TracedContext::vertexShading(), TracedContext::tracing()}) {
      Sheet sheet;
      for (size_t i = 0; i < sheet.normals.size(); ++i) {
        const bool zero = i < sheet.normals.size() / 2;
        sheet.normals[i] = i % 3 == 2 && !zero ? 1.0f : 0.0f;
      }
      BothStage stage = kValuesStage;
      stage.settings = settings;
      stage.tolerance = {2, 0.002, 1e-6f, "edges fall on either side of a pixel's centre"};
      const gl::Statistics counts = compareBoth(stage, "zero normals", [&](scenes::Gl gl) {
        const GLfloat dim[4] = {0.5f, 0.5f, 0.5f, 1};  // no colour is clamped
        gl.Enable(GL_NORMALIZE), gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, twoSided);
        gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, dim);
        sheet.draw(gl);
      });
      EXPECT_EQ(counts.drawsTraced, 1u);
    }
}

TEST(OddValues, ShortNormalsUnderNormalizeAreTracedWhileTheirSquaresAreNot0) {
  const auto countsOf = [](float length, double scale) {
    Sheet sheet;
    for (float& n : sheet.normals) n *= length;
    for (float& p : sheet.positions) p *= static_cast<float>(scale);
    BothStage stage = kValuesStage;
    stage.tolerance = {2, 0.002, 1e-6f, "edges fall on either side of a pixel's centre"};
    return compareBoth(stage, "short normals", [&](scenes::Gl gl) {
      gl.Enable(GL_NORMALIZE), gl.Scaled(1 / scale, 1 / scale, 1 / scale);
      sheet.draw(gl);
    });
  };
  EXPECT_EQ(countsOf(1e-16f, 1).drawsTraced, 1u);
  EXPECT_EQ(countsOf(1e-18f, 1).drawsTraced, 1u);
  EXPECT_EQ(countsOf(1e-16f, 1e-4).drawsTraced, 0u);  // the matrix makes them shorter
  EXPECT_EQ(countsOf(1e-18f, 1e4).drawsTraced, 1u);
}

/// A triangle of two units, which the matrix brings back.
void drawFar(scenes::Gl gl, double far) {
  gl.Disable(GL_LIGHTING);
  gl.Translated(-far, -far, -4);
  gl.Begin(GL_TRIANGLES);
  gl.Color3f(1, 0, 0), gl.Vertex3d(far - 1, far - 1, 0);
  gl.Color3f(0, 1, 0), gl.Vertex3d(far + 1, far - 0.75, 0.5);
  gl.Color3f(0, 0, 1), gl.Vertex3d(far + 0.25, far + 1, 1);
  gl.End();
}

TEST(OddValues, RoundingsOfFarVerticesAreThoseOfTheRealOpenGL) {
  for (const double far : {1e5, 1e6, 4e6, 1e7}) {
    const gl::Statistics counts = compareBoth(kValuesStage, "far", [&](scenes::Gl gl) { drawFar(gl, far); });
    EXPECT_EQ(refusedBecause(counts, gl::Reason::farFromOrigin), 1u) << far;
  }
  BothStage stage = kValuesStage;
  stage.tolerance = {2, 0.002, 1e-6f, "edges fall on either side of a pixel's centre"};
  const gl::Statistics counts = compareBoth(stage, "near", [&](scenes::Gl gl) { drawFar(gl, 100); });
  EXPECT_EQ(counts.drawsTraced, 1u);
}

/// Strong highlights at normals of integers, where half a step shows.
template <class T>
void drawIntegerNormals(scenes::Gl gl, GLenum type, bool byCommands, bool inList) {
  constexpr float kOne[] = {1, 1, 1, 1}, kFrom[] = {0.65f, 0.65f, 1, 0};
  gl.Lightfv(GL_LIGHT0, GL_POSITION, kFrom);
  gl.Materialfv(GL_FRONT, GL_SPECULAR, kOne), gl.Materialf(GL_FRONT, GL_SHININESS, 100);
  gl.Rotatef(40, 0.3f, 1, 0.2f);
  static const Sheet sheet;  // both contexts get the same pointers
  static const std::vector<T> normals = [] {
    std::vector<T> all;
    for (const float n : sheet.normals)
      all.push_back(static_cast<T>(n * static_cast<float>(std::numeric_limits<T>::max())));
    return all;
  }();
  if (!byCommands) {
    gl.EnableClientState(GL_VERTEX_ARRAY), gl.EnableClientState(GL_NORMAL_ARRAY);
    gl.VertexPointer(3, GL_FLOAT, 0, sheet.positions.data()), gl.NormalPointer(type, 0, normals.data());
    if (inList) gl.NewList(1, GL_COMPILE);
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(sheet.indices.size()), GL_UNSIGNED_INT,
                    sheet.indices.data());
    if (inList) gl.EndList(), gl.CallList(1);
    return;
  }
  gl.Begin(GL_TRIANGLES);
  for (const GLuint i : sheet.indices) {
    if constexpr (sizeof(T) == 1)
      gl.Normal3bv(reinterpret_cast<const GLbyte*>(&normals[3 * size_t{i}]));
    else
      gl.Normal3sv(reinterpret_cast<const GLshort*>(&normals[3 * size_t{i}]));
    gl.Vertex3fv(&sheet.positions[3 * size_t{i}]);
  }
  gl.End();
  gl.Normal3f(0, 0, 1);
}

TEST(OddValues, IntegerNormalsAreConvertedAsTheRealOpenGLConvertsThem) {
  BothStage stage = kValuesStage;
  stage.tolerance = {2, 0.002, 1e-6f, "edges fall on either side of a pixel's centre"};
  for (const char* how : {"arrays", "commands", "list"}) {
    SCOPED_TRACE(how);
    const bool byCommands = *how == 'c', inList = *how == 'l';
    for (int form = 0; form < 2; ++form) {
      const gl::Statistics counts = compareBoth(stage, form ? "shorts" : "bytes", [&](scenes::Gl gl) {
        form ? drawIntegerNormals<int16_t>(gl, GL_SHORT, byCommands, inList)
             : drawIntegerNormals<int8_t>(gl, GL_BYTE, byCommands, inList);
      });
      EXPECT_EQ(counts.drawsTraced, 1u);
    }
  }
}

}  // namespace
}  // namespace gluray::test
