// Helpers shared by array draws of fixed function and of shader programs. Private to gl/arrays. GL thread.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/capture/mesh_cache.h"
#include "gl/counts/draw_kinds.h"
#include "gl/draws/draw_request.h"
#include "gl/real/elements.h"

#include <GL/gl.h>

#include <cstdint>

namespace gluray::gl {

class Context;

inline DrawPath pathOf(const Elements& e) { return e.type ? DrawPath::elements : DrawPath::arrays; }

inline PrimitiveClass kindOf(GLenum mode) {
  return mode <= GL_POLYGON ? classOf(mode) : PrimitiveClass::lines;
}

/// Raises the error of an invalid draw: now, or in a list when that is called.
void refuse(Context& c, GLenum error);
/// Whether the draw is valid; raises its error if not.
bool validate(Context& c, GLenum mode, const Elements& elements);

/// Number of triangles of the draw, in all instances together.
uint64_t trianglesOf(GLenum mode, const Elements& elements);

/// The mesh of the draw: a known one with this content, or a new one.
KnownMesh meshOf(Context& c, const ArrayState& arrays, GLenum mode, const Elements& elements);

/// What a draw counts as; an impostor counts as one triangle.
DrawRequest::Load loadOf(Context& c, GLenum mode, const Elements& elements);

/// Whether the real OpenGL makes the draws of the shader program in use, whatever the state and their
/// vertices are, and nothing waits for them or asks about them.
bool drawsUntraced(Context& c);
/// Call before such a draw, or several together, of `triangles` triangles: counts it and prepares for it.
void beforeUntraced(Context& c, GLenum mode, DrawPath path, uint64_t triangles);
/// Call for each of these after beforeUntraced(): later surfaces of the depth epoch may coincide with it.
void rememberUntraced(Context& c, GLenum mode, const Elements& elements);
/// Makes such a draw, unless it does not show and is left out. False: it is none, or some of it may be left
/// out, and nothing was done.
bool drawUntraced(Context& c, GLenum mode, const Elements& elements);

}  // namespace gluray::gl
