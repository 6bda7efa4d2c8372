// gluray, the launcher: sets the environment so that a program's OpenGL calls go through GLuRay, and replaces
// itself by the program (exec); or runs one of the other commands, such as explain and doctor.
#include "base/files.h"
#include "capture/captured_run.h"
#include "command_line.h"
#include "control/control_commands.h"
#include "control/hub.h"
#include "control/values/live_values.h"
#include "doctor/doctor.h"
#include "doctor/probe_context.h"
#include "doctor/report_bug.h"
#include "doctor/uninstall.h"
#include "explain/explain.h"
#include "pictures/export.h"
#include "pictures/render.h"
#include "pictures/view.h"
#include "programs/environment.h"
#include "programs/launch.h"
#include "programs/program.h"
#include "programs/streams.h"
#include "say.h"
#include "settings/presets_list.h"
#include "settings/quirks_list.h"
#include "settings/settings_list.h"
#include "timeline/show_timeline.h"

#include <cerrno>
#include <cstring>
#include <exception>
#include <string>

namespace {

using namespace gluray::launcher;

int run(const CommandLine& line) {
  const Program program = inspect(line.program[0]);
  if (program.path.empty() && program.error == ENOENT) return failToStart(line.program[0], program.error);
  return line.shots.file.empty() ? becomeProgram(line, program) : runWithShots(line, program);
}

int perform(const CommandLine& line) {
  if (const std::string why = wrongPreset(line); !why.empty()) return say(why), kUsageError;
  if (int exitCode = 0; performControl(line, exitCode)) return exitCode;
  switch (line.command) {
    case Command::explain: return explain(line);
    case Command::doctor: return doctor(line);
    case Command::environment: return printEnvironment(line);
    case Command::uninstall: return uninstall(line);
    case Command::reportBug: return reportBug(line);
    case Command::quirks: return listQuirks(line);
    case Command::settings: return listSettings(line);
    case Command::get:
      return line.control.live || !line.control.programs.empty() ? getLiveSettings(line) : getSettings(line);
    case Command::presets: return listPresets(line);
    case Command::timeline: return showTimeline(line);
    case Command::hub: return runHub(line);
    case Command::render: return renderSaved(line);
    case Command::view: return viewSaved(line);
    case Command::exportScene: return exportSaved(line);
    default: return run(line);
  }
}

}  // namespace

int main(int argc, char** argv) {
  fillClosedStreams();
  gluray::files::ownStreams();
  if (argc == 3 && !std::strcmp(argv[1], kProbeWord)) return probeContext(argv[2]);
  const Parsed parsed = parse(argc, argv);
  if (!parsed.run) return parsed.exitCode;
  try {
    return perform(parsed.commandLine);
  } catch (const std::exception& e) {
    say(e.what());
    return 1;
  }
}
