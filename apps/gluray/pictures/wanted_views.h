// The views that gluray render is asked for, as the engine takes them.
#pragma once
#include "pictures/picture_options.h"
#include "saved/program/render.h"

#include <string>
#include <vector>

namespace gluray::launcher {

struct WantedViews {
  int pictures = 1;
  bool numbered = false;              // files have numbers
  std::vector<GlurayCamera> cameras;  // one a picture; empty: the saved view, or a turn about the scene
  // Among these is that of the saved view. `stated`: there is one, which somebody says is it.
  std::vector<GlurayCamera> saved;
  bool stated = false;

  /// A hash of the cameras, 32 hexadecimal digits; empty: there are none.
  std::string hash() const;
};

/// Reads the files with cameras. Throws std::runtime_error with one line.
WantedViews wantedViews(const PictureOptions& options);

}  // namespace gluray::launcher
