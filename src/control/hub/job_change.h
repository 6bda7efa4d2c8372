// Makes a set, undo or redo in the same frame of all ranks of an MPI job (docs/control-protocol.md, set). On
// the hub's thread.
#pragma once
#include "control/hub/questions.h"

#include <cstdint>
#include <map>

namespace gluray::control {

/// Tells all ranks to hold the change, then tells them the frame and to draw; if a rank fails, tells them to
/// drop the change. `ranks`: connections by rank, including rank 0. `done` receives rank 0's result with
/// `late`, or `why`.
void changeJob(Questions& questions, const std::map<int, uint64_t>& ranks, const nlohmann::json& change,
               Questions::Done done);

/// A rank's answer when it holds a change.
struct HeldAt {
  int64_t frame = 0;  // number of its current frame
  bool drawing = false;
  HubTime began{};    // when that frame began, as far as the hub knows
  double period = 0;  // seconds between the starts of the previous frame and this one; 0: unknown
};

/// The frame from which each rank uses the values, in the rank's own count. Ranks begin frames together, but
/// their counts may differ by a constant. A rank whose frame began a period after those of the others is one
/// frame ahead.
std::map<int, int64_t> framesToApply(const std::map<int, HeldAt>& held);

}  // namespace gluray::control
