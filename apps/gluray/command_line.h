// The launcher's command line, parsed.
#pragma once
#include "capture/shot_options.h"
#include "control/control_options.h"
#include "pictures/picture_options.h"
#include "settings/chosen_settings.h"

#include <string>
#include <vector>

namespace gluray::launcher {

inline constexpr int kUsageError = 2;  // exit code: what the user typed is wrong

enum class Command {
  run,
  explain,
  doctor,
  quirks,
  environment,
  uninstall,
  reportBug,
  settings,
  get,
  presets,
  timeline,
  hub,
  list,
  set,
  unset,
  preset,
  watch,
  top,
  undo,
  redo,
  panel,
  shot,
  objects,
  pick,
  material,
  light,
  camera,
  film,
  save,
  render,
  view,
  exportScene
};

/// Options of gluray hub; empty: not given.
struct HubLine {
  std::string listen, key, newKey;  // HOST:PORT, files
  bool withParent = false;          // ends when standard input does
};

struct CommandLine {
  Command command = Command::run;
  std::vector<std::string> program;  // name and arguments
  std::string door = "auto";         // auto, vendor, preload
  std::string config;                // file; empty: the usual one
  ChosenSettings settings;

  ControlOptions control;  // get, and commands for running programs
  HubLine hub;
  PictureOptions picture;  // render, shot, run
  ShotOptions shots;       // run

  bool json = false;    // all but run and timeline
  bool remove = false;  // uninstall
  std::string archive;  // report-bug: file; empty: gluray-report.tar.gz
  std::string job;      // doctor: of workers; empty: none is checked
  // explain
  int frames = 100;
  double restSeconds = 3, limitSeconds = 120;  // 0: never
  std::string html;                            // file; empty: none
  // settings, get, presets, watch
  std::string why, profile;        // a setting, a program; empty: none
  bool all = false;                // settings of every level
  bool changed = false;            // only settings that differ from their built-in values
  std::vector<std::string> names;  // of settings or presets
  bool layers = false;             // each layer's value
  // timeline; its file is in `program`
  std::string chart;          // file; empty: none
  double from = -1, to = -1;  // close-up view, milliseconds; negative: some frames in the middle of the run
};

/// Result of parsing: a command to run, or (`run` false) the exit code after help or an error was printed.
struct Parsed {
  CommandLine commandLine;
  bool run = false;
  int exitCode = 0;
};

/// `quiet`: prints nothing.
Parsed parse(int argc, char** argv, bool quiet = false);

}  // namespace gluray::launcher
