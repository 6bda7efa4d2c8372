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
  static constexpr uint32_t kPieces = 4;  // maximum number of pieces that are queued or being welded

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
  /// Takes over `run`, whose vertices have `stride` floats, and continues it with pieces of at most
  /// `pieceVertices` vertices. Sets `piece` to memory for the first. Returns false, with nothing changed,
  /// without a thread or memory.
  bool start(Run& run, uint32_t stride, uint32_t pieceVertices, GrowingArray<float>& piece) noexcept;
  /// Queues a piece and replaces it by memory for the next; waits while the queue is full. Returns false and
  /// leaves the piece unchanged if the thread has run out of memory and ended: call finish() then.
  bool hand(GrowingArray<float>& piece, uint32_t vertices);
  /// Waits until all queued pieces are welded, ends the thread, and returns the run with room for `more`
  /// vertices. If it throws std::bad_alloc the object stays active, and finish() may be called again.
  Run finish(uint32_t more);
  /// Discards the run and ends the thread.
  void drop() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;  // null: not active
};

}  // namespace gluray::gl
