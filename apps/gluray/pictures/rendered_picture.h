// Makes pictures of saved scenes with the engine's library. One thread.
#pragma once
#include "pictures/picture_options.h"
#include "pictures/wanted_views.h"
#include "settings/chosen_settings.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace gluray::launcher {

/// Pictures of one size.
struct RenderedPicture {
  std::vector<std::string> files;
  int width = 0, height = 0;
  nlohmann::json facts;            // saved::SavedScene::facts
  std::vector<std::string> notes;  // what is not as in the program, a line each
  bool resumed = false;            // where an interrupted run had ended
};

/// The files that are asked for: one, or numbered ones of a film; of streams none. Throws std::runtime_error
/// with one line.
std::vector<std::string> filesOf(const PictureOptions& options, const WantedViews& views);

/// Makes pictures of the scene `options.scene`, with these settings in place of the scene's. `command`: what
/// the files say of how to make them again. Throws std::runtime_error with one line; what was made stays, and
/// the next call goes on from there. A stream begins anew.
RenderedPicture renderPictures(const PictureOptions& options, const NamedValues& settings,
                               const std::string& command, const WantedViews& views = {});

}  // namespace gluray::launcher
