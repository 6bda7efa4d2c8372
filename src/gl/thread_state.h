// What each thread knows about OpenGL: its current context and the vertex stream it is filling. Vertex
// attribute calls (glVertex*, glNormal* ...) read nothing else. Initial-exec TLS: 2 ns a call instead of 7.
#pragma once
#include <cstdint>

namespace gluray::gl {

class Context;
class VertexStream;
struct RealGl;

struct ThreadState {
  Context* context = nullptr;
  VertexStream* stream =
      nullptr;  // where vertex attributes go; null outside captured glBegin/glEnd and lists
  const RealGl* passthrough = nullptr;  // where they go instead while nothing is captured at all
  uint32_t passthroughVertices = 0;     // that went there
};

// constinit: otherwise every use asks first whether it has been initialised.
extern constinit thread_local ThreadState t_thread __attribute__((tls_model("initial-exec")));

}  // namespace gluray::gl
