// Display lists: nested, based, with state inside, executed while compiled, called many times.
#include "scenes/families.h"
#include "scenes/stage.h"

namespace gluray::scenes {
namespace {

GLuint compile(Gl gl, const Model& model, GLenum mode = GL_COMPILE) {
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, mode);
  send(gl, model);
  gl.EndList();
  return list;
}

void listStage(Gl gl, int width, int height, float distance = 5) {
  begin(gl, width, height);
  camera(gl, width, height, distance);
  keyLight(gl);
  gl.Enable(GL_NORMALIZE);
}

/// A list that moves, paints and calls another one.
void nestedLists(Gl gl, int width, int height) {
  listStage(gl, width, height);
  const GLuint ball = compile(gl, sphere(16, 24));
  const GLuint row = gl.GenLists(1);
  gl.NewList(row, GL_COMPILE);
  for (int i = 0; i < 5; ++i) {
    gl.PushMatrix();
    gl.Translatef(-1.6f + 0.8f * static_cast<float>(i), 0, 0);
    gl.Scalef(0.35f, 0.35f, 0.35f);
    paint(gl, 0.2f * static_cast<float>(i), 0.6f, 1 - 0.2f * static_cast<float>(i));
    gl.CallList(ball);
    gl.PopMatrix();
  }
  gl.EndList();
  for (int i = 0; i < 3; ++i) {
    gl.PushMatrix();
    gl.Translatef(0, -0.9f + 0.9f * static_cast<float>(i), 0);
    gl.CallList(row);
    gl.PopMatrix();
  }
}

void callListsWithBase(Gl gl, int width, int height) {
  listStage(gl, width, height);
  const GLuint base = gl.GenLists(3);
  const Model models[] = {sphere(12, 16), torus(0.7f, 0.3f, 24, 12), vase(20, 14)};
  for (GLuint i = 0; i < 3; ++i) {
    gl.NewList(base + i, GL_COMPILE);
    paint(gl, i == 0, i == 1, i == 2);
    send(gl, models[i]);
    gl.Translatef(2, 0, 0);
    gl.EndList();
  }
  gl.Scalef(0.5f, 0.5f, 0.5f);
  gl.Translatef(-3, 1, 0);
  gl.ListBase(base);
  const GLubyte text[] = {2, 0, 1, 1, 7};  // 7: no such list
  gl.CallLists(5, GL_UNSIGNED_BYTE, text);
  gl.Translatef(-8, -2.2f, 0);
  gl.ListBase(base - 1);
  const GLint numbers[] = {1, 2, 3};
  gl.CallLists(3, GL_INT, numbers);
}

/// Some programs draw no other way.
void compileAndExecute(Gl gl, int width, int height) {
  listStage(gl, width, height);
  paint(gl, 0.9f, 0.7f, 0.3f);
  gl.Translatef(-0.9f, 0, 0);
  const GLuint list = compile(gl, torus(0.6f, 0.25f, 40, 20), GL_COMPILE_AND_EXECUTE);
  gl.Translatef(1.8f, 0, 0);
  gl.Rotatef(60, 1, 0, 0);
  gl.CallList(list);
}

/// One list, four hundred times, from the same two calls.
void manyInstances(Gl gl, int width, int height) {
  listStage(gl, width, height, 6);
  const GLuint ball = compile(gl, sphere(8, 12));
  for (int i = 0; i < 400; ++i) {
    const int x = i % 20, y = i / 20;
    gl.PushMatrix();
    gl.Translatef(-2 + 0.21f * static_cast<float>(x), -1.5f + 0.16f * static_cast<float>(y),
                  0.2f * static_cast<float>((x * y) % 5));
    gl.Scalef(0.08f, 0.08f, 0.08f);
    if (i % 7 == 0) paint(gl, 0.05f * static_cast<float>(x), 0.05f * static_cast<float>(y), 0.6f);
    gl.CallList(ball);
    gl.PopMatrix();
  }
}

void listInsidePushAttrib(Gl gl, int width, int height) {
  listStage(gl, width, height);
  const GLuint ring = compile(gl, torus(0.6f, 0.25f, 30, 16));
  const GLuint state = gl.GenLists(1);
  gl.NewList(state, GL_COMPILE);
  gl.Disable(GL_LIGHTING);
  gl.Color3f(1, 0.5f, 0);
  gl.ShadeModel(GL_FLAT);
  gl.EndList();
  paint(gl, 0.3f, 0.8f, 0.8f);
  gl.PushAttrib(GL_LIGHTING_BIT | GL_ENABLE_BIT | GL_CURRENT_BIT | GL_TRANSFORM_BIT);
  gl.CallList(state);
  gl.PushMatrix();
  gl.Translatef(-1, 0, 0);
  gl.CallList(ring);
  gl.PopMatrix();
  gl.PopAttrib();
  gl.Translatef(1, 0, 0);
  gl.CallList(ring);
}

/// A list compiled again under the same name, one deleted and made anew, one that is part of a glBegin.
void changedLists(Gl gl, int width, int height) {
  listStage(gl, width, height);
  paint(gl, 0.7f, 0.7f, 0.2f);
  const GLuint list = compile(gl, sphere(10, 14));
  gl.PushMatrix();
  gl.Translatef(-1.5f, 0, 0), gl.Scalef(0.5f, 0.5f, 0.5f), gl.CallList(list);
  gl.PopMatrix();
  gl.NewList(list, GL_COMPILE);
  send(gl, torus(0.7f, 0.3f, 20, 12));
  gl.EndList();
  gl.PushMatrix();
  gl.Scalef(0.5f, 0.5f, 0.5f), gl.CallList(list);
  gl.PopMatrix();
  gl.DeleteLists(list, 1);
  gl.CallList(list);  // nothing
  const GLuint half = gl.GenLists(1);
  gl.NewList(half, GL_COMPILE);
  gl.Vertex3f(1, -0.5f, 0);
  gl.Color3f(0, 1, 0);
  gl.Vertex3f(2, -0.5f, 0);
  gl.EndList();
  gl.Disable(GL_LIGHTING);
  gl.Begin(GL_TRIANGLES);
  gl.Color3f(1, 0, 0);
  gl.CallList(half);
  gl.Vertex3f(1.5f, 0.5f, 0);
  gl.End();
}

/// Lines and filled surfaces in one list: part of it is traced, part is not, in order.
void mixedList(Gl gl, int width, int height) {
  listStage(gl, width, height);
  const Model m = vase(24, 16);
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  paint(gl, 0.8f, 0.5f, 0.5f);
  send(gl, m);
  gl.Disable(GL_LIGHTING);
  gl.Color3f(1, 1, 1);
  gl.Begin(GL_LINES);
  for (int i = 0; i < 20; ++i)
    gl.Vertex3f(-1.5f, -0.9f + 0.09f * static_cast<float>(i), 0),
        gl.Vertex3f(1.5f, 0.9f - 0.09f * static_cast<float>(i), 0.3f);
  gl.End();
  gl.Enable(GL_LIGHTING);
  gl.Translatef(1.2f, 0, 0);
  paint(gl, 0.4f, 0.9f, 0.5f);
  send(gl, m);
  gl.EndList();
  gl.Translatef(-0.6f, 0, 0);
  gl.CallList(list);
}

constexpr Scene kListScenes[] = {
    {"nested-lists", nestedLists},
    {"call-lists-base", callListsWithBase},
    {"compile-and-execute", compileAndExecute},
    {"many-instances", manyInstances},
    {"list-inside-push-attrib", listInsidePushAttrib},
    {"changed-lists", changedLists},
    {"mixed-list", mixedList},
};

}  // namespace

std::span<const Scene> listScenes() { return kListScenes; }

}  // namespace gluray::scenes
