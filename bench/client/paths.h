// The ways in which a fixed-function program sends its mesh to OpenGL.
#pragma once
#include "bench/data/isosurface.h"

#include <functional>
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
///   shader     as vbo, by a shader program with three lights and a pattern
///   waves      as shader, with vertices that the program's vertex shader moves
///   immediate  glBegin, glNormal3fv, glVertex3fv for every corner, every frame
/// and, of a mesh that never lies in the program's memory as a whole:
///   vbo-pieces   glBufferData without data, then glBufferSubData for each piece
///   list-pieces  as list, the pieces one after the other between one glBegin and glEnd
const std::vector<std::string>& pathNames();
bool takesPieces(const std::string& name);

/// Hands the mesh to OpenGL. Paths that leave all of it there (list, elements, vbo) free the mesh at once;
/// the others keep it and read it in every draw. Throws std::runtime_error for an unknown name or where
/// OpenGL is out of memory.
std::unique_ptr<DrawPath> makePath(const std::string& name, TriangleMesh&& mesh);

/// A mesh that is made piece by piece; each piece counts its vertices from 0.
struct MeshPieces {
  MeshSize size;
  std::function<void(const std::function<void(const TriangleMesh&)>&)> forEach;
};
/// The same for the paths that take pieces.
std::unique_ptr<DrawPath> makePath(const std::string& name, const MeshPieces& pieces);

}  // namespace gluray::bench
