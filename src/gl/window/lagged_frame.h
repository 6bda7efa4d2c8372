// Frame lag: a frame that the program has swapped is traced while it prepares the next one, and shown where
// that touches the window. Until then the window's back buffer holds all of it but what is traced.
// Owned by Context, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/batch/presenter.h"
#include "gl/programs/program_draw.h"
#include "scene/snapshot.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace gluray::gl {

/// The window whose buffers the program has swapped.
struct LagWindow {
  std::function<bool()> stands;  // whether it is still there
  std::function<void()> swap;    // what the program asked for
  ShowPicture show;              // does the same to a window that holds a clear and the picture; may be empty
  Overdue overdue;               // where the program does not go on
};

struct LaggedFrame {
  BatchKey key;
  scene::SnapshotPtr snapshot;
  std::vector<ProgramDraw> draws;
  LagWindow window;
  std::optional<ClearedTarget> cleared;  // the window, where it holds nothing else
  float farthest = 1;                    // then: hits beyond that window depth are not seen
  std::vector<WindowClear> clears;       // of the next frame, which come after the swap
};

/// Why a frame was shown at once.
enum class LagRefusal : uint8_t {
  none,         // it was not
  nothingToDo,  // nothing waited to be traced
  target,       // what waited goes elsewhere than into the back buffer, or the buffer is multisampled
  repeated,     // its picture was there
  measured,     // engine = auto measured it, or it is the real OpenGL's
  state,        // a query, layers, other contexts
  single,       // frames did not follow each other
  window,       // what is in the window cannot be shown without the program
  failure,      // no thread, no memory
};
inline constexpr int kLagRefusals = 9;
/// In a few words, for reports.
std::string_view describe(LagRefusal refusal);

}  // namespace gluray::gl
