#include "pictures/repeat.h"

#include "base/printable.h"
#include "control/images/film_plan.h"
#include "pictures/picture_texts.h"
#include "say.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;

/// The command's own words. Throws if they are anything but a picture's command.
CommandLine commandIn(const std::string& text, Command wanted) {
  const char* const word = wanted == Command::shot ? "shot" : "render";
  std::optional<std::vector<std::string>> words = wordsOf(text);
  if (!words || words->size() < 2 || (*words)[0] != "gluray" ||
      ((*words)[1] != "render" && (*words)[1] != "shot"))
    throw std::runtime_error("its command is not one that makes pictures: " + text);
  if ((*words)[1] != word)
    throw std::runtime_error("gluray " + (*words)[1] + " has made it: use gluray " + (*words)[1] +
                             " --again");
  for (const char* other :
       {"--help", "-h", "--version", "--again", "--json", "--y4m", "-p", "--hub", "--hub-key"})
    for (const std::string& one : *words)
      if (one == other || one.starts_with(std::string(other) + "="))
        throw std::runtime_error("its command is not one that makes pictures: " + text);
  std::vector<char*> arguments;
  for (std::string& one : *words) arguments.push_back(one.data());
  Parsed parsed = parse(static_cast<int>(arguments.size()), arguments.data(), true);
  if (!parsed.run) throw std::runtime_error("its command is not one that makes pictures: " + text);
  return std::move(parsed.commandLine);
}

/// Where results go: the file, or the numbered ones beside it among which it is.
std::string resultOf(const std::string& given, const std::string& named) {
  FilmName name;
  if (named.find('%') == named.npos || !readFilmName(fs::path(named).filename().string(), name).empty())
    return given;
  const std::string own = fs::path(given).filename().string();
  const bool fits = own.size() >= name.before.size() + name.digits + name.after.size() &&
                    own.starts_with(name.before) && own.ends_with(name.after);
  if (!fits) throw std::runtime_error("it is not one of the pictures " + named + " any more");
  return (fs::path(given).parent_path() / fs::path(named).filename()).string();
}

/// A file of the command: as it is named, or beside the picture.
std::string foundAt(const std::string& named, const std::string& picture) {
  const fs::path beside = fs::path(picture).parent_path() / fs::path(named).filename();
  std::error_code error;
  return fs::exists(named, error) || !fs::exists(beside, error) ? named : beside.string();
}

}  // namespace

CommandLine repeated(const CommandLine& line) {
  const std::string& file = line.picture.repeat;
  const std::map<std::string, std::string> texts = textsOf(file);
  const auto textOf = [&](const char* keyword) {
    const auto found = texts.find(keyword);
    return found == texts.end() ? std::string() : found->second;
  };
  if (textOf("Command").empty() || textOf("GLuRay scene").empty())
    throw std::runtime_error(printable(file) + ": it does not say how gluray has made it");
  CommandLine again;
  try {
    again = commandIn(textOf("Command"), line.command);
    const std::string named = line.command == Command::shot ? again.control.file : again.picture.file;
    again.picture.file = again.control.file = resultOf(file, named);
  } catch (const std::exception& e) { throw std::runtime_error(printable(file + ": " + e.what())); }
  again.picture.scene = foundAt(again.picture.scene, file);
  for (std::string& path : again.picture.path) path = foundAt(path, file);
  again.picture.savedCamera =
      again.picture.savedCamera.empty() ? "" : foundAt(again.picture.savedCamera, file);
  again.picture.sceneHash = textOf("GLuRay scene"), again.picture.camerasHash = textOf("GLuRay cameras");
  again.picture.again = true;
  again.json = line.json;
  again.control.programs = line.control.programs;
  again.control.hub = line.control.hub, again.control.keyFile = line.control.keyFile;
  if (const std::string by = textOf("Software"); by != "GLuRay " GLURAY_VERSION)
    say(printable(by) + " has made it: pictures of GLuRay " GLURAY_VERSION " may differ");
  return again;
}

}  // namespace gluray::launcher
