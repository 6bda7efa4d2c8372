// Texture coordinate generation: every mode, mixtures, with and without lighting.
#include "scenes/families.h"
#include "scenes/stage.h"
#include "scenes/texels.h"

namespace gluray::scenes {
namespace {

constexpr Tolerance kSmooth{
    2, 0.001, 1e-5f, "edges of triangles, and texels' borders that move with the last bits of coordinates"};

void texGenStage(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Enable(GL_TEXTURE_2D);
  upload(gl, GL_RGB, 16, GL_LINEAR, GL_REPEAT);
}

void generate(Gl gl, GLenum coordinate, GLint mode) {
  gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, mode);
  gl.Enable(GL_TEXTURE_GEN_S + (coordinate - GL_S));
}

void plane(Gl gl, GLenum coordinate, GLenum name, Color value) {
  gl.TexGenfv(coordinate, name, value.data());
}

void objectLinear(Gl gl, int width, int height) {
  texGenStage(gl, width, height);
  keyLight(gl);
  paint(gl, 0.9f, 0.9f, 0.9f);
  generate(gl, GL_S, GL_OBJECT_LINEAR), generate(gl, GL_T, GL_OBJECT_LINEAR);
  plane(gl, GL_S, GL_OBJECT_PLANE, {1.1f, 0.2f, 0, 0.3f});
  plane(gl, GL_T, GL_OBJECT_PLANE, {0, 0.9f, 0.5f, 0});
  gl.Rotatef(-40, 1, 0, 0);
  send(gl, torus(0.9f, 0.4f, 60, 30));
}

/// Planes are given in the eye space of the moment: the camera's, then the object's.
void eyeLinear(Gl gl, int width, int height) {
  texGenStage(gl, width, height);
  generate(gl, GL_S, GL_EYE_LINEAR), generate(gl, GL_T, GL_EYE_LINEAR);
  plane(gl, GL_S, GL_EYE_PLANE, {1, 0, 0, 0.5f});
  gl.Rotatef(50, 1, 2, 0);
  plane(gl, GL_T, GL_EYE_PLANE, {0, 1, 0.4f, 0});
  sendAt(gl, sphere(24, 36), -0.6f, 0, 0, 0.7f);
  gl.Rotatef(70, 0, 1, 1);
  sendAt(gl, torus(0.6f, 0.3f, 40, 24), 0.6f, 0, 0.5f, 0.8f);
}

void sphereMap(Gl gl, int width, int height) {
  texGenStage(gl, width, height);
  generate(gl, GL_S, GL_SPHERE_MAP), generate(gl, GL_T, GL_SPHERE_MAP);
  gl.Enable(GL_NORMALIZE);
  sendAt(gl, sphere(40, 60), -0.9f, 0, 0, 0.75f);
  keyLight(gl);
  paint(gl, 0.9f, 0.8f, 0.6f);
  gl.Disable(GL_NORMALIZE), gl.Enable(GL_RESCALE_NORMAL);
  sendAt(gl, torus(0.9f, 0.4f, 60, 30), 0.9f, 0, 0, 0.6f);
}

/// Directions into a cube map: reflections on the left, normals on the right.
void cubeDirections(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Enable(GL_TEXTURE_CUBE_MAP);
  for (GLenum face = 0; face < 6; ++face) {
    auto texels = pattern(16);
    for (size_t i = 2; i < texels.size(); i += 4) texels[i] = static_cast<uint8_t>(40 * face + texels[i] / 6);
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGB, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  texels.data());
  }
  sampling(gl, GL_TEXTURE_CUBE_MAP, GL_LINEAR, GL_CLAMP_TO_EDGE);
  gl.Enable(GL_NORMALIZE);
  for (const GLenum coordinate : {GL_S, GL_T, GL_R}) generate(gl, coordinate, GL_REFLECTION_MAP);
  sendAt(gl, sphere(40, 60), -0.9f, 0, 0, 0.75f);
  for (const GLenum coordinate : {GL_S, GL_T, GL_R}) generate(gl, coordinate, GL_NORMAL_MAP);
  sendAt(gl, torus(0.9f, 0.4f, 60, 30), 0.9f, 0, 0, 0.6f);
}

/// One coordinate generated, the other from the vertices; a projected light through q; the second unit alone.
void mixed(Gl gl, int width, int height) {
  texGenStage(gl, width, height);
  generate(gl, GL_S, GL_OBJECT_LINEAR);
  plane(gl, GL_S, GL_OBJECT_PLANE, {0, 0, 1.5f, 0});
  sendAt(gl, sphere(24, 36), -1, 0, 0, 0.6f, kNormals | kTexcoords);
  const Color planes[] = {{0.5f, 0, -0.5f, 2}, {0, 0.5f, -0.5f, 2}, {0, 0, 1, 0}, {0, 0, -1, 4}};
  for (GLenum i = 0; i < 4; ++i) {
    generate(gl, GL_S + i, GL_EYE_LINEAR);
    plane(gl, GL_S + i, GL_EYE_PLANE, planes[i]);
  }
  sendAt(gl, torus(0.7f, 0.3f, 40, 24), 0, 0.3f, 0, 0.7f);
  gl.ActiveTexture(GL_TEXTURE1);
  bindFresh(gl, GL_TEXTURE_2D);
  upload(gl, GL_LUMINANCE, 8, GL_NEAREST, GL_REPEAT);
  gl.Enable(GL_TEXTURE_2D);
  generate(gl, GL_S, GL_SPHERE_MAP), generate(gl, GL_T, GL_SPHERE_MAP);
  gl.Enable(GL_NORMALIZE);
  sendAt(gl, sphere(24, 36), 1, 0, 0, 0.6f);
}

constexpr Scene kTexGenScenes[] = {
    {"texgen-object-linear", objectLinear, true, kSmooth},
    {"texgen-eye-linear", eyeLinear, true, kSmooth},
    {"texgen-sphere-map", sphereMap, true, kSmooth},
    {"texgen-cube-directions", cubeDirections, true, kSmooth},
    {"texgen-mixed", mixed, true, kSmooth},
};

}  // namespace

std::span<const Scene> texGenScenes() { return kTexGenScenes; }

}  // namespace gluray::scenes
