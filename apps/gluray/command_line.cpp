#include "command_line.h"

#include "help_text.h"
#include "pictures/picture_commands.h"
#include "say.h"
#include "settings/setting_options.h"
#include "timeline/timeline_options.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <map>

namespace gluray::launcher {
namespace {

void addRunLimits(CLI::App& app, CommandLine& line) {
  app.add_option("--frames", line.frames, "End the program after N frames")
      ->check(CLI::Range(1, 1000000000))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--rest", line.restSeconds,
                 "End the program when it shows no new frame for S seconds after its first one; 0: never")
      ->check(CLI::Range(0.0, 1e6))
      ->type_name("S")
      ->capture_default_str();
  app.add_option("--seconds", line.limitSeconds, "End the program after S seconds in any case; 0: never")
      ->check(CLI::Range(0.0, 1e6))
      ->type_name("S")
      ->capture_default_str();
}

void addExplainOptions(CLI::App& app, CommandLine& line) {
  app.add_option(
         "--html", line.html,
         "Write an HTML page to FILE with the last frame with and without GLuRay, the difference, and the\n"
         "traced pixels. This runs the program a second time, without GLuRay")
      ->type_name("FILE");
  addRunLimits(app, line);
}

void addJobOption(CLI::App& app, CommandLine& line) {
  const auto take = [&line](const std::vector<std::string>& names) {
    line.job = names.empty() || names[0].empty() ? "job" : names[0];
  };
  app.add_option_function<std::vector<std::string>>(
         "--job", take, "Check the ranks and hosts of the running gluray-worker job NAME [job] instead")
      ->expected(0, 1)
      ->type_name("[NAME]");
}

void addProfileOption(CLI::App& app, CommandLine& line) {
  app.add_option("--program", line.profile, "Apply the profiles of this program")->type_name("NAME");
}

void addListOptions(CLI::App& app, CommandLine& line) {
  app.add_option("--why", line.why, "Show one setting and the value from each layer (file, environment ...)")
      ->type_name("NAME");
  app.add_flag("--all", line.all, "List advanced and expert settings, too; JSON always has all");
  app.add_flag("--changed", line.changed,
               "List all settings that do not have their built-in values, and no others");
  addProfileOption(app, line);
}

void addOptions(CLI::App& app, CommandLine& line) {
  app.add_option(
         "--door", line.door,
         "How GLuRay sees OpenGL calls: vendor (through libglvnd), preload (LD_PRELOAD; for OSMesa and\n"
         "bundled OpenGL libraries), or auto, which chooses what the program needs")
      ->check(CLI::IsMember({"auto", "vendor", "preload"}))
      ->capture_default_str();
  addSettingOptions(app, line.settings,
                    line.command == Command::explain || line.command == Command::reportBug);
  app.add_option("--config", line.config, "Read settings from FILE [~/.config/gluray/gluray.toml]")
      ->type_name("FILE");
}

int complain(const std::string& what) {
  say(what + "; see gluray --help");
  return kUsageError;
}

/// Whether the first word names a command, and which one.
bool namesCommand(int argc, char** argv, Command& command) {
  static const std::map<std::string, Command> commands = {{"run", Command::run},
                                                          {"explain", Command::explain},
                                                          {"doctor", Command::doctor},
                                                          {"quirks", Command::quirks},
                                                          {"settings", Command::settings},
                                                          {"timeline", Command::timeline},
                                                          {"get", Command::get},
                                                          {"presets", Command::presets},
                                                          {"hub", Command::hub},
                                                          {"environment", Command::environment},
                                                          {"uninstall", Command::uninstall},
                                                          {"report-bug", Command::reportBug},
                                                          {"render", Command::render},
                                                          {"view", Command::view},
                                                          {"export", Command::exportScene}};
  if (argc > 1 && namesControlCommand(argv[1], command)) return true;
  const auto found = argc > 1 ? commands.find(argv[1]) : commands.end();
  if (found == commands.end()) return false;
  command = found->second;
  return true;
}

void describeHub(CLI::App& app, CommandLine& line) {
  app.description(
      "Runs the hub that connects running programs with the commands that control them, until interrupted.\n"
      "If no hub runs, gluray panel and gluray set run one themselves.");
  app.name("gluray hub");
  auto* key = app.add_option("--key", line.hub.key, "Key file; other machines need the same one");
  key->type_name("FILE");
  app.add_option("--listen", line.hub.listen, "Also listen for other machines on this address")
      ->needs(key)
      ->type_name("HOST:PORT");
  app.add_option("--new-key", line.hub.newKey, "Write a new key to FILE and exit")->type_name("FILE");
  app.add_flag("--with-parent", line.hub.withParent,
               "Exit at the end of standard input, such as when the parent closes a pipe");
}

/// Adds the options and the help text of the command in `line`.
void describe(CLI::App& app, CommandLine& line) {
  const auto usage = [&](const char* text) { app.get_formatter()->label("OPTIONS", text); };
  if (line.command == Command::timeline) return describeTimeline(app, line);
  if (line.command == Command::hub) return describeHub(app, line);
  if (line.command == Command::render) return describeRender(app, line);
  if (line.command == Command::view) return describeView(app, line);
  if (line.command == Command::exportScene) return describeExport(app, line);
  if (line.command != Command::run && line.command != Command::panel && line.command != Command::reportBug)
    app.add_flag("--json", line.json, "Print JSON");
  if (describeControl(app, line)) return;
  switch (line.command) {
    case Command::run:
      usage("options] [--] PROGRAM [ARGUMENTS...");
      app.footer(kExamples);
      break;
    case Command::explain:
      app.description(
          "Runs an OpenGL program and prints which of its draws were traced, and why others were not.");
      app.name("gluray explain");
      usage("options] [--] PROGRAM [ARGUMENTS...");
      addExplainOptions(app, line);
      break;
    case Command::doctor:
      app.description(
          "Checks this machine and a program, or a running job of workers. Prints a line for each check, "
          "and\n"
          "a fix for each known problem.\n"
          "Exit code 0: all is well, 1: it works with limitations, 2: it will not work.");
      app.name("gluray doctor");
      usage("options] [--] [PROGRAM");
      addJobOption(app, line);
      return;
    case Command::environment:
      app.description(
          "Prints the variables that make programs run under GLuRay, as commands of a shell:\n"
          "  eval \"$(gluray environment --preset figure)\"\n"
          "Every program that the shell starts then runs under GLuRay.");
      app.name("gluray environment");
      usage("options");
      break;
    case Command::uninstall:
      app.description(
          "Lists the files of GLuRay outside its own folder: settings, results of engine = auto, and sockets "
          "of\n"
          "running programs. Prints how to remove GLuRay itself.");
      app.name("gluray uninstall");
      usage("options");
      app.add_flag("--remove", line.remove, "Remove what is listed");
      return;
    case Command::reportBug:
      app.description(
          "Writes an archive for a bug report: checks this machine, runs a program for a while, and packs "
          "the\n"
          "results. Prints the contents of the archive, and sends nothing.");
      app.name("gluray report-bug");
      usage("options] [--] [PROGRAM] [ARGUMENTS...");
      app.add_option("-o", line.archive, "Name of the archive [gluray-report.tar.gz]")
          ->type_name("FILE.tar.gz");
      addRunLimits(app, line);
      break;
    case Command::quirks:
      app.description("Lists the workarounds for particular OpenGL implementations.");
      app.name("gluray quirks");
      usage("options");
      return;
    case Command::settings:
      app.description(
          "Lists the basic settings with their values and where these come from; with --all, all settings.");
      app.name("gluray settings");
      usage("options");
      addListOptions(app, line);
      break;
    case Command::get:
      app.description(
          "Prints the settings that a program started now would have, or with -p or --live those of running\n"
          "programs.");
      app.name("gluray get");
      app.add_option("NAME", line.names, "Settings [all that differ from their built-in values]");
      app.add_flag("--why", line.layers, "Show the value from each layer (file, preset, environment ...)");
      app.add_flag("--live", line.control.live, "Print the values of all running programs");
      addProgramOptions(app, line.control, true);
      addProfileOption(app, line);
      break;
    case Command::presets:
      app.description("Lists the presets, the sets of settings for --preset NAME.");
      app.name("gluray presets");
      app.add_option("NAME", line.names, "Show the values of these presets");
      break;
    default: return;
  }
  addOptions(app, line);
  if (line.command != Command::run) return;
  addShotOptions(app, line.shots);
  addPictureOptions(app, line.picture);
}

/// Whether a program may follow the options: the others take names or a file.
bool takesProgram(Command command) {
  return command != Command::timeline && command != Command::get && command != Command::presets &&
         command != Command::hub && command != Command::render && command != Command::view &&
         command != Command::exportScene && !isControlCommand(command);
}

std::string problemOfShots(const CommandLine& line) {
  if (line.command != Command::run) return "";
  const PictureOptions& picture = line.picture;
  const bool anything = picture.anything() || picture.depth != 0 || !picture.layers.empty();
  if (line.shots.file.empty() && anything)
    return "--size, --fit, --background, --depth, --layers and --no-overlays need --shot FILE";
  return problemOf(line.shots);
}

/// Index of the program's word, from `first` on: after "--", or the first word that is neither an option
/// nor an option's value.
int firstProgramWord(const CLI::App& app, int first, int argc, char** argv) {
  int i = first;
  for (; i < argc && argv[i][0] == '-'; ++i) {
    const std::string word = argv[i];
    if (word == "--") break;
    const auto* option = app.get_option_no_throw(word);
    if (option && option->get_items_expected_max() > 0) ++i;  // skips its value; "--door=vendor" is one word
  }
  return std::min(i, argc);
}

}  // namespace

