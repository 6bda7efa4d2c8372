#include "control/control_options.h"

#include "command_line.h"
#include "control/scene/scene_options.h"
#include "settings/rows.h"

#include <CLI/CLI.hpp>

namespace gluray::launcher {
namespace {

struct CommandWord {
  const char* word;
  Command command;
};
constexpr CommandWord kWords[] = {
    {"list", Command::list},       {"set", Command::set},       {"unset", Command::unset},
    {"preset", Command::preset},   {"watch", Command::watch},   {"undo", Command::undo},
    {"redo", Command::redo},       {"panel", Command::panel},   {"shot", Command::shot},
    {"objects", Command::objects}, {"pick", Command::pick},     {"material", Command::material},
    {"light", Command::light},     {"camera", Command::camera}, {"film", Command::film}};

const char* wordOfCommand(Command command) {
  for (const CommandWord& known : kWords)
    if (known.command == command) return known.word;
  return nullptr;
}

void addHubOptions(CLI::App& app, ControlOptions& options, bool settingsHaveOptions) {
  const Row* row = findSetting("hub");
  const bool there = settingsHaveOptions && row && !row->option.empty();  // --hub and --hub-key
  if (!there)
    app.add_option("--hub", options.hub, "Reach the hub of another machine by TCP [setting hub]")
        ->type_name("HOST:PORT");
  app.add_option(there ? "--key" : "--key,--hub-key", options.keyFile,
                 "The file with the hub's key [setting hub-key]")
      ->type_name("FILE");
}

void describeSet(CLI::App& app, ControlOptions& options) {
  app.description("Changes settings of running programs. `gluray undo` takes it back.");
  app.add_option("SETTING", options.values,
                 "NAME=VALUE: a setting and its value; nothing after the sign means the empty text");
  app.add_option("--reset", options.resets, "Give the setting the value that files, variables ... say")
      ->allow_extra_args(false)
      ->type_name("NAME");
}

void describeWatch(CLI::App& app, CommandLine& line) {
  app.description(
      "Prints what happens in running programs: settings that change, programs that come and go. Ends with\n"
      "Ctrl+C. JSON: an object a line.");
  app.add_option("NAME", line.names, "Settings to watch; none: all");
  app.add_flag("--state", line.control.state,
               "Each second and program: frames a second, triangles, traced share, memory, noise");
  app.add_option("--seconds", line.control.seconds, "End after S seconds [never]")
      ->check(CLI::Range(0.0, 1e6))
      ->type_name("S");
}

}  // namespace

void addProgramOptions(CLI::App& app, ControlOptions& options, bool settingsHaveOptions) {
  app.add_option("-p", options.programs,
                 "A running program: its number in `gluray list`, process id, or name; may be given several\n"
                 "times [all]")
      ->allow_extra_args(false)
      ->type_name("PROGRAM");
  addHubOptions(app, options, settingsHaveOptions);
}

bool namesControlCommand(const std::string& word, Command& command) {
  for (const CommandWord& known : kWords)
    if (word == known.word) return command = known.command, true;
  return false;
}

bool isControlCommand(Command command) { return wordOfCommand(command) != nullptr; }

bool describeControl(CLI::App& app, CommandLine& line) {
  ControlOptions& options = line.control;
  if (!isControlCommand(line.command)) return false;
  app.name(std::string("gluray ") + wordOfCommand(line.command));
  app.get_formatter()->label("OPTIONS", "options");
  switch (line.command) {
    case Command::list: app.description("Lists the programs that run under GLuRay."); break;
    case Command::set: describeSet(app, options); break;
    case Command::unset:
      app.description("Gives settings of running programs the values that files, variables ... say.");
      app.add_option("NAME", options.resets, "Settings")->required();
      break;
    case Command::preset:
      app.description("Applies a preset to running programs; `gluray presets` lists them.");
      app.add_option("NAME", options.preset, "The preset's name, or none")->required();
      break;
    case Command::undo: app.description("Takes back the last change of running programs' settings."); break;
    case Command::redo: app.description("Makes the change again that was taken back last."); break;
    case Command::watch: describeWatch(app, line); break;
    case Command::panel:
      app.description("Opens a window that shows running programs and changes their settings.");
      break;
    case Command::shot:
      app.description(
          "Saves the picture that a running program's window shows. Replaces PNG files, no others.");
      app.add_option("FILE", options.file, "The picture: a name that ends in .png")->required();
      break;
    default: describeSceneCommand(app, line); break;
  }
  if (line.command == Command::list || line.command == Command::panel)
    addHubOptions(app, options, false);
  else
    addProgramOptions(app, options, false);
  return true;
}

}  // namespace gluray::launcher
