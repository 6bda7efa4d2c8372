// Frame lag (adr/0023): a frame that the program has swapped is traced while the program prepares the next
// one, and is shown when the program next touches the window. Until then the back buffer lacks only the
// traced part. Owned by WindowFrames, GL thread.
#pragma once
#include "gl/batch/held_batch.h"
#include "gl/batch/presenter.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace gluray::gl {

/// The window whose buffers the program has swapped.
struct LagWindow {
  std::function<bool()> stands;  // whether the window still exists
  std::function<void()> swap;    // the swap that the program requested
  ShowImage show;                // shows an image over a clear in place of the swap; may be empty
  Overdue overdue;               // shows the image if the program stays idle
};

struct LaggedFrame {
  HeldBatch batch;
  LagWindow window;
  std::optional<ClearedTarget> cleared;  // the window's clear, if the window contains nothing else
  float farthest = 1;                    // with `cleared`: hits beyond this window depth are invisible
  std::vector<WindowClear> clears;       // clears of the next frame, to be made after the swap
};

}  // namespace gluray::gl
