#include "tests/fuzz/found/found.h"

#include <functional>

namespace gluray::test {
namespace {

constexpr GLfloat kCorners[] = {-0.5f, -0.5f, 0.1f, 0.5f, -0.5f, 0.1f, 0, 0.5f, 0.1f};

/// A list that keeps what it sets to itself, around `body`; then a colour, and the list twice.
void keepsToItself(Gl gl, Answers& a, GLenum mode, const std::function<void()>& body) {
  gl.Enable(GL_DEPTH_TEST);
  gl.VertexPointer(3, GL_FLOAT, 0, kCorners), gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.NewList(1, mode);
  gl.PushAttrib(GL_ALL_ATTRIB_BITS), body(), gl.PopAttrib();
  gl.EndList();
  four(gl, GL_CURRENT_COLOR, a);
  for (int i = 0; i < 3; ++i) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Color4f(0.25f, 0.5f, 0.75f, 1);
    if (i == 1) gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.CallList(1);
    if (i == 2) gl.ShadeModel(GL_FLAT);
    four(gl, GL_CURRENT_COLOR, a);
  }
}

const Found kFound[] = {
    {"a list of a colour and arrays",
     [](Gl gl, Answers& a) {
       for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE})
         keepsToItself(gl, a, mode, [&] { gl.Color3f(1, 0, 0.5f), gl.DrawArrays(GL_TRIANGLES, 0, 3); });
     }},
    {"a list of a colour material, a colour, a normal and arrays",
     [](Gl gl, Answers& a) {
       for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE})
         keepsToItself(gl, a, mode, [&] {
           gl.ColorMaterial(GL_BACK, GL_AMBIENT), gl.Color3f(1, 0, 0.5f), gl.Normal3f(0.5f, 0.5f, 1);
           gl.DrawArrays(GL_TRIANGLES, 0, 3);
         });
     }},
    {"a list of a colour, arrays and another colour",
     [](Gl gl, Answers& a) {
       for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE})
         keepsToItself(gl, a, mode, [&] {
           gl.Color3f(1, 0, 0.5f), gl.DrawArrays(GL_TRIANGLES, 0, 3);
           gl.Color3f(0, 1, 0.5f), gl.DrawArrays(GL_TRIANGLES, 0, 3);
         });
     }},
    {"a list of a colour material, a colour, arrays and another colour",
     [](Gl gl, Answers& a) {
       for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE})
         keepsToItself(gl, a, mode, [&] {
           gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT), gl.Color3f(1, 0, 0.5f),
               gl.DrawArrays(GL_TRIANGLES, 0, 3);
           gl.Color3f(1, 1, 0.5f);
         });
     }},
    {"a list of a colour and a primitive",
     [](Gl gl, Answers& a) {
       for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE})
         keepsToItself(gl, a, mode, [&] {
           gl.Color3f(1, 0, 0.5f);
           gl.Begin(GL_TRIANGLES);
           for (int i = 0; i < 3; ++i) gl.Vertex3fv(kCorners + 3 * i);
           gl.End();
         });
     }},
    {"a list of a colour, a normal and lines",
     [](Gl gl, Answers& a) {
       for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE})
         keepsToItself(gl, a, mode, [&] {
           gl.Color3f(1, 0, 0.5f), gl.Normal3f(0.5f, 0.5f, 1), gl.DrawArrays(GL_LINE_STRIP, 0, 3);
         });
     }},
};

}  // namespace

std::span<const Found> foundLists() { return kFound; }

}  // namespace gluray::test
