#include "tests/fuzz/found/found.h"

#include <cmath>

namespace gluray::test {
namespace {

void material(Gl gl, GLenum name, Answers& answers) {
  std::array<float, 4> v{};
  gl.GetMaterialfv(GL_FRONT, name, v.data());
  answers.insert(answers.end(), v.begin(), v.end());
}

const Found kFound[] = {
    {"a colour after arrays with colours, a clear, and glColorMaterial",
     [](Gl gl, Answers& a) {
       gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_LIGHTING), gl.Enable(GL_COLOR_MATERIAL);
       gl.VertexPointer(3, GL_FLOAT, 0, kValues), gl.EnableClientState(GL_VERTEX_ARRAY);
       gl.ColorPointer(4, GL_FLOAT, 0, kValues), gl.EnableClientState(GL_COLOR_ARRAY);
       gl.DrawArrays(GL_TRIANGLES, 0, 3), gl.DisableClientState(GL_COLOR_ARRAY);
       gl.Color4f(0.25f, 0.5f, 0.75f, 1), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
       gl.ColorMaterial(GL_FRONT, GL_SPECULAR);
       for (const GLenum name : {GL_AMBIENT, GL_SPECULAR}) material(gl, name, a);
     }},
    {"materials in a primitive that follow the colour, and others",
     [](Gl gl, Answers& a) {
       gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_LIGHTING), gl.Enable(GL_COLOR_MATERIAL);
       for (const GLenum name : {GL_AMBIENT, GL_SPECULAR, GL_EMISSION}) {
         gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
         gl.PushAttrib(GL_CURRENT_BIT), gl.Color4f(0.25f, 0.5f, 0.75f, 1), four(gl, GL_CURRENT_COLOR, a);
         gl.PopAttrib();
         gl.Begin(GL_TRIANGLES), gl.Vertex2f(-1, -1), gl.Vertex2f(1, -1);
         gl.Materialfv(GL_FRONT_AND_BACK, name, kValues), gl.Vertex2f(0, 1), gl.End();
         GLfloat pixel[4] = {};
         gl.ReadPixels(16, 12, 1, 1, GL_RGBA, GL_FLOAT, pixel);
         for (const GLfloat value : pixel) a.push_back(std::round(value * 85));  // a rounding is allowed
       }
     }},
    {"a colour after glArrayElement in a primitive, and glColorMaterial",
     [](Gl gl, Answers& a) {
       gl.ColorMaterial(GL_FRONT, GL_SPECULAR), gl.Enable(GL_COLOR_MATERIAL);
       gl.Color4f(0.125f, 0.5f, 0.75f, 1);
       gl.VertexPointer(3, GL_FLOAT, 0, kValues), gl.EnableClientState(GL_VERTEX_ARRAY);
       gl.Begin(GL_TRIANGLES), gl.ArrayElement(0), gl.ArrayElement(1), gl.ArrayElement(2), gl.End();
       gl.Color4f(0.25f, 0.5f, 0.75f, 1);
       gl.ColorMaterial(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
       for (const GLenum name : {GL_AMBIENT, GL_SPECULAR}) material(gl, name, a);
     }},
};

}  // namespace

std::span<const Found> foundMaterials() { return kFound; }

}  // namespace gluray::test
