#include "pictures/render.h"

#include "base/clock.h"
#include "base/printable.h"
#include "control/images/film_plan.h"
#include "control/images/window_image.h"
#include "pictures/rendered_picture.h"
#include "pictures/wanted_settings.h"
#include "say.h"

#include <cstdio>
#include <iostream>

namespace gluray::launcher {

namespace {

/// "turn-0001.png to turn-0090.png, 90 pictures", or the file.
std::string namesOf(const RenderedPicture& made) {
  if (made.files.size() == 1) return printable(made.files.front());
  return printable(made.files.front()) + " to " + printable(made.files.back()) + ", " +
         std::to_string(made.files.size()) + " pictures";
}

}  // namespace

int renderSaved(const CommandLine& line) {
  const PictureOptions& options = line.picture;
  for (const std::string& file : filesOf(options))
    if (const std::string why = whyNoPictureInto(file); !why.empty()) return say(why), kUsageError;
  if (const std::string why = whyNotOf(options); !why.empty()) return say(why), kUsageError;
  const double start = nowSeconds();
  const NamedValues settings = wantedSettings(line);
  const RenderedPicture made = renderPictures(options, settings, commandOf(options, settings));
  for (const std::string& note : made.notes) say(note);
  if (line.json) {
    std::cout << jsonText({{"files", made.files},
                           {"width", made.width},
                           {"height", made.height},
                           {"notes", made.notes},
                           {"scene", made.facts}})
              << "\n";
    return 0;
  }
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.1f", nowSeconds() - start);
  std::cout << namesOf(made) << ", " << made.width << " x " << made.height << ", " << seconds << " s"
            << (made.resumed ? ", went on from an interrupted run" : "") << "\n";
  FilmName name;
  if (options.turntable > 1 && readFilmName(options.file, name).empty())
    std::cout << "As a film: "
              << filmCommand(name, options.turntable, false, made.width % 2 != 0 || made.height % 2 != 0)
              << "\n";
  return 0;
}

}  // namespace gluray::launcher
