// What gluray film has made, and what it says of it.
#pragma once
#include "command_line.h"
#include "control/images/film_plan.h"
#include "control/images/window_image.h"
#include "control/running_program.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gluray::launcher {

struct FilmMade {
  std::vector<std::string> files;
  std::vector<std::optional<int64_t>> frames;  // of the files
  int width = 0, height = 0;                   // of the first image
  bool sameSize = true;                        // of all images
  int unfinished = 0;                          // images without the passes that were asked for
  std::string why;                             // what ended it early; empty: nothing, or the user

  void add(const std::string& file, const WindowImage& image);
  /// Of the last image; -1: there is none, or it is not known.
  int64_t lastFrame() const;
  /// Frames between those of the images.
  int64_t missed() const;
};

/// On a terminal: "3 of 20 images", over the line before.
void showProgress(int number, int of);
void clearProgress();

/// Prints what was made, as text or JSON.
void printFilm(const CommandLine& line, const RunningProgram& program, const FilmName& name,
               const FilmMade& made);

}  // namespace gluray::launcher
