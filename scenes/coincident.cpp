// Triangles exactly upon others, drawn before: the depth function and the order of drawing decide.
#include "scenes/families.h"
#include "scenes/stage.h"

#include <algorithm>

namespace gluray::scenes {
namespace {

/// Every `step`-th run of `length` triangles of the model, some of them turned over.
Model partOf(const Model& model, size_t step, size_t length, bool turned) {
  Model part = model;
  part.indices.clear();
  for (size_t t = 0; t < model.indices.size() / 3; ++t) {
    if (t / length % step != 0) continue;
    uint32_t corners[3] = {model.indices[3 * t], model.indices[3 * t + 1], model.indices[3 * t + 2]};
    if (turned) std::swap(corners[0], corners[1]);
    part.indices.insert(part.indices.end(), corners, corners + 3);
  }
  return part;
}

/// A part drawn again in another colour, as programs show what is selected.
void highlightedPart(Gl gl, int width, int height, GLenum depthFunc) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  gl.DepthFunc(depthFunc);
  const Model whole = sphere(24, 36);
  paint(gl, 0.4f, 0.6f, 0.9f);
  send(gl, whole);
  paint(gl, 1.0f, 0.5f, 0.1f);
  send(gl, partOf(whole, 3, 40, false));
  paint(gl, 0.2f, 0.9f, 0.2f);
  send(gl, partOf(whole, 7, 24, false));
}

void highlightedPartLess(Gl gl, int width, int height) { highlightedPart(gl, width, height, GL_LESS); }
void highlightedPartLequal(Gl gl, int width, int height) { highlightedPart(gl, width, height, GL_LEQUAL); }

/// Each face twice in one glBegin, once each way round: exporters write such skins.
void doubleSkin(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  const Model shape = vase(40, 30), inside = partOf(shape, 1, 1, true);
  gl.Begin(GL_TRIANGLES);
  for (size_t t = 0; t < shape.indices.size() / 3; ++t)
    for (const Model* model : {&shape, &inside}) {
      const float turn = model == &shape ? 1.0f : -1.0f;
      for (size_t k = 0; k < 3; ++k) {
        const uint32_t i = model->indices[3 * t + k];
        gl.Normal3f(turn * model->normals[3 * i], turn * model->normals[3 * i + 1],
                    turn * model->normals[3 * i + 2]);
        gl.Vertex3fv(&model->positions[3 * i]);
      }
    }
  gl.End();
}

/// The same triangles in one list, in three colours, the last of which counts.
void recolouredInOneList(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.DepthFunc(GL_LEQUAL);
  const Model shape = torus(0.8f, 0.35f, 40, 20);
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  gl.Color3f(0.9f, 0.9f, 0.2f);
  send(gl, shape, 0);
  gl.Color3f(0.2f, 0.3f, 0.8f);
  send(gl, partOf(shape, 2, 40, false), 0);
  gl.Color3f(0.8f, 0.1f, 0.3f);
  send(gl, partOf(shape, 5, 16, false), 0);
  gl.EndList();
  gl.CallList(list);
  gl.DeleteLists(list, 1);
}

constexpr Scene kCoincidentScenes[] = {
    {"highlighted-part-less", highlightedPartLess},
    {"highlighted-part-lequal", highlightedPartLequal},
    {"double-skin", doubleSkin},
    {"recoloured-in-one-list", recolouredInOneList},
};

}  // namespace

std::span<const Scene> coincidentScenes() { return kCoincidentScenes; }

}  // namespace gluray::scenes
