// Counts and times of a context's draws and frames, for `--report` and `gluray explain`. The GL thread writes
// them; any thread may read them at any time.
#pragma once
#include "gl/basics/counter.h"
#include "gl/basics/reasons.h"

#include <array>
#include <cstdint>

namespace gluray::gl {

/// Counters of one context; sums over contexts make the report.
struct Statistics {
  using Count = Counter<uint64_t>;
  using Seconds = Counter<double>;
  Count frames;         // buffer swaps (or finishes of single-buffered drawing)
  Count framesInFront;  // frames of double-buffered contexts that draw into the front buffer and call glFlush
                        // or glFinish, without a swap; counted if ContextInfo::frameEnded is set, not in
                        // `frames`
  Count framesInMemory;  // pictures of contexts that do not swap, in framebuffer objects or pixel buffers:
                         // read, copied or flushed before they were cleared again; not in `frames`
  Count framesPassedThrough;  // passthrough frames
  Count drawsTraced, drawsRasterised;
  Count drawsCulled, trianglesLeftOut;  // rasterised without hidden parts; triangles of these parts
  Count drawsLit;                       // rasterised, then multiplied by traced light
  Count imagesRelit;                    // traced again in their frame, with other light (adr/0095)
  Count trianglesTraced, trianglesRasterised;
  std::array<Count, kReasonCount> rasterisedBecause{};  // draws, by reason
  Count flushes;                                        // batches written to a framebuffer
  Count repeated;                                       // flushes without a change since the last one
  Count meshesBuilt, meshBytes;
  Seconds captureSeconds, buildSeconds, traceSeconds, presentSeconds;
  Count lightPasses;                            // passes that refined images
  Counter<double> lightNoise;                   // estimated noise of the last refined image; 0: none
  Count blasBuilds, blasRefinements, bvhBytes;  // builds that flushes waited for; better BLASes
  Count blasRefining;                           // 1: a better BLAS was being built at the last flush

  Statistics& operator+=(const Statistics& other);
};

}  // namespace gluray::gl
