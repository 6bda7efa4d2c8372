// Steps that most scenes begin with: clear, camera, light, and sending a model vertex by vertex.
#pragma once
#include "scenes/scene.h"
#include "scenes/shapes.h"

#include <array>

namespace gluray::scenes {

using Color = std::array<float, 4>;

/// Viewport over the window, colour and depth cleared, depth test on.
void begin(Gl gl, int width, int height, Color background = {0.1f, 0.15f, 0.25f, 1});
/// Perspective of 40 degrees, seen from (0, 1.2, distance) towards the origin. Leaves the modelview matrix
/// chosen.
void camera(Gl gl, int width, int height, float distance = 4);
/// Orthographic, `half` units above and below the axis, depth -10 to 10, identity modelview.
void flatCamera(Gl gl, int width, int height, double half = 1);
/// The same, turned by 20 degrees about the y axis: what lies in the xy plane has more than one depth.
void tiltedCamera(Gl gl, int width, int height, double half = 1);
/// GL_LIGHTING with GL_LIGHT0 from the upper right of the viewer.
void keyLight(Gl gl);
void light(Gl gl, GLenum name, GLenum parameter, Color value);
void material(Gl gl, GLenum face, GLenum parameter, Color value);
/// Diffuse and ambient colour of front and back, no gloss.
void paint(Gl gl, float red, float green, float blue);

enum Send : unsigned { kNormals = 1, kColors = 2, kTexcoords = 4 };
/// glBegin(GL_TRIANGLES) with glVertex3fv and what `what` asks for.
void send(Gl gl, const Model& model, unsigned what = kNormals);
/// send() of `model` at a place, scaled.
void sendAt(Gl gl, const Model& model, float x, float y, float z, float scale, unsigned what = kNormals);

}  // namespace gluray::scenes
