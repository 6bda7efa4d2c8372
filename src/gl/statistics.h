// What happened to the program's draws, for `--report` and `gluray explain`. Written by GL threads, read at
// exit.
#pragma once
#include "gl/reasons.h"

#include <array>
#include <cstdint>

namespace gluray::gl {

/// Counters of one context; sums over contexts make the report.
struct Statistics {
  uint64_t frames = 0;  // buffer swaps (or finishes of single-buffered drawing)
  uint64_t drawsTraced = 0, drawsRasterised = 0;
  uint64_t trianglesTraced = 0, trianglesRasterised = 0;
  std::array<uint64_t, kReasonCount> rasterisedBecause{};  // draws, by reason
  uint64_t flushes = 0;                                    // batches written to a framebuffer
  uint64_t meshesBuilt = 0, meshBytes = 0;
  double captureSeconds = 0, buildSeconds = 0, traceSeconds = 0, presentSeconds = 0;
  uint64_t blasBuilds = 0, bvhBytes = 0;

  Statistics& operator+=(const Statistics& other);
};

}  // namespace gluray::gl
