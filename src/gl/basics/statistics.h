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
  Count frames;          // buffer swaps (or finishes of single-buffered drawing)
  Count framesInFront;   // of double-buffered contexts that do not swap: glFlush or glFinish after drawing
                         // into the front buffer; counted if ContextInfo::frameEnded is set, not in `frames`
  Count framesInMemory;  // pictures of contexts that do not swap, in framebuffer objects or pixel
                         // buffers: read, copied or flushed before they were cleared again; not in `frames`
  Count framesPassedThrough;  // passthrough frames
  Count drawsTraced, drawsRasterised;
  Count drawsCulled, trianglesLeftOut;  // rasterised without what cannot be seen
  Count drawsLit;                       // rasterised, with light that is multiplied onto them
  Count imagesRelit;                    // traced again in their frame, with other light (adr/0095)
  Count trianglesTraced, trianglesRasterised;
  std::array<Count, kReasonCount> rasterisedBecause{};  // draws, by reason
  Count flushes;                                        // batches written to a framebuffer
  Count repeated;                                       // those flushes in which nothing had changed
  Count meshesBuilt, meshBytes;
  Seconds captureSeconds, buildSeconds, traceSeconds, presentSeconds;
  Count lightPasses;                            // refining images with light
  Counter<double> lightNoise;                   // of the last refined image, estimated; 0: none was
  Count blasBuilds, blasRefinements, bvhBytes;  // builds waited for; BLASes replaced by better ones
  Count blasRefining;                           // 1: a better BLAS was being built at the last flush

  Statistics& operator+=(const Statistics& other);
};

}  // namespace gluray::gl
