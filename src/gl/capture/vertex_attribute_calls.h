// Attribute calls, made millions of times a frame: a thread-local read, a test and a few stores. Rare cases
// go to Context through one out-of-line call. Called by stubs on any thread with a current context.
#pragma once
#include "gl/basics/thread_state.h"
#include "gl/capture/vertex_stream.h"

#include <GL/gl.h>

namespace gluray::gl::vertexcall {

/// Rare cases: no run, slot not in the run, passthrough, rasterised glBegin.
void slowAttribute(Slot slot, const float* values) noexcept;
void slowVertex(float x, float y, float z, float w) noexcept;

inline void attribute(Slot slot, float x, float y = 0, float z = 0, float w = 0) {
  VertexStream* stream = t_thread.stream;
  if (stream && stream->has(slot)) [[likely]]
    return stream->set(slot, x, y, z, w);
  const float values[] = {x, y, z, w};
  slowAttribute(slot, values);
}

inline void vertex(float x, float y, float z = 0, float w = 1) {
  VertexStream* stream = t_thread.stream;
  if (stream && w == 1.0f && stream->hasRoom()) [[likely]]
    stream->vertex(x, y, z);
  else
    slowVertex(x, y, z, w);
}
inline void normal(float x, float y, float z) { attribute(kNormal, x, y, z); }
inline void color(float r, float g, float b, float a = 1) { attribute(kColor, r, g, b, a); }
inline void secondaryColor(float r, float g, float b) { attribute(kSecondaryColor, r, g, b, 1); }
inline void fogCoord(float f) { attribute(kFogCoord, f); }
inline void index(float i) { attribute(kIndex, i); }
inline void edgeFlag(bool flag) { attribute(kEdgeFlag, flag ? 1.0f : 0.0f); }

/// Sets GL_INVALID_ENUM.
void invalidUnit() noexcept;
/// `unit` counts from 0; units above 7 set GL_INVALID_ENUM.
inline void texCoord(GLuint unit, float s, float t = 0, float r = 0, float q = 1) {
  if (unit < 8) [[likely]]
    attribute(static_cast<Slot>(kTexCoord0 + unit), s, t, r, q);
  else
    invalidUnit();
}

/// Generic attribute 0 is the vertex. Indices above 15 set GL_INVALID_VALUE.
void vertexAttribSlow(GLuint index, float x, float y, float z, float w) noexcept;
inline void vertexAttrib(GLuint i, float x, float y = 0, float z = 0, float w = 1) {
  if (i > 0 && i < 16) [[likely]]
    attribute(static_cast<Slot>(kGeneric1 + (i - 1)), x, y, z, w);
  else
    vertexAttribSlow(i, x, y, z, w);
}

}  // namespace gluray::gl::vertexcall
