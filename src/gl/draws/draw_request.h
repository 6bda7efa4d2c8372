// A requested draw: the source of its vertices, how it is traced, and how the real OpenGL makes it. A
// command's handler builds a request and passes it to Draws, which calls these functions in this order. GL
// thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/capture/mesh_cache.h"
#include "gl/counts/draw_kinds.h"
#include "gl/draws/fate.h"

#include <cstdint>

namespace gluray::gl {

class DrawRequest {
 public:
  /// How the draw is counted if the real OpenGL makes it.
  struct Load {
    DrawPath path = DrawPath::arrays;
    PrimitiveClass primitive = PrimitiveClass::surfaces;
    uint64_t triangles = 0;
    uint64_t more = 0;  // the work of its fragments, as the number of triangles that take as long
  };

  /// The reason why no such draw is traced in the current state, whatever its vertices are, or
  /// Reason::traced. Does not throw.
  virtual Reason classifyState() = 0;
  /// The draw's mesh, known or new. May throw.
  virtual KnownMesh mesh() = 0;
  /// The reason why a draw of this mesh is not traced, or Reason::traced. May throw.
  virtual Reason classifyMesh(const KnownMesh& mesh) = 0;
  /// Adds the draw to the batch, and counts it. Returns Reason::traced, or why it cannot join. May throw.
  virtual Reason trace(const KnownMesh& mesh) = 0;
  /// Replaces a draw that is not traced for this reason by something faster. Returns false if nothing was
  /// done.
  virtual bool replace(Reason) { return false; }
  virtual Load load() = 0;
  /// Compares the draw with other passes over the same surfaces. It is counted with this primitive class, and
  /// rasterised for this reason.
  virtual void meetPasses(PrimitiveClass primitive, Reason reason) = 0;
  /// Makes the draw with the real OpenGL.
  virtual Fate make() = 0;

 protected:
  ~DrawRequest() = default;
};

}  // namespace gluray::gl
