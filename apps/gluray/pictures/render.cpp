#include "pictures/render.h"

#include "base/clock.h"
#include "base/printable.h"
#include "control/images/film_plan.h"
#include "control/images/window_image.h"
#include "pictures/files/video_stream.h"
#include "pictures/rendered_picture.h"
#include "pictures/repeat.h"
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

/// What does not go together; empty: nothing.
std::string whyNo(const CommandLine& line) {
  const PictureOptions& options = line.picture;
  FrameRate rate;
  if (options.video != (options.file == "-"))
    return "a film for encoders takes both: - in place of FILE, and --y4m";
  if (options.video && line.json) return "--y4m has standard output for itself: leave out --json";
  if (options.video && (options.depth > 8 || !options.layers.empty()))
    return "--y4m has 8 bits and no layers: leave out --depth and --layers";
  if (options.video && options.background == "transparent") return "--y4m has no transparency";
  return readFrameRate(options.fps, rate);
}

}  // namespace

int renderSaved(const CommandLine& line) {
  if (!line.picture.repeat.empty()) return renderSaved(repeated(line));
  const PictureOptions& options = line.picture;
  if (const std::string why = whyNo(line); !why.empty()) return say(why), kUsageError;
  const WantedViews views = wantedViews(options);
  for (const std::string& file : filesOf(options, views))
    if (const std::string why = whyNoPictureInto(file); !why.empty()) return say(why), kUsageError;
  if (const std::string why = whyNotOf(options); !why.empty()) return say(why), kUsageError;
  const double start = nowSeconds();
  const NamedValues settings = wantedSettings(line);
  const RenderedPicture made = renderPictures(options, settings, commandOf(options, settings), views);
  for (const std::string& note : made.notes) say(note);
  if (options.video) return 0;
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
  if (made.files.size() > 1 && readFilmName(options.file, name).empty())
    std::cout << "As a film: "
              << filmCommand(name, views.pictures, false, made.width % 2 != 0 || made.height % 2 != 0)
              << "\n";
  return 0;
}

}  // namespace gluray::launcher
