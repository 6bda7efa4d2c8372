// The ways a fixed-function program hands its mesh to OpenGL.
#pragma once
#include "bench/data/triangle_mesh.h"

#include <memory>
#include <string>
#include <vector>

namespace gluray::bench {

/// One way to draw the mesh. Needs a current context from construction to destruction.
class DrawPath {
 public:
  virtual ~DrawPath() = default;
  virtual void draw() = 0;
};

/// Names for makePath:
///   list       glBegin, glNormal3fv, glVertex3fv for every corner, compiled into one display list
///   elements   one glDrawElements from client arrays, compiled into one display list
///   vbo        glDrawElements from buffer objects
///   arrays     glDrawElements from client arrays, every frame
///   immediate  glBegin, glNormal3fv, glVertex3fv for every corner, every frame
const std::vector<std::string>& pathNames();

/// Hands the mesh to OpenGL. Paths that leave all of it there (list, elements, vbo) free the mesh at once;
/// the others keep it and read it in every draw. Throws std::runtime_error for an unknown name or where
/// OpenGL is out of memory.
std::unique_ptr<DrawPath> makePath(const std::string& name, TriangleMesh&& mesh);

}  // namespace gluray::bench
