// Runs a program until it has drawn enough, and collects what its engines report.
#pragma once
#include "command_line.h"
#include "programs/program.h"

#include <nlohmann/json.hpp>

#include <string>

namespace gluray::launcher {

/// A folder in the system's place for such, removed with all that is in it.
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
  int frames = 100;                            // ended after so many
  double restSeconds = 3, limitSeconds = 120;  // 0: never
  bool picture = false;                        // of the last frame
  bool steadyClock = false;                    // two runs shall show the same frames
};

struct WatchedRun {
  enum class Ending { byItself, frames, rest, limit, stopped } ending = Ending::byItself;
  int signal = 0;                       // that ended it; 0: none
  int exitCode = 0;                     // of the program where it ended by itself
  std::vector<nlohmann::json> reports;  // of processes that had a context; most frames first
};

/// `folder` takes the reports and pictures; each run wants one of its own.
WatchedRun watch(const CommandLine& line, const Program& program, const Watch& wish,
                 const std::string& folder);

}  // namespace gluray::launcher
