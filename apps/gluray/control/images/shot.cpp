#include "control/images/shot.h"

#include "base/files.h"
#include "base/printable.h"
#include "control/images/window_image.h"
#include "control/one_program.h"
#include "say.h"

#include <iostream>

namespace gluray::launcher {

int saveShot(const CommandLine& line) {
  const std::string file = line.control.file;
  if (const std::string why = whyNotInto(file); !why.empty()) return say(why), kUsageError;
  HubSession hub(line);
  const RunningProgram program = oneProgram(hub);
  const WindowImage image = labelled(program, [&] { return imageOf(hub, program); });
  const Pixels& pixels = image.pixels;
  if (const std::string why = files::replace(file, pngOf(pixels)); !why.empty()) return say(why), 1;
  if (line.json) {
    nlohmann::json found = named(program);
    found["frame"] = image.frame ? nlohmann::json(*image.frame) : nlohmann::json();
    found["file"] = file;
    found["width"] = pixels.width, found["height"] = pixels.height;
    std::cout << jsonText(found) << "\n";
  } else {
    std::cout << labelOf(program) << ": " << printable(file) << ", " << pixels.width << " x " << pixels.height
              << "\n";
  }
  return 0;
}

}  // namespace gluray::launcher
