#include "command_line.h"

#include <CLI/CLI.hpp>

#include <iostream>

namespace gluray::launcher {
namespace {

constexpr int kUsageError = 2;

const char* const kExamples = R"(
Examples:
  gluray glxgears
  gluray osgviewer head.obj
  gluray --report run.json -- meshlab model.ply    report what was traced when the program ends
  gluray --off osgviewer head.obj                  the real OpenGL, for comparison
  gluray --threads 4 --bvh compact paraview        four threads, least memory

`gluray run PROGRAM` is the same as `gluray PROGRAM`. The exit code is the program's;
127: program not found, 126: it cannot be executed, 2: wrong usage.)";

void addOptions(CLI::App& app, CommandLine& line) {
  app.add_option(
         "--door", line.door,
         "How calls are seen: vendor (through libglvnd), preload (LD_PRELOAD; for OSMesa and bundled\n"
         "OpenGL libraries), or auto, which picks what the program needs")
      ->check(CLI::IsMember({"auto", "vendor", "preload"}))
      ->capture_default_str();
  app.add_option("--report", line.report,
                 "Write what was traced and what was not, and why, to FILE (JSON) at exit")
      ->type_name("FILE");
  app.add_option("--threads", line.threads, "Threads that trace; 0: all cores the process may use [0]")
      ->check(CLI::Range(0, 1024))
      ->type_name("N");
  app.add_option("--bvh", line.bvh,
                 "Acceleration structures: fast (first picture soonest), full (fastest rays), compact "
                 "(least\nmemory), or auto: large ones fast at first, full as soon as those are ready [auto]")
      ->check(CLI::IsMember({"auto", "fast", "full", "compact"}));
  app.add_option("--shading", line.shading,
                 "Where lighting is evaluated: pixel, or vertex as OpenGL does, for an exact match [pixel]")
      ->check(CLI::IsMember({"pixel", "vertex"}));
  app.add_option("--renderer", line.renderer,
                 "embree, or null: trace nothing, to price the interception alone [embree]")
      ->check(CLI::IsMember({"embree", "null"}));
  app.add_flag("--off", line.off, "Pass every call through to the real OpenGL, for comparison");
  app.add_option("--config", line.config, "Read settings from FILE [~/.config/gluray/gluray.toml]")
      ->type_name("FILE");
  app.add_option("--log", line.log, "Write messages to FILE instead of stderr")->type_name("FILE");
  app.add_option("--log-level", line.logLevel, "Messages from this level on are written [warning]")
      ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error", "off"}));
}

int complain(const std::string& what) {
  std::cerr << "gluray: " << what << "; see gluray --help\n";
  return kUsageError;
}

/// Where the program begins: after "--", or at the first word that is neither an option nor an option's
/// value.
int firstProgramWord(const CLI::App& app, int argc, char** argv) {
  int i = 1;
  if (i < argc && std::string(argv[i]) == "run") ++i;
  for (; i < argc && argv[i][0] == '-'; ++i) {
    const std::string word = argv[i];
    if (word == "--") break;
    const auto* option = app.get_option_no_throw(word);
    if (option && option->get_items_expected_max() > 0)
      ++i;  // its value follows; "--door=vendor" has it inside
  }
  return std::min(i, argc);
}

}  // namespace

Parsed parse(int argc, char** argv) {
  Parsed parsed;
  CLI::App app("Runs an OpenGL program and ray traces what it draws.", "gluray");
  app.get_formatter()->label("OPTIONS", "options] [--] PROGRAM [ARGUMENTS...");
  app.footer(kExamples);
  app.set_version_flag("--version", "gluray " GLURAY_VERSION);
  app.get_formatter()->column_width(26);
  addOptions(app, parsed.commandLine);

  const int program = firstProgramWord(app, argc, argv);
  const int first = argc > 1 && std::string(argv[1]) == "run" ? 2 : 1;
  std::vector<std::string> own(argv + std::min(first, program), argv + program);
  try {
    app.parse(std::vector<std::string>(own.rbegin(), own.rend()));
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return parsed;
  } catch (const CLI::CallForVersion& version) {
    std::cout << version.what() << "\n";
    return parsed;
  } catch (const CLI::ParseError& error) {
    parsed.exitCode = complain(error.what());
    return parsed;
  }
  const bool dashes = program < argc && std::string(argv[program]) == "--";
  parsed.commandLine.program.assign(argv + program + (dashes ? 1 : 0), argv + argc);
  if (parsed.commandLine.program.empty())
    parsed.exitCode = complain("no program given");
  else
    parsed.run = true;
  return parsed;
}

}  // namespace gluray::launcher
