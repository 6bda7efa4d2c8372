// Every primitive that has an area, smooth and flat, lit and unlit.
#include "scenes/families.h"
#include "scenes/stage.h"

#include <cmath>

namespace gluray::scenes {
namespace {

/// Vertex `i` of a ring of `n`, coloured by its place, with a normal that leans outwards.
void ringVertex(Gl gl, int i, int n, float x, float y, float radius, float depth) {
  const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(n);
  gl.Color3f(0.5f + 0.5f * std::cos(angle), 0.5f + 0.5f * std::sin(angle * 2),
             static_cast<float>(i % 3) * 0.5f);
  gl.Normal3f(0.4f * std::cos(angle), 0.4f * std::sin(angle), 0.9f);
  gl.Vertex3f(x + radius * std::cos(angle), y + radius * std::sin(angle), depth);
}

/// The seven primitives with an area, side by side; strips and fans of several cells.
void allPrimitives(Gl gl) {
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 6; ++i) ringVertex(gl, i, 6, -1.0f, 0.5f, 0.4f, 0.1f * static_cast<float>(i % 2));
  gl.End();
  // OpenGL leaves open where a quad is cut in two (Mesa cuts some one way, some the other), so no quad here
  // depends on it: four corners in a plane, with colours to match.
  for (int quad = 0; quad < 2; ++quad) {
    const float x = quad ? 0.15f : -0.15f, y = quad ? 0.4f : 0.6f, z = quad ? 0 : 0.2f;
    const float corners[4][2] = {{-1, -0.5f}, {0.5f, -1}, {1, 0.5f}, {-0.5f, 1}};
    gl.Begin(GL_QUADS);
    for (const auto& c : corners) {
      gl.Color3f(0.5f + 0.4f * c[0], 0.5f + 0.4f * c[1], 0.3f);
      gl.Normal3f(0.3f * c[0], 0.3f * c[1], 0.9f);
      gl.Vertex3f(x + 0.3f * c[0], y + 0.3f * c[1], z + 0.1f * c[0]);
    }
    gl.End();
  }
  gl.Begin(GL_POLYGON);
  for (int i = 0; i < 7; ++i) ringVertex(gl, i, 7, 0.9f, 0.5f, 0.4f, 0);
  gl.End();
  gl.Begin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 9; ++i) {
    gl.Color3f(static_cast<float>(i % 2), static_cast<float>(i) / 8.0f, 0.5f);
    gl.Normal3f(0.1f * static_cast<float>(i - 4), 0, 1);
    gl.Vertex3f(-1.3f + 0.1f * static_cast<float>(i), i % 2 ? -0.2f : -0.8f, 0);
  }
  gl.End();
  gl.Begin(GL_TRIANGLE_FAN);
  gl.Color3f(1, 1, 1), gl.Normal3f(0, 0, 1), gl.Vertex3f(0, -0.5f, 0.2f);
  for (int i = 0; i <= 8; ++i) ringVertex(gl, i, 8, 0, -0.5f, 0.4f, 0);
  gl.End();
  gl.Begin(GL_QUAD_STRIP);
  for (int i = 0; i < 10; ++i) {
    gl.Color3f(0.2f, static_cast<float>(i) / 9.0f, static_cast<float>(i % 2));
    gl.Normal3f(0, 0.2f * static_cast<float>(i % 3), 1);
    gl.Vertex3f(0.5f + 0.2f * static_cast<float>(i / 2), i % 2 ? -0.2f : -0.8f,
                0.05f * static_cast<float>(i));
  }
  gl.End();
}

void primitives(Gl gl, int width, int height) {
  begin(gl, width, height);
  flatCamera(gl, width, height);
  allPrimitives(gl);
}

void primitivesFlat(Gl gl, int width, int height) {
  gl.ShadeModel(GL_FLAT);
  primitives(gl, width, height);
}

void litPrimitives(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height, 3.5f);
  keyLight(gl);
  paint(gl, 0.8f, 0.5f, 0.3f);
  allPrimitives(gl);
}

void litPrimitivesFlat(Gl gl, int width, int height) {
  gl.ShadeModel(GL_FLAT);
  litPrimitives(gl, width, height);
}

