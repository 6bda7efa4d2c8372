// The same surface drawn again, blended: later passes must meet exactly the depth that the first one left.
#include "scenes/families.h"
#include "scenes/stage.h"

namespace gluray::scenes {
namespace {

void base(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.3f, 0.4f, 0.6f);
}

/// A glow added where the depth is equal.
void equalPass(Gl gl, int width, int height) {
  base(gl, width, height);
  const Model m = torus(0.8f, 0.35f, 50, 24);
  send(gl, m);
  gl.DepthFunc(GL_EQUAL);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  gl.Disable(GL_LIGHTING);
  gl.Color3f(0.4f, 0.2f, 0);
  send(gl, m, 0);
  gl.DepthFunc(GL_LESS);
}

/// A selection's colour laid over half of a model from a list, with GL_LEQUAL and without depth writes.
void tintedPart(Gl gl, int width, int height) {
  base(gl, width, height);
  const Model m = sphere(24, 36);
  Model part = m;
  part.indices.resize(m.indices.size() / 6 * 3);
  const GLuint lists = gl.GenLists(2);
  gl.NewList(lists, GL_COMPILE), send(gl, m), gl.EndList();
  gl.NewList(lists + 1, GL_COMPILE), send(gl, part), gl.EndList();
  gl.CallList(lists);
  gl.DepthFunc(GL_LEQUAL), gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  material(gl, GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, {1, 0.8f, 0, 0.5f});
  gl.CallList(lists + 1);
  gl.DeleteLists(lists, 2);
}

/// A base in black, a pass for each of two lights, a pass of texture: the lighting of many games.
void lightPasses(Gl gl, int width, int height) {
  base(gl, width, height);
  const Model m = vase(40, 30);
  gl.VertexPointer(3, GL_FLOAT, 0, m.positions.data()), gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.NormalPointer(GL_FLOAT, 0, m.normals.data()), gl.EnableClientState(GL_NORMAL_ARRAY);
  const auto draw = [&] {
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(m.indices.size()), GL_UNSIGNED_INT, m.indices.data());
  };
  gl.Disable(GL_LIGHT0);
  draw();
  gl.DepthFunc(GL_LEQUAL);
  gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE);
  for (const GLenum name : {GL_LIGHT1, GL_LIGHT2}) {
    light(gl, name, GL_POSITION, {name == GL_LIGHT1 ? 1.0f : -1.0f, 0.5f, 0.8f, 0});
    light(gl, name, GL_DIFFUSE, {0.6f, name == GL_LIGHT1 ? 0.2f : 0.6f, 0.3f, 1});
    gl.Enable(name);
    draw();
    gl.Disable(name);
  }
}

/// Depth alone first, then colours where GL_LEQUAL finds it; by glBegin, from a list, from arrays.
void depthFirst(Gl gl, int width, int height) {
  base(gl, width, height);
  gl.DepthFunc(GL_LEQUAL);
  const Model models[] = {torus(0.5f, 0.2f, 30, 16), sphere(16, 24), vase(24, 16)};
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE), send(gl, models[1]), gl.EndList();
  gl.VertexPointer(3, GL_FLOAT, 0, models[2].positions.data()), gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.NormalPointer(GL_FLOAT, 0, models[2].normals.data()), gl.EnableClientState(GL_NORMAL_ARRAY);
  for (const GLboolean colors : {GL_FALSE, GL_TRUE}) {
    gl.ColorMask(colors, colors, colors, colors);
    for (int i = 0; i < 3; ++i) {
      gl.PushMatrix();
      gl.Translatef(-1 + static_cast<float>(i), 0, 0.3f * static_cast<float>(i)), gl.Scalef(0.6f, 0.6f, 0.6f);
      if (i == 0)
        send(gl, models[0]);
      else if (i == 1)
        gl.CallList(list);
      else
        gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(models[2].indices.size()), GL_UNSIGNED_INT,
                        models[2].indices.data());
      gl.PopMatrix();
    }
  }
  gl.DeleteLists(list, 1);
}

constexpr Scene kPassScenes[] = {
    {"equal-pass", equalPass, false},
    {"tinted-part", tintedPart, false},
    {"light-passes", lightPasses, false},
    {"depth-first", depthFirst, false},
};

}  // namespace

std::span<const Scene> passScenes() { return kPassScenes; }

}  // namespace gluray::scenes
