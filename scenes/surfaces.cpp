// What cuts and moves surfaces: culling, clip planes, polygon offset, depth range, depth function.
#include "scenes/families.h"
#include "scenes/stage.h"

namespace gluray::scenes {
namespace {

void culling(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height, 6);
  keyLight(gl);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  paint(gl, 0.8f, 0.7f, 0.2f);
  material(gl, GL_BACK, GL_DIFFUSE, {0.1f, 0.3f, 0.9f, 1});
  gl.Enable(GL_NORMALIZE);
  const Model open = vase(30, 20);
  gl.Rotatef(30, 1, 0, 0);
  for (int i = 0; i < 4; ++i) {
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(i & 1 ? GL_FRONT : GL_BACK);
    gl.FrontFace(i & 2 ? GL_CW : GL_CCW);
    sendAt(gl, open, -1.9f + 1.25f * static_cast<float>(i), 0, 0, 0.7f);
  }
  gl.CullFace(GL_FRONT_AND_BACK);
  sendAt(gl, open, 0, 1, 0, 0.7f);  // nothing
}

/// A mirroring modelview matrix turns the winding round.
void mirrored(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.7f, 0.7f, 0.7f);
  gl.Enable(GL_CULL_FACE);
  const Model ring = torus(0.5f, 0.2f, 30, 16);
  gl.PushMatrix();
  gl.Translatef(-0.9f, 0, 0), gl.Rotatef(40, 1, 1, 0);
  send(gl, ring);
  gl.PopMatrix();
  gl.PushMatrix();
  gl.Translatef(0.9f, 0, 0), gl.Scalef(-1, 1, 1), gl.Rotatef(40, 1, 1, 0);
  send(gl, ring);
  gl.PopMatrix();
}

void clipPlanes(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  paint(gl, 0.3f, 0.8f, 0.5f);
  material(gl, GL_BACK, GL_DIFFUSE, {0.8f, 0.2f, 0.2f, 1});
  // An axes box, in the eye space of the call; the model turns within it.
  const GLdouble box[6][4] = {{1, 0, 0, 0.8},  {-1, 0, 0, 0.9}, {0, 1, 0, 0.6},
                              {0, -1, 0, 0.7}, {0, 0, 1, 0.75}, {0, 0, -1, 0.65}};
  for (int i = 0; i < 6; ++i) {
    gl.ClipPlane(GL_CLIP_PLANE0 + static_cast<GLenum>(i), box[i]);
    gl.Enable(GL_CLIP_PLANE0 + static_cast<GLenum>(i));
  }
  gl.Rotatef(25, 0, 1, 0);
  send(gl, sphere(40, 60));
}

/// Planes that differ between objects of one frame, and a slanted cut through a textured hole.
void clipPlanesPerObject(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height, 5);
  keyLight(gl);
  const Model ball = sphere(30, 40);
  for (int i = 0; i < 3; ++i) {
    gl.PushMatrix();
    gl.Translatef(-1.6f + 1.6f * static_cast<float>(i), 0, 0);
    const GLdouble plane[] = {i == 0 ? 1.0 : 0.3, i == 1 ? -1.0 : 0.5, -0.8, 0.1};
    gl.ClipPlane(GL_CLIP_PLANE2, plane);
    if (i < 2)
      gl.Enable(GL_CLIP_PLANE2);
    else
      gl.Disable(GL_CLIP_PLANE2);
    paint(gl, 0.9f, 0.3f * static_cast<float>(i), 0.4f);
    gl.Scalef(0.7f, 0.7f, 0.7f);
    send(gl, ball);
    gl.PopMatrix();
    sendAt(gl, ball, -1.6f + 1.6f * static_cast<float>(i), 0, 0, 0.3f);
  }
}

/// Filled polygons pushed back, their edges drawn over them.
void offsetAndLines(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.7f, 0.6f, 0.9f);
  const Model m = torus(0.8f, 0.4f, 24, 14);
  gl.PolygonOffset(1, 2);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.Rotatef(-35, 1, 0, 0);
  send(gl, m);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
  gl.Disable(GL_LIGHTING);
  gl.DepthFunc(GL_LEQUAL);
  gl.Color3f(0, 0, 0);
  gl.Begin(GL_LINES);
  for (size_t i = 0; i < m.indices.size(); i += 3)
    for (size_t k = 0; k < 3; ++k) {
      gl.Vertex3fv(&m.positions[m.indices[i + k] * 3]);
      gl.Vertex3fv(&m.positions[m.indices[i + (k + 1) % 3] * 3]);
    }
  gl.End();
}

