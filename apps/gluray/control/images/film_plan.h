// What gluray film is asked for: names of files, and settings that vary. Pure functions; any thread.
#pragma once
#include "settings/rows.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gluray::launcher {

/// Names of numbered files: "turn-%04d.png".
struct FilmName {
  std::string before, after;  // the number
  size_t digits = 1;          // at least; with leading zeros

  std::string file(int number) const;
  /// As ffmpeg takes it.
  std::string pattern() const;
};

/// Reads "turn-%04d.png", "turn-%d.png", or "turn.png", whose number goes before .png. Empty, or one line
/// that says what is wrong. `ending`: of the names.
std::string readFilmName(const std::string& text, FilmName& name, const std::string& ending = ".png");

/// A setting that varies linearly over a film.
struct Ramp {
  std::string name;
  double from = 0, to = 0;
  bool whole = false;  // the setting takes whole numbers

  /// Its value in an image; `image` from 1 to `of`.
  nlohmann::json value(int image, int of) const;
};

/// Reads "NAME=FROM..TO". Empty, or one line that says what is wrong.
std::string readRamp(const std::string& text, Ramp& ramp);

/// The command that makes a film of `images` files: a line for a shell. `odd`: their width or height is.
std::string filmCommand(const FilmName& name, int images, bool more, bool odd);

}  // namespace gluray::launcher
