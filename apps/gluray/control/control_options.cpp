#include "control/control_options.h"

#include "command_line.h"
#include "control/scene/scene_options.h"
#include "pictures/picture_options.h"
#include "settings/rows.h"
#include "settings/setting_options.h"

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
    {"light", Command::light},     {"camera", Command::camera}, {"film", Command::film},
    {"save", Command::save},       {"top", Command::top}};

const char* wordOfCommand(Command command) {
  for (const CommandWord& known : kWords)
    if (known.command == command) return known.word;
  return nullptr;
}

void addHubOptions(CLI::App& app, ControlOptions& options, bool settingsHaveOptions) {
  const Row* row = findSetting("hub");
  const bool there = settingsHaveOptions && row && !row->option.empty();  // --hub and --hub-key
  if (!there)
    app.add_option("--hub", options.hub, "Connect by TCP to the hub on another machine [setting hub]")
        ->type_name("HOST:PORT");
  app.add_option(there ? "--key" : "--key,--hub-key", options.keyFile,
                 "File with the key of the hub [setting hub-key]")
      ->type_name("FILE");
}

void describeSet(CLI::App& app, ControlOptions& options) {
  app.description("Changes settings of running programs. `gluray undo` undoes the change.");
  app.add_option("SETTING", options.values, "NAME=VALUE: a setting and its value; NAME= sets the empty text");
  app.add_option("--reset", options.resets,
                 "Reset the setting to its value from files, variables and options")
      ->allow_extra_args(false)
      ->type_name("NAME");
}

void describeWatch(CLI::App& app, CommandLine& line) {
  app.description(
      "Prints changes of settings in running programs, and programs that start or end, until Ctrl+C.\n"
      "With --json, each line is an object.");
  app.add_option("NAME", line.names, "Settings to watch [all]");
  app.add_flag(
      "--state", line.control.state,
      "Also print frame rate, triangles, traced share, memory and noise of each program every second");
  app.add_option("--seconds", line.control.seconds, "End after S seconds [never]")
      ->check(CLI::Range(0.0, 1e6))
      ->type_name("S");
}

void describeTop(CLI::App& app, ControlOptions& options) {
  app.description(
      "Shows what running programs spend, once a second until Ctrl+C: a line for each program, or for each\n"
      "rank of an MPI program whose images workers trace. With --json, each line is an object.");
  app.add_flag("--once", options.once, "Print one table and exit");
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
      app.description(
          "Resets settings of running programs to their values from files, variables and options.");
      app.add_option("NAME", options.resets, "Settings")->required();
      break;
    case Command::preset:
      app.description("Applies a preset to running programs; `gluray presets` lists them.");
      app.add_option("NAME", options.preset, "The preset's name, or none")->required();
      break;
    case Command::undo: app.description("Undoes the last change of settings in running programs."); break;
    case Command::redo: app.description("Repeats the change that was undone last."); break;
    case Command::watch: describeWatch(app, line); break;
    case Command::top: describeTop(app, options); break;
    case Command::panel:
      app.description("Opens a window that shows running programs and changes their settings.");
      break;
    case Command::shot:
      app.description(
          "Saves the image in the window of a running program. With options, a separate process renders a\n"
          "picture of the same view in any size, with any settings. Overwrites only pictures.");
      app.add_option("FILE", options.file, "Name of the image, ending in .png or .exr");
      addPictureOptions(app, line.picture);
      addRestartOption(app, line.picture);
      addSettingOptions(app, line.settings, false);
      addRepeatOption(app, line.picture, {"FILE"});
      break;
    case Command::save:
      app.description(
          "Saves the scene that a running program shows. `gluray render` renders saved scenes (.gluray) "
          "without\n"
          "the program. Other programs read glTF 2.0, OBJ and PLY.");
      app.add_option("FILE", options.file, "Name of the file, ending in .gluray, .glb, .obj or .ply")
          ->required();
      break;
    default: describeSceneCommand(app, line); break;
  }
  if (line.command == Command::list || line.command == Command::panel)
    addHubOptions(app, options, false);
  else
    addProgramOptions(app, options, line.command == Command::shot);
  return true;
}

}  // namespace gluray::launcher
