#include "explain/explain.h"

#include "base/files.h"
#include "base/printable.h"
#include "explain/explanation_text.h"
#include "explain/html_page.h"
#include "explain/watched_run.h"
#include "programs/doors.h"
#include "programs/launch.h"
#include "say.h"

#include <string.h>

#include <iostream>
#include <stdexcept>

namespace gluray::launcher {
namespace {

using nlohmann::json;

std::string commandOf(const CommandLine& line) {
  std::string text;
  for (const std::string& word : line.program) text.append(text.empty() ? "" : " ").append(word);
  return text;
}

std::string endingText(const WatchedRun& run, const CommandLine& line) {
  switch (run.ending) {
    case WatchedRun::Ending::frames: return "ended after " + std::to_string(line.frames) + " frames";
    case WatchedRun::Ending::rest: return "ended at rest: it drew nothing new";
    case WatchedRun::Ending::limit: return "ended by its time limit";
    case WatchedRun::Ending::stopped: return "ended by a signal to gluray";
    default: break;
  }
  if (run.signal != 0)
    return "it ended by signal " + std::to_string(run.signal) + " (" + strsignal(run.signal) + ")";
  return "it ended by itself, with exit code " + std::to_string(run.exitCode);
}

/// The image from the process that showed most frames, of those that have one.
const json* imageOf(const WatchedRun& run) {
  for (const json& report : run.reports)
    if (report["explain"]["picture"].is_object()) return &report["explain"]["picture"];
  return nullptr;
}

/// Whether no double-buffered context swapped: then glFlush and glFinish end the frames, which GLuRay sees
/// only where calls pass through it.
bool neverSwapped(const WatchedRun& run) {
  for (const json& report : run.reports)
    for (const json& context : report["explain"]["contexts"])
      if (context["doubleBuffered"].get<bool>() && context["swaps"].get<bool>()) return false;
  return true;
}

Pixels readImage(const json& image, const char* suffix) {
  const std::string path = image["file"].get<std::string>() + suffix;
  std::optional<Pixels> pixels = readNetpbm(path);
  if (!pixels) throw std::runtime_error("cannot read the image " + path);
  return *pixels;
}

/// Runs the program without GLuRay until it has shown the same frame.
FrameImages withAndWithout(const CommandLine& line, const Program& program, const WatchedRun& run,
                           const json& image) {
  FrameImages images;
  images.with = readImage(image, ".ppm");
  images.origin = readImage(image, ".origin.pgm");
  images.perPixel = sessionOf(line).settings.shading != ShadingRate::vertex;
  images.frame = image["frame"], images.elsewhere = image["elsewhere"];
  CommandLine plain = line;
  if (neverSwapped(run))
    plain.settings.set("engine", "never");
  else
    plain.settings.set("off", "1");
  Watch wish{static_cast<int>(images.frame), line.restSeconds, line.limitSeconds, true, true};
  // Two runs may come to rest after different numbers of frames, because window events arrive differently.
  if (run.ending != WatchedRun::Ending::frames) wish.frames = line.frames;
  const TemporaryFolder folder;
  const WatchedRun second = watch(plain, program, wish, folder.path());

  if (const json* found = imageOf(second)) {
    images.without = readImage(*found, ".ppm");
    images.frameWithout = (*found)["frame"];
    images.atRest = images.frame != images.frameWithout;
  }
  return images;
}

/// Writes the page; returns its numbers.
json makePage(const CommandLine& line, const Program& program, const WatchedRun& run,
              const std::string& text) {
  const json* image = imageOf(run);
  if (!image) throw std::runtime_error("no page: the program showed no frame");
  const FrameImages images = withAndWithout(line, program, run, *image);
  writeFile(line.html, htmlPage(commandOf(line), text, images));
  return imageFacts(images);
}

std::string textOf(const WatchedRun& run, const CommandLine& line) {
  std::string text;
  for (const json& report : run.reports)
    text.append(text.empty() ? "" : "\n").append(explanationText(report));
  return text + "\n" + endingText(run, line) + "\n";
}

}  // namespace

int explain(const CommandLine& line) {
  const Program program = inspect(line.program[0]);
  if (program.path.empty()) return failToStart(line.program[0], program.error);
  const TemporaryFolder folder;
  const Watch wish{line.frames, line.restSeconds, line.limitSeconds, !line.html.empty(), !line.html.empty()};
  const WatchedRun run = watch(line, program, wish, folder.path());
  if (run.reports.empty()) {
    if (run.ending == WatchedRun::Ending::byItself && run.exitCode >= kNotExecutable &&
        run.exitCode <= kNotFound)
      return run.exitCode;
    if (!shortAddressSpace().empty()) return 1;  // said when the program was started
    say(line.program[0] + " showed no frame of an OpenGL context that GLuRay could see (" +
        endingText(run, line) + "); try: gluray doctor " + line.program[0]);
    return 1;
  }
  const std::string text = textOf(run, line);
  // If the page goes to standard output, everything else goes to standard error.
  const bool pageIsOut = files::isOutput(line.html);
  if (!line.json) (pageIsOut ? std::cerr : std::cout) << text << std::flush;
  json all = {{"command", line.program}, {"ending", endingText(run, line)}, {"processes", run.reports}};
  if (!line.html.empty()) {
    all["page"] = makePage(line, program, run, text);
    if (!line.json && !pageIsOut) std::cout << "the page is " << printable(line.html) << "\n";
  }
  if (line.json) (pageIsOut ? std::cerr : std::cout) << jsonText(all) << "\n";
  return 0;
}

}  // namespace gluray::launcher
