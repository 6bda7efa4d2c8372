#include "control/images/shot.h"

#include "base/files.h"
#include "base/printable.h"
#include "control/images/save.h"
#include "control/images/window_image.h"
#include "control/one_program.h"
#include "pictures/rendered_picture.h"
#include "pictures/repeat.h"
#include "pictures/wanted_settings.h"
#include "say.h"

#include <unistd.h>

#include <filesystem>
#include <iostream>

namespace gluray::launcher {
namespace {

/// A picture of the scene that the program shows, in its own size and with its own settings.
RenderedPicture pictureOf(HubSession& hub, const RunningProgram& program, const CommandLine& line) {
  PictureOptions options = line.picture;
  options.file = line.control.file;
  options.scene = options.file + ".scene-" + std::to_string(getpid());
  struct Remove {
    std::string file;
    ~Remove() {
      std::error_code error;
      std::filesystem::remove(file, error);
    }
  } const remove{options.scene};
  const NamedValues settings = wantedSettings(line);
  saveScene(hub, program, options.scene);
  // An interrupted shot is of a scene that is gone.
  options.again = true;
  PictureOptions again = options;
  again.scene.clear();
  return renderPictures(options, settings, commandOf(again, settings));
}

/// What was saved, for people or programs.
void tell(const CommandLine& line, const RunningProgram& program, nlohmann::json found) {
  found["file"] = line.control.file;
  if (!line.json) {
    std::cout << labelOf(program) << ": " << printable(line.control.file) << ", " << found["width"] << " x "
              << found["height"] << "\n";
    return;
  }
  found.update(named(program));
  std::cout << jsonText(found) << "\n";
}

}  // namespace

int saveShot(const CommandLine& line) {
  if (!line.picture.repeat.empty()) return saveShot(repeated(line));
  const std::string file = line.control.file;
  PictureOptions options = line.picture;
  options.file = file;
  for (const std::string& why : {whyNoPictureInto(file), whyNotOf(options)})
    if (!why.empty()) return say(why), kUsageError;
  HubSession hub(line);
  const RunningProgram program = oneProgram(hub);
  if (options.anything() || !line.settings.all().empty() || !line.picture.sceneHash.empty()) {
    const RenderedPicture picture = labelled(program, [&] { return pictureOf(hub, program, line); });
    for (const std::string& note : picture.notes) say(note);
    tell(line, program, {{"width", picture.width}, {"height", picture.height}, {"notes", picture.notes}});
    return 0;
  }
  const WindowImage image = labelled(program, [&] { return imageOf(hub, program); });
  const Pixels& pixels = image.pixels;
  if (const std::string why = files::replace(file, pngOf(pixels)); !why.empty()) return say(why), 1;
  tell(line, program,
       {{"frame", image.frame ? nlohmann::json(*image.frame) : nlohmann::json()},
        {"width", pixels.width},
        {"height", pixels.height}});
  return 0;
}

}  // namespace gluray::launcher
