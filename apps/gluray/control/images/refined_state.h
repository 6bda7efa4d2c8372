// Waits until a program has refined its image: gluray film --passes.
#pragma once
#include "control/one_program.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace gluray::launcher {

class RefinedState {
 public:
  /// Begins to observe the program's state. Throws where it does not refine images while it draws nothing.
  RefinedState(HubSession& hub, const RunningProgram& program, int64_t passes);

  /// Waits until the image of `frame` (nothing: the one that is shown) has the passes or is finished. Gives
  /// up after 60 s, after 10 s without a pass, and when stopped() holds. Returns whether it has the passes.
  /// Throws where the hub ends.
  bool wait(std::optional<int64_t> frame, const std::function<bool()>& stopped);

 private:
  /// The newest state; null: none came in that time.
  nlohmann::json awaitState(double seconds);

  HubSession& hub_;
  const int64_t passes_;
  int64_t most_ = 0;    // passes of an image, by the program's settings
  double noise_ = 0;    // of a finished image
  int64_t before_ = 0;  // passes when it was last looked at
};

}  // namespace gluray::launcher
