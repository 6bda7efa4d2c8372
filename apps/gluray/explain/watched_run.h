// Runs a program until it has drawn enough, and collects the reports of its processes.
#pragma once
#include "command_line.h"
#include "programs/program.h"

#include <nlohmann/json.hpp>

#include <string>

namespace gluray::launcher {

/// A new folder in the system's temporary directory; the destructor removes it with its contents.
class TemporaryFolder {
 public:
  TemporaryFolder();  // throws std::runtime_error
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

struct Watch {
  int frames = 100;                            // ends the program after so many
  double restSeconds = 3, limitSeconds = 120;  // 0: never
  bool image = false;                          // takes an image of the last frame
  bool steadyClock = false;  // moves time by the frame, so that two runs show the same frames
};

struct WatchedRun {
  enum class Ending { byItself, frames, rest, limit, stopped } ending = Ending::byItself;
  int signal = 0;                       // signal that ended the program; 0: none
  int exitCode = 0;                     // of the program, if it ended by itself
  std::vector<nlohmann::json> reports;  // one a process that had a context; most frames first
};

/// Runs the program. Reports and images go to `folder`; each run needs a folder of its own.
WatchedRun watch(const CommandLine& line, const Program& program, const Watch& wish,
                 const std::string& folder);

}  // namespace gluray::launcher
