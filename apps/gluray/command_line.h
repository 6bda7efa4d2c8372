// What the user typed.
#pragma once
#include <string>
#include <vector>

namespace gluray::launcher {

struct CommandLine {
  std::vector<std::string> program;                                            // name and arguments
  std::string door = "auto";                                                   // auto, vendor, preload
  std::string config, report, log, logLevel, threads, bvh, shading, renderer;  // empty: not given
  bool off = false;
};

/// Result of parsing: either something to run, or an exit code after the user was told.
struct Parsed {
  CommandLine commandLine;
  bool run = false;
  int exitCode = 0;
};

Parsed parse(int argc, char** argv);

}  // namespace gluray::launcher
