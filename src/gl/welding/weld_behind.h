// Welds the pieces of a large run on a thread of its own while the program sends on. The GL thread makes all
// calls.
#pragma once
#include "gl/capture/growing_array.h"
#include "gl/welding/stream_weld.h"

#include <cstdint>
#include <memory>

namespace gluray::gl {

class WeldBehind {
 public:
  static constexpr uint32_t kPieces = 4;  // that wait, or are being welded, at most

  /// What has been welded: `kept` vertices and a number for each that was sent.
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
  /// Goes on from `run`, whose vertices have `stride` floats, with pieces of at most `pieceVertices`; `piece`
  /// is then memory for the first. False where there is no thread or no memory: nothing has changed.
  bool start(Run& run, uint32_t stride, uint32_t pieceVertices, GrowingArray<float>& piece) noexcept;
  /// Takes a piece and gives memory for another in its place, waiting for it where the thread is behind.
  /// False, and the piece stays, where the thread has ended for want of memory: finish() then.
  bool hand(GrowingArray<float>& piece, uint32_t vertices);
  /// Welds what has been handed over and ends; the run has room for `more` vertices. Throws std::bad_alloc
  /// and stays active: finish() may be called again.
  Run finish(uint32_t more);
  /// Ends without a result.
  void drop() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;  // null: not active
};

}  // namespace gluray::gl
