#include "control/images/film_text.h"

#include "base/printable.h"
#include "control/one_program.h"
#include "say.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace gluray::launcher {
namespace {

using nlohmann::json;

std::string countedImages(size_t count) {
  return std::to_string(count) + (count == 1 ? " image" : " images");
}

json filmAsJson(const RunningProgram& program, const FilmMade& made) {
  json all = named(program), frames = json::array();
  for (const auto& frame : made.frames) frames.push_back(frame ? json(*frame) : json());
  all["files"] = made.files, all["frames"] = frames, all["missed"] = made.missed();
  all["unfinished"] = made.unfinished;
  if (!made.why.empty()) all["why"] = made.why;
  return all;
}

std::string filmAsText(const FilmMade& made) {
  std::string text = countedImages(made.files.size());
  if (made.files.empty()) return text;
  text += ", " + printable(made.files.front());
  if (made.files.size() > 1) text += " to " + printable(made.files.back());
  text += ", " + std::to_string(made.width) + " x " + std::to_string(made.height);
  if (const int64_t missed = made.missed(); missed > 0)
    text += "; " + std::to_string(missed) + (missed == 1 ? " frame" : " frames") + " between them missed";
  if (made.unfinished > 0)
    text += "; " + countedImages(static_cast<size_t>(made.unfinished)) + " with fewer new passes";
  return text;
}

}  // namespace

void FilmMade::add(const std::string& file, const WindowImage& image) {
  const Pixels& pixels = image.pixels;
  if (files.empty()) width = pixels.width, height = pixels.height;
  sameSize = sameSize && width == pixels.width && height == pixels.height;
  files.push_back(file);
  frames.push_back(image.frame);
}

int64_t FilmMade::lastFrame() const { return frames.empty() ? -1 : frames.back().value_or(-1); }

int64_t FilmMade::missed() const {
  int64_t missed = 0;
  for (size_t i = 1; i < frames.size(); ++i)
    if (frames[i] && frames[i - 1]) missed += std::max<int64_t>(*frames[i] - *frames[i - 1] - 1, 0);
  return missed;
}

void showProgress(int number, int of) {
  if (isatty(STDERR_FILENO) != 1) return;
  std::cerr << "\r\x1b[K" << number << (of > 0 ? " of " + std::to_string(of) : "") << " images" << std::flush;
}

void clearProgress() {
  if (isatty(STDERR_FILENO) == 1) std::cerr << "\r\x1b[K" << std::flush;
}

void printFilm(const CommandLine& line, const RunningProgram& program, const FilmName& name,
               const FilmMade& made) {
  if (line.json) {
    std::cout << jsonText(filmAsJson(program, made)) << "\n";
    return;
  }
  const int count = static_cast<int>(made.files.size());
  std::cout << labelOf(program) << ": " << filmAsText(made) << "\n";
  if (count < 2 || !made.sameSize) return;
  std::error_code error;
  const bool more = std::filesystem::exists(name.file(count + 1), error);  // of an earlier film
  const bool odd = made.width % 2 != 0 || made.height % 2 != 0;
  std::cout << "As a film: " << printable(filmCommand(name, count, more, odd)) << "\n";
}

}  // namespace gluray::launcher
