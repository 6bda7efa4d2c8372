// Reasons why a frame was shown at once although frame lag is on (docs/adr/0023).
#pragma once

#include <cstdint>
#include <string_view>

namespace gluray::gl {

/// Why a frame was shown at once.
enum class LagRefusal : uint8_t {
  none,         // the frame lags
  nothingToDo,  // no batch was pending
  target,       // the batch goes to something other than a plain back buffer
  repeated,     // its image was known
  measured,     // engine = auto measured the frame, or left it to the real OpenGL
  state,        // a query, layers, other contexts
  single,       // frames were not consecutive
  window,       // the window's content cannot be shown without the program
  failure,      // no thread, no memory
};
inline constexpr int kLagRefusals = 9;
/// The refusal in a few words, for reports.
std::string_view describe(LagRefusal refusal);

}  // namespace gluray::gl
