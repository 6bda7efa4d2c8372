// What happened to the program's draws, for `--report` and `gluray explain`. Written by GL threads; read by
// any thread, meanwhile or at exit.
#pragma once
#include "gl/counter.h"
#include "gl/draws/reasons.h"

#include <array>
#include <cstdint>

namespace gluray::gl {

/// Counters of one context; sums over contexts make the report.
struct Statistics {
  using Count = Counter<uint64_t>;
  using Seconds = Counter<double>;
  Count frames;         // buffer swaps (or finishes of single-buffered drawing)
  Count framesInFront;  // of double-buffered contexts that do not swap: glFlush or glFinish after drawing
                        // into the front buffer; counted where somebody wants to know, and not among `frames`
  Count framesPassedThrough;  // those left to the real OpenGL as they came
  Count drawsTraced, drawsRasterised;
  Count trianglesTraced, trianglesRasterised;
  std::array<Count, kReasonCount> rasterisedBecause{};  // draws, by reason
  Count flushes;                                        // batches written to a framebuffer
  Count repeated;                                       // of them those in which nothing had changed
  Count meshesBuilt, meshBytes;
  Seconds captureSeconds, buildSeconds, traceSeconds, presentSeconds;
  Count blasBuilds, blasRefinements, bvhBytes;  // waited for; exchanged for better ones
  Count blasRefining;                           // a better one was being built at the last flush: 1

  Statistics& operator+=(const Statistics& other);
};

}  // namespace gluray::gl
