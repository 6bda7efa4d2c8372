// Presents the pending batch at once: implemented by Flusher, for parts that it uses itself. GL thread.
#pragma once

namespace gluray::gl {

class BatchFlush {
 public:
  /// Traces the pending batch, if any, and writes it into the framebuffer; delayed images stay delayed.
  virtual void flushBatch() = 0;

 protected:
  ~BatchFlush() = default;
};

}  // namespace gluray::gl
