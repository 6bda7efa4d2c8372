// Welds a large run in pieces on a background thread while the program sends more vertices. Owned by
// VertexStream; the GL thread makes all calls.
#pragma once
#include "gl/basics/growing_array.h"
#include "gl/welding/stream_weld.h"

#include <cstdint>
#include <memory>

namespace gluray::gl {

class WeldBehind {
 public:
  static constexpr uint32_t kPieces = 4;  // most pieces that are queued or being welded

  /// A welded run: `kept` vertices, and an index for each vertex sent.
  struct Run {
    GrowingArray<float> vertices;
    GrowingArray<uint32_t> indices;
    StreamWelder welder;
    uint32_t kept = 0;
  };

  WeldBehind();
  ~WeldBehind();
  WeldBehind(const WeldBehind&) = delete;
  WeldBehind& operator=(const WeldBehind&) = delete;

  bool active() const { return state_ != nullptr; }
  /// Takes over `run`, whose vertices have `stride` floats, to continue it with pieces of at most
  /// `pieceVertices`; `piece` becomes memory for the first. False, with nothing changed: no thread or memory.
  bool start(Run& run, uint32_t stride, uint32_t pieceVertices, GrowingArray<float>& piece) noexcept;
  /// Queues a piece and replaces it by memory for the next; waits while the queue is full. False, with the
  /// piece left as it is, if the thread has run out of memory and ended: call finish() then.
  bool hand(GrowingArray<float>& piece, uint32_t vertices);
  /// Ends once all queued pieces are welded, and returns the run, with room for `more` vertices. If it throws
  /// std::bad_alloc it stays active, and finish() may be called again.
  Run finish(uint32_t more);
  /// Discards the run and ends.
  void drop() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;  // null: not active
};

}  // namespace gluray::gl
