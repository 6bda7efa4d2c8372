// A set, undo or redo in the same frame of all ranks of an MPI job (docs/control-protocol.md, set). On the
// hub's thread.
#pragma once
#include "control/hub/questions.h"

#include <cstdint>
#include <map>

namespace gluray::control {

/// Asks all ranks to hold the change, tells them the frame, and asks them to draw; or has them drop it.
/// `ranks`: connections by rank, with rank 0. `done` gets rank 0's result with `late`, or `why`.
void changeJob(Questions& questions, const std::map<int, uint64_t>& ranks, const nlohmann::json& change,
               Questions::Done done);

/// What a rank answers when it holds a change.
struct HeldAt {
  int64_t frame = 0;  // the one it is at
  bool drawing = false;
  HubTime began{};    // when that frame began, as far as the hub can tell
  double period = 0;  // seconds from the beginning of the frame before to that of this one; 0: unknown
};

/// The frame from which each rank uses the values, in its own count. Ranks begin frames together, but their
/// counts may differ by a constant. A rank whose frame began a period after that of the others is a frame
/// ahead.
std::map<int, int64_t> framesToApply(const std::map<int, HeldAt>& held);

}  // namespace gluray::control
