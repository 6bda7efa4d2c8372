#include "capture/captured_run.h"

#include "base/printable.h"
#include "capture/scene_folder.h"
#include "control/images/film_plan.h"
#include "control/images/window_image.h"
#include "control/link/job.h"
#include "pictures/export.h"
#include "pictures/rendered_picture.h"
#include "pictures/wanted_settings.h"
#include "programs/launch.h"
#include "programs/stop_signals.h"
#include "say.h"

#include <string.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;

class Shots {
 public:
  Shots(const CommandLine& line, const SceneFolder& folder)
      : line_(line), folder_(folder), settings_(settingsOf(line)) {}

  /// Makes the next picture, if its scene is there. Returns whether one was there.
  bool makeNext() {
    const auto frame = folder_.next();
    if (!frame) return false;
    try {
      if (!frame->why.empty()) throw std::runtime_error(frame->why);
      const std::string file = fileOfShot(line_.shots, ++number_);
      make(frame->scene, file);
      say(printable(file) + ": frame " + std::to_string(frame->frame));
      ++made_;
    } catch (const std::exception& e) { complain("frame " + std::to_string(frame->frame), e.what()); }
    folder_.remove(*frame);
    return true;
  }
  int made() const { return made_; }
  bool failed() const { return failed_; }

 private:
  static NamedValues settingsOf(const CommandLine& line) {
    CommandLine own = line;
    own.settings = {};
    for (const std::string& pair : line.shots.settings) {
      const size_t sign = pair.find('=');
      own.settings.set(pair.substr(0, sign), pair.substr(sign + 1));
    }
    return wantedSettings(own);
  }
  void make(const std::string& scene, const std::string& file) {
    if (isOtherForm(file)) return note(exportScene(scene, file));
    if (file.ends_with(".gluray")) {
      std::error_code error;
      fs::rename(scene, file, error);
      if (error) throw std::runtime_error(printable(file) + " cannot be written: " + error.message());
      return;
    }
    PictureOptions options = line_.picture;
    options.file = file, options.scene = scene, options.again = true;
    PictureOptions again = options;
    again.scene = "SCENE.gluray";
    note(renderPictures(options, settings_, commandOf(again, settings_)).notes);
  }
  void note(const std::vector<std::string>& lines) {
    for (const std::string& line : lines)
      if (said_.insert(line).second) say(line);
  }
  void complain(const std::string& what, const std::string& why) {
    failed_ = true;
    if (said_.insert(why).second) say(what + ": " + why);
  }

  const CommandLine& line_;
  const SceneFolder& folder_;
  const NamedValues settings_;
  std::set<std::string> said_;
  int number_ = 0, made_ = 0;
  bool failed_ = false;
};

/// What keeps pictures from being made of these options; empty: nothing is known.
std::string whyNoPictures(const CommandLine& line) {
  const std::string file = fileOfShot(line.shots, 1);
  if (!file.ends_with(".png") && !file.ends_with(".exr")) return "";
  PictureOptions options = line.picture;
  options.file = file;
  const std::string why = whyNotOf(options);
  return why.empty() ? whyNoPictureInto(file) : why;
}

/// Why there is no picture.
std::string whyNone(const CommandLine& line, const SceneFolder& folder) {
  const auto frames = folder.frames();
  if (!frames) return "no picture: the program has shown none, or was killed; try gluray doctor PROGRAM";
  return "no picture: the program ended after " + std::to_string(*frames) +
         (*frames == 1 ? " frame" : " frames") + ", and --shot-at says " + line.shots.when;
}

}  // namespace

int runWithShots(const CommandLine& line, const Program& program) {
  if (const std::string why = whyNoPictures(line); !why.empty()) return say(why), kUsageError;
  if (control::jobOfThisProcess().ranks > 1)
    return say("--shot: scenes of MPI programs are in several processes; run one process"), kUsageError;
  const SceneFolder folder(line.shots.file);
  Shots shots(line, folder);
  const StopSignals signals;
  const std::string plan = planOf(line.shots.when) + " " + folder.path();
  Child child(line, program, [&] { setenv("GLURAY_CAPTURE", plan.c_str(), 1); });
  bool ended = false;
  while (!ended && !StopSignals::stopped()) {
    ended = child.ended();  // before the last look
    while (!StopSignals::stopped() && shots.makeNext()) {}
    if (line.shots.quit && (shots.made() > 0 || shots.failed())) break;
    if (!ended) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  child.end();
  while (shots.makeNext()) {}
  if (child.signal() != 0 && !line.shots.quit && !StopSignals::stopped())
    say("the program ended by signal " + std::to_string(child.signal()) + " (" + strsignal(child.signal()) +
        ")");
  if (shots.made() == 0 && !shots.failed()) say(whyNone(line, folder));
  const bool whole = shots.made() > 0 && !shots.failed();
  if (line.shots.quit && whole) return 0;
  return child.exitCode() != 0 ? child.exitCode() : !whole;
}

}  // namespace gluray::launcher
