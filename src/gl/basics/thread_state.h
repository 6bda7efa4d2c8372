// Per-thread state: the current context and the vertex stream that receives its vertices. Vertex attribute
// calls (glVertex*, glNormal* ...) read nothing else. Initial-exec TLS: 2 ns a call instead of 7.
#pragma once
#include <cstdint>

namespace gluray::gl {

class Context;
class VertexStream;
struct RealGl;

struct ThreadState {
  Context* context = nullptr;
  VertexStream* stream =
      nullptr;  // destination of vertex attributes; null outside captured glBegin/glEnd and lists
  const RealGl* passthrough = nullptr;  // receives vertex attributes while nothing is captured
  uint32_t passthroughVertices = 0;     // number of vertices sent to `passthrough`
};

// constinit: otherwise every access first checks whether it is initialised.
extern constinit thread_local ThreadState t_thread __attribute__((tls_model("initial-exec")));

/// Records that the calling thread has made a context current.
void noteThread() noexcept;
/// Whether more than one thread has made a context current. Any thread.
bool usedByThreads() noexcept;

}  // namespace gluray::gl
