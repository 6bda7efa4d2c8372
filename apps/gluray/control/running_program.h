// Programs under GLuRay, as the hub lists them, and how users name them.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace gluray::launcher {

struct RunningProgram {
  int64_t number = 0, pid = 0;
  std::string name, host;
  int64_t ranks = 1;
  double since = 0;  // seconds since 1970
};

/// From the member `programs` of an untrusted message. Entries without a number are left out.
std::vector<RunningProgram> programsOf(const nlohmann::json& message);

/// Whether it runs on another machine.
bool runsElsewhere(const RunningProgram& program);

/// "paraview (4242)"; "paraview (4242 on node7)" for another machine's.
std::string labelOf(const RunningProgram& program);

/// Whether there is a program, and one for each word.
bool areThere(const std::vector<RunningProgram>& all, const std::vector<std::string>& words);

/// Those that the words name: numbers, process ids, names; none, or "all": all of them. Throws
/// std::runtime_error with one line where a word names none.
std::vector<RunningProgram> chosenPrograms(const std::vector<RunningProgram>& all,
                                           const std::vector<std::string>& words);

/// Whether one of the words names the program; of no words, true.
bool isChosen(const RunningProgram& program, const std::vector<std::string>& words);

/// Their numbers, for requests.
nlohmann::json numbersOf(const std::vector<RunningProgram>& programs);

}  // namespace gluray::launcher