void coarseSphereFlat(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.4f, 0.7f, 0.9f);
  gl.ShadeModel(GL_FLAT);
  send(gl, sphere(8, 12));
}

/// Degenerate and odd input: too few vertices, zero area, repeated points, empty pairs.
void oddPrimitives(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  for (GLenum mode :
       {GL_TRIANGLES, GL_QUADS, GL_POLYGON, GL_TRIANGLE_STRIP, GL_QUAD_STRIP, GL_TRIANGLE_FAN}) {
    gl.Begin(mode);
    gl.End();
    gl.Begin(mode);
    gl.Vertex2f(0, 0), gl.Vertex2f(1, 0);
    gl.End();
  }
  gl.Color3f(1, 0.5f, 0);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3; ++i) gl.Vertex2f(0.3f, 0.3f);                        // a point
  gl.Vertex2f(-1, 0.9f), gl.Vertex2f(0, 0.9f), gl.Vertex2f(1, 0.9f);          // a line
  gl.Vertex2f(-0.5f, -0.5f), gl.Vertex2f(0.5f, -0.5f), gl.Vertex2f(0, 0.5f);  // the only one with an area
  gl.Vertex2f(0.8f, 0.8f), gl.Vertex2f(0.9f, 0.8f);                           // left over
  gl.End();
  gl.Begin(GL_QUAD_STRIP);
  for (int i = 0; i < 5; ++i)
    gl.Vertex2f(0.6f + 0.1f * static_cast<float>(i / 2), i % 2 ? -0.2f : -0.6f);  // odd
  gl.End();
}

/// A vertex at a time, as old viewers send them: one glBegin for each face.
void oneBeginPerFace(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.6f, 0.8f, 0.3f);
  const Model m = torus(0.8f, 0.35f, 40, 20);
  for (size_t i = 0; i < m.indices.size(); i += 3) {
    gl.Begin(GL_POLYGON);
    for (size_t k = 0; k < 3; ++k) {
      gl.Normal3fv(&m.normals[m.indices[i + k] * 3]);
      gl.Vertex3fv(&m.positions[m.indices[i + k] * 3]);
    }
    gl.End();
  }
}

/// The attribute forms: double, integer, short, byte; two, three and four coordinates; current values carried
/// over.
void attributeForms(Gl gl, int width, int height) {
  begin(gl, width, height);
  flatCamera(gl, width, height);
  gl.Begin(GL_TRIANGLES);
  gl.Color3d(1, 0, 0), gl.Vertex2d(-1.2, -0.5);
  gl.Color3ub(0, 255, 0), gl.Vertex2i(0, -1);
  gl.Color3us(0, 0, 65535), gl.Vertex2s(0, 1);
  gl.Color4b(127, 127, 0, 127), gl.Vertex3i(0, 0, 1);
  gl.Color4ui(0xffffffff, 0x80000000, 0, 0xffffffff), gl.Vertex3s(1, 0, 0);
  gl.Vertex3d(1, 1, -1);  // the colour before
  gl.Color3i(0x7fffffff, 0, 0x7fffffff), gl.Vertex4f(0.2f, -0.2f, 0, 1);
  const GLdouble corner[] = {2.4, -1.6, 0.4, 2};
  gl.Vertex4d(1.2, -0.2, 0.1, 1);
  gl.Color3f(0.2f, 0.9f, 0.9f), gl.Vertex3d(corner[0] / 2, corner[1] / 2, corner[2] / 2);
  gl.End();
}

constexpr Tolerance kEdgesOnCentres{2, 0.004, 1e-5f,
                                    "edges run through the centres of whole rows and columns of pixels"};

constexpr Scene kPrimitiveScenes[] = {
    {"primitives", primitives, true, kEdgesOnCentres},
    {"primitives-flat", primitivesFlat, true, kEdgesOnCentres},
    {"lit-primitives", litPrimitives},
    {"lit-primitives-flat", litPrimitivesFlat},
    {"coarse-sphere-flat", coarseSphereFlat},
    {"odd-primitives", oddPrimitives},
    {"one-begin-per-face", oneBeginPerFace},
    {"attribute-forms", attributeForms},
};

}  // namespace

std::span<const Scene> primitiveScenes() { return kPrimitiveScenes; }

}  // namespace gluray::scenes