Parsed parse(int argc, char** argv, bool quiet) {
  Parsed parsed;
  CLI::App app("Runs an OpenGL program and ray traces what it draws.", "gluray");
  app.set_version_flag("--version", "gluray " GLURAY_VERSION);
  app.get_formatter()->column_width(26);
  CommandLine& line = parsed.commandLine;
  const int first = namesCommand(argc, argv, line.command) ? 2 : 1;
  describe(app, line);

  const bool runs = takesProgram(line.command);
  const int program = runs ? firstProgramWord(app, first, argc, argv) : argc;
  std::vector<std::string> own(argv + std::min(first, program), argv + program);
  try {
    app.parse(std::vector<std::string>(own.rbegin(), own.rend()));
  } catch (const CLI::CallForHelp&) {
    if (!quiet) std::cout << app.help();
    return parsed;
  } catch (const CLI::CallForVersion& version) {
    if (!quiet) std::cout << version.what() << "\n";
    return parsed;
  } catch (const CLI::ParseError& error) {
    parsed.exitCode = quiet ? kUsageError : complain(error.what());
    return parsed;
  }
  if (!runs) return parsed.run = true, parsed;
  const bool dashes = program < argc && std::string(argv[program]) == "--";
  line.program.assign(argv + program + (dashes ? 1 : 0), argv + argc);
  const bool needsProgram = line.command == Command::run || line.command == Command::explain;
  if (needsProgram && line.program.empty())
    parsed.exitCode = complain("no program given");
  else if (const std::string why = problemOfShots(line); !why.empty())
    parsed.exitCode = complain(why);
  else if (line.command == Command::quirks && !line.program.empty())
    parsed.exitCode = complain("quirks takes no program");
  else if (line.command == Command::uninstall && !line.program.empty())
    parsed.exitCode = complain("uninstall takes no program");
  else if (line.command == Command::settings && !line.program.empty())
    parsed.exitCode = complain("settings takes no program; use --program NAME");
  else if (!line.job.empty() && !line.program.empty())
    parsed.exitCode = complain("doctor checks a program or a job, not both");
  else
    parsed.run = true;
  return parsed;
}

}  // namespace gluray::launcher
