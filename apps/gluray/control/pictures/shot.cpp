#include "control/pictures/shot.h"

#include "base/files.h"
#include "base/printable.h"
#include "control/one_program.h"
#include "control/pictures/window_picture.h"
#include "say.h"

#include <iostream>

namespace gluray::launcher {

int saveShot(const CommandLine& line) {
  const std::string file = line.control.file;
  if (const std::string why = whyNotInto(file); !why.empty()) return say(why), kUsageError;
  HubSession hub(line);
  const RunningProgram program = oneProgram(hub);
  const WindowPicture picture = labelled(program, [&] { return pictureOf(hub, program); });
  const Pixels& pixels = picture.pixels;
  if (const std::string why = files::replace(file, pngOf(pixels)); !why.empty()) return say(why), 1;
  if (line.json) {
    nlohmann::json found = named(program);
    found["frame"] = picture.frame ? nlohmann::json(*picture.frame) : nlohmann::json();
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
