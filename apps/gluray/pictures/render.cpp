#include "pictures/render.h"

#include "base/clock.h"
#include "base/printable.h"
#include "control/images/window_image.h"
#include "pictures/rendered_picture.h"
#include "pictures/wanted_settings.h"
#include "say.h"

#include <cstdio>
#include <iostream>

namespace gluray::launcher {

int renderSaved(const CommandLine& line) {
  const PictureOptions& options = line.picture;
  if (const std::string why = whyNotInto(options.file); !why.empty()) return say(why), kUsageError;
  const double start = nowSeconds();
  const NamedValues settings = wantedSettings(line);
  const RenderedPicture picture = renderPicture(options, settings, commandOf(options, settings));
  for (const std::string& note : picture.notes) say(note);
  if (line.json) {
    std::cout << jsonText({{"file", options.file},
                           {"width", picture.width},
                           {"height", picture.height},
                           {"notes", picture.notes},
                           {"scene", picture.facts}})
              << "\n";
    return 0;
  }
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.1f", nowSeconds() - start);
  std::cout << printable(options.file) << ", " << picture.width << " x " << picture.height << ", " << seconds
            << " s" << (picture.resumedBands > 0 ? ", went on from an interrupted run" : "") << "\n";
  return 0;
}

}  // namespace gluray::launcher
