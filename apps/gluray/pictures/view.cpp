#include "pictures/view.h"

#include "base/printable.h"
#include "control/panel.h"
#include "pictures/wanted_settings.h"
#include "programs/doors.h"
#include "say.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

namespace gluray::launcher {

int viewSaved(const CommandLine& line) {
  const std::string& scene = line.picture.scene;
  if (isOtherForm(scene))
    return say(printable(scene) +
               ": gluray view shows files that end in .gluray; the others are for other programs"),
           1;
  if (access(scene.c_str(), R_OK) != 0) return say(printable(scene) + ": " + std::strerror(errno)), 1;
  wantedSettings(line);  // complains of wrong ones
  std::vector<std::string> words{"--view", libraryDirectory() + "/libgluray-engine.so", launcherFile(),
                                 scene};
  for (const auto& [name, value] : line.settings.all()) {
    const bool named = name == "preset" || name == "quality";
    if (named && value == "none") continue;
    words.push_back(named ? "--" + name : "--set");
    words.push_back(named ? value : name + "=" + value);
  }
  return becomePanel(std::move(words));
}

}  // namespace gluray::launcher
