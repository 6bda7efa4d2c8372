// Which frames the launcher wants as saved scenes (gluray run --shot), and where. Any thread.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gluray::intercept {

struct CapturePlan {
  enum class When : uint8_t {
    frame,    // frame `number`
    every,    // each frame whose number is a multiple of `number`
    seconds,  // the first frame that ends after `seconds`, or what is shown then
    idle,     // what is shown when the program is at rest, or when it ends
  };
  When when = When::idle;
  uint64_t number = 1;  // frames are counted from 1
  double seconds = 0;   // since the process began to use OpenGL
  std::string folder;   // absolute

  bool wants(uint64_t frame, double time) const {
    if (when == When::frame) return frame == number;
    if (when == When::every) return frame % number == 0;
    return when == When::seconds && time >= seconds;
  }
  /// Whether one picture is all.
  bool isSingle() const { return when != When::every; }
  /// Whether the last frame must be known, because no other may follow.
  bool keepsLast() const { return when == When::seconds || when == When::idle; }
};

/// Reads "frame:12 FOLDER", "every:10 FOLDER", "seconds:2.5 FOLDER" or "idle FOLDER". None: it is something
/// else.
std::optional<CapturePlan> readCapturePlan(std::string_view text);

}  // namespace gluray::intercept
