// Images that programs' windows show, and the files that they are saved in: gluray shot, gluray film.
#pragma once
#include "control/hub_session.h"
#include "explain/pixels.h"

#include <cstdint>
#include <optional>
#include <string>

namespace gluray::launcher {

/// What keeps an image from being written into the file: its name does not end in .png, or something else
/// than a PNG file stands there. Empty: nothing is known.
std::string whyNotInto(const std::string& file);
/// The same of pictures that are rendered, whose names may end in .exr: OpenEXR files.
std::string whyNoPictureInto(const std::string& file);

struct WindowImage {
  Pixels pixels;
  std::optional<int64_t> frame;  // counted from the program's first; absent: not known
};

/// A shot that the program keeps for some seconds.
struct Shot {
  nlohmann::json number;
  int width = 0, height = 0;
  std::optional<int64_t> frame;
};

/// Makes the program keep the image of the next frame that it shows. Throws.
Shot takeShot(HubSession& hub, const RunningProgram& program);

/// Fetches the image of a shot. Throws.
WindowImage imageOf(HubSession& hub, const RunningProgram& program, const Shot& shot);

/// The image of the next frame that the program shows. Throws.
WindowImage imageOf(HubSession& hub, const RunningProgram& program);

}  // namespace gluray::launcher
