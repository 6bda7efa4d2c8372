// Makes pictures of saved scenes with the engine's library. One thread.
#pragma once
#include "pictures/picture_options.h"
#include "settings/chosen_settings.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace gluray::launcher {

struct RenderedPicture {
  int width = 0, height = 0;
  nlohmann::json facts;            // saved::SavedScene::facts
  std::vector<std::string> notes;  // what is not as in the program, a line each
  int resumedBands = 0;            // that an interrupted run had made
};

/// Makes the picture `options.file` of the scene `options.scene`, with these settings in place of the
/// scene's. `command`: what the file says of how to make it again. Throws std::runtime_error with one line;
/// what was made stays beside the file, and the next call goes on from there.
RenderedPicture renderPicture(const PictureOptions& options, const NamedValues& settings,
                              const std::string& command);

}  // namespace gluray::launcher
