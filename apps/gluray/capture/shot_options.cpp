#include "capture/shot_options.h"

#include "base/number_text.h"
#include "base/printable.h"
#include "control/images/film_plan.h"
#include "pictures/picture_options.h"
#include "settings/setting_options.h"

#include <CLI/CLI.hpp>

#include <stdexcept>
#include <string_view>

namespace gluray::launcher {
namespace {

constexpr std::string_view kPng = ".png", kExr = ".exr", kScene = ".gluray";

bool isCount(std::string_view text) {
  uint64_t count = 0;
  return readNumber(text, count) && count > 0;
}

std::string endingOf(const std::string& file) {
  const size_t dot = file.rfind('.');
  return dot == file.npos || dot < file.rfind('/') + 1 ? "" : file.substr(dot);
}

}  // namespace

std::string planOf(const std::string& when) {
  const std::string_view text = when;
  if (when == "idle") return when;
  if (when == "every") return "every:1";
  if (when.starts_with("every:") && isCount(text.substr(6))) return when;
  if (isCount(text)) return "frame:" + when;
  double seconds = 0;
  if (text.ends_with('s') && readNumber(text.substr(0, text.size() - 1), seconds) && seconds >= 0)
    return "seconds:" + when.substr(0, when.size() - 1);
  throw std::runtime_error(
      "--shot-at " + when +
      ": use a frame's number such as 100, a time such as 2.5s, idle, every or every:10");
}

std::string fileOfShot(const ShotOptions& options, int number) {
  if (!options.isSequence()) return options.file;
  FilmName name;
  if (const std::string why = readFilmName(options.file, name, endingOf(options.file)); !why.empty())
    throw std::runtime_error(why);
  return name.file(number);
}

std::string problemOf(const ShotOptions& options) {
  if (options.file.empty()) {
    if (options.when == "idle" && !options.quit && options.settings.empty()) return "";
    return "--shot-at, --shot-set and --quit need --shot FILE";
  }
  const std::string ending = endingOf(options.file);
  const bool hasName = options.file.size() > options.file.rfind('/') + 1 + ending.size();
  if (!hasName || (ending != kPng && ending != kExr && ending != kScene && !isOtherForm(options.file)))
    return printable(options.file) + ": use a name that ends in .png, .exr, .gluray, .glb, .obj or .ply";
  if (options.quit && options.isSequence()) return "--quit: a sequence of pictures ends with the program";
  for (const std::string& pair : options.settings)
    if (std::string why = problemOfPair(pair); !why.empty()) return why;
  try {
    planOf(options.when);
    fileOfShot(options, 1);
  } catch (const std::runtime_error& e) { return e.what(); }
  return "";
}

void addShotOptions(CLI::App& app, ShotOptions& options) {
  app.add_option(
         "--shot", options.file,
         "Save what the program shows as a picture (.png, .exr) or as a scene (.gluray, .glb, .obj, .ply).\n"
         "For a sequence, FILE is a pattern such as step-%04d.png")
      ->type_name("FILE");
  app.add_option(
         "--shot-at", options.when,
         "When to take the picture: at a frame number, at a time such as 2.5s, at idle (the program is idle\n"
         "or ends), at every frame, or at every:K, each Kth frame. In programs without a window, each\n"
         "image that the program reads is a frame")
      ->type_name("WHEN")
      ->capture_default_str();
  app.add_option("--shot-set", options.settings, "A setting for the pictures only, such as quality=final")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_flag("--quit", options.quit, "End the program after the picture is taken");
}

}  // namespace gluray::launcher
