// Commands that talk to running programs (set, watch ...): their words and options.
#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gluray::launcher {

struct CommandLine;
enum class Command;

/// What gluray film is given besides.
struct FilmOptions {
  int frames = 0;                  // 0: no limit
  std::vector<std::string> ramps;  // NAME=FROM..TO
  int passes = 0;                  // 0: images are taken as they are
};

/// What these commands are given.
struct ControlOptions {
  std::vector<std::string> programs;  // numbers of `gluray list`, process ids, names; empty: all
  std::vector<std::string> values;    // NAME=VALUE
  std::vector<std::string> resets;    // names of settings that go back to what the other layers say
  std::string preset;
  std::string file;  // shot, film
  FilmOptions film;
  std::vector<std::string> words;                  // pick, material, light, camera
  bool hide = false, show = false, reset = false;  // material
  std::string hideFrom;                            // material; empty: not given
  std::string hub, keyFile;                        // "HOST:PORT" and its key; empty: as the settings say
  bool live = false;   // get: ask the running programs, also where `programs` is empty
  bool state = false;  // watch: a line a second
  bool once = false;   // top: one table
  double seconds = 0;  // watch, film: ends after that time; 0: never
};

/// Whether the word names one of these commands, and which one.
bool namesControlCommand(const std::string& word, Command& command);
bool isControlCommand(Command command);

/// Adds the options and the help text of the command in `line`, unless it is not one of these commands.
bool describeControl(CLI::App& app, CommandLine& line);

/// -p, --hub and --key; without --hub where the command has the options of settings.
void addProgramOptions(CLI::App& app, ControlOptions& options, bool settingsHaveOptions);

}  // namespace gluray::launcher
