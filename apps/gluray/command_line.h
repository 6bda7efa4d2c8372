// What the user typed.
#pragma once
#include <string>
#include <vector>

namespace gluray::launcher {

enum class Command { run, explain, doctor, quirks, timeline };

struct CommandLine {
  Command command = Command::run;
  std::vector<std::string> program;  // name and arguments
  std::string door = "auto";         // auto, vendor, preload
  std::string config, report, timeline, log, logLevel, threads, engine, bvh, shading, renderer, spp,
      lag;                                   // empty: not given
  std::vector<std::string> quirks;           // NAME=on|off
  std::vector<std::string> programFamilies;  // files
  bool off = false, hud = false;

  // explain, doctor, quirks
  bool json = false;
  // explain
  int frames = 100;
  double restSeconds = 3, limitSeconds = 120;  // 0: never
  std::string html;                            // file; empty: none
  // timeline; its file is in `program`
  std::string chart;          // file; empty: none
  double from = -1, to = -1;  // milliseconds, of the near view; negative: some frames of the middle
};

/// Result of parsing: either something to run, or an exit code after the user was told.
struct Parsed {
  CommandLine commandLine;
  bool run = false;
  int exitCode = 0;
};

Parsed parse(int argc, char** argv);

}  // namespace gluray::launcher