/// Two coplanar sheets: the one that offset brings forward wins.
void offsetDecides(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height, 3);
  const Model m = sheet(12);
  gl.Rotatef(-40, 1, 0, 0);
  gl.Color3f(0.2f, 0.4f, 0.9f);
  send(gl, m, 0);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(-1, -4);
  gl.Color3f(0.9f, 0.6f, 0.1f);
  gl.Scalef(0.5f, 1, 1);
  gl.Scalef(2, 1, 1);  // back again: the same places
  gl.Begin(GL_TRIANGLES);
  for (size_t i = 0; i < m.indices.size() / 2; ++i) gl.Vertex3fv(&m.positions[m.indices[i] * 3]);
  gl.End();
}

void depthRangeBands(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  const Model ball = sphere(20, 30);
  gl.DepthRange(0.5, 1);
  paint(gl, 0.9f, 0.2f, 0.2f);
  sendAt(gl, ball, 0, 0, 1, 0.6f);  // near, but in the far band
  gl.DepthRange(0, 0.5);
  paint(gl, 0.2f, 0.9f, 0.2f);
  sendAt(gl, ball, 0.4f, 0.2f, -1, 0.6f);
  gl.DepthRange(0.9, 0.6);  // reversed
  paint(gl, 0.2f, 0.2f, 0.9f);
  sendAt(gl, ball, -0.8f, 0, 0, 0.5f);
}

void rectangles(Gl gl) {
  gl.Color3f(0.9f, 0.1f, 0.1f), gl.Rectf(-1, -0.8f, 0, 0.8f);
  gl.DepthFunc(GL_LEQUAL);
  gl.Color3f(0.1f, 0.9f, 0.1f), gl.Rectf(-0.8f, -0.6f, 0.2f, 0.6f);  // equal depth wins
  gl.DepthFunc(GL_LESS);
  gl.Color3f(0.1f, 0.1f, 0.9f), gl.Rectf(-0.6f, -0.4f, 0.4f, 0.4f);  // equal depth loses
  gl.DepthFunc(GL_ALWAYS);
  gl.Color3f(0.9f, 0.9f, 0.1f), gl.Rectf(-0.4f, -0.2f, 0.6f, 0.2f);
  gl.DepthFunc(GL_GREATER);
  gl.Translatef(0, 0, -1);
  gl.Color3f(0.1f, 0.9f, 0.9f), gl.Rectf(-0.2f, -0.9f, 0.8f, 0.1f);
}

/// All in one plane that faces the viewer: the order of drawing decides.
void depthFunctions(Gl gl, int width, int height) {
  begin(gl, width, height);
  flatCamera(gl, width, height);
  rectangles(gl);
}

/// The same surface, drawn over itself in another colour: LEQUAL shows the last, LESS the first.
void redrawnSurface(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  const Model ring = torus(0.5f, 0.2f, 30, 16);
  for (const bool lequal : {true, false}) {
    gl.DepthFunc(lequal ? GL_LEQUAL : GL_LESS);
    paint(gl, 0.9f, 0.2f, 0.2f);
    sendAt(gl, ring, lequal ? -0.8f : 0.8f, 0, 0, 1);
    paint(gl, 0.2f, 0.9f, 0.2f);
    sendAt(gl, ring, lequal ? -0.8f : 0.8f, 0, 0, 1);
  }
}

constexpr Scene kSurfaceScenes[] = {
    {"culling", culling},
    {"mirrored", mirrored},
    {"clip-planes", clipPlanes},
    {"clip-planes-per-object", clipPlanesPerObject},
    {"offset-and-lines", offsetAndLines},
    {"offset-decides", offsetDecides},
    {"depth-range-bands", depthRangeBands},
    {"depth-functions", depthFunctions, false},
    {"redrawn-surface", redrawnSurface},
};

}  // namespace

std::span<const Scene> surfaceScenes() { return kSurfaceScenes; }

}  // namespace gluray::scenes
