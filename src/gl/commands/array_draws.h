// Helpers shared by array draws of fixed function and of shader programs. Private to gl/commands. GL thread.
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

/// How the draw is counted; an impostor counts as one triangle.
DrawRequest::Load loadOf(Context& c, GLenum mode, const Elements& elements);

/// Whether the real OpenGL makes the draws of the shader program in use, in any state and with any vertices,
/// and neither pending draws nor requests for details (explain, objects, light) concern them.
bool drawsUntraced(Context& c);
/// Call before such a draw, or several together, with `triangles` triangles in all: counts and prepares them.
void beforeUntraced(Context& c, GLenum mode, DrawPath path, uint64_t triangles);
/// Call for each of these draws after beforeUntraced(): later surfaces of the depth epoch may coincide with
/// it.
void rememberUntraced(Context& c, GLenum mode, const Elements& elements);
/// Makes such a draw, or skips it if it is invisible. Returns false, with nothing done, if it is no such
/// draw, or if parts of it may be culled.
bool drawUntraced(Context& c, GLenum mode, const Elements& elements);

}  // namespace gluray::gl
