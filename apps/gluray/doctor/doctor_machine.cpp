#include "doctor/doctor_machine.h"

#include "base/processes/usable_cores.h"
#include "doctor/host.h"
#include "doctor/probe_context.h"
#include "explain/watched_run.h"
#include "programs/doors.h"
#include "programs/library_walk.h"
#include "programs/program.h"
#include "settings/layers/settings_layers.h"
#include "text_table.h"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct InstalledFile {
  const char* name;
  Health without;
  const char* use;
};
constexpr InstalledFile kFiles[] = {
    {"libgluray-engine.so", Health::broken, "nothing can be traced"},
    {"libGLX_gluray.so.0", Health::broken, "GLX programs cannot be traced"},
    {"libEGL_gluray.so.0", Health::limited, "EGL programs cannot be traced"},
    {"gluray_egl.json", Health::limited, "EGL programs cannot be traced"},
    {"libgluray.so", Health::limited,
     "--door preload has no effect, so programs with OSMesa or a bundled OpenGL cannot be traced"},
    {"libgluray-clock.so", Health::limited, "gluray explain --html cannot show the same frame twice"},
};

/// Exit code and output of a child process.
struct Said {
  int status = -1;  // exit code; -1: killed, crashed, or never started
  bool late = false;
  std::string out, errors;
};

/// Runs the probe (probe_context.h) as a child of this process, through GLuRay.
Said runProbe(const CommandLine& given, const std::string& api, const std::string& folder) {
  constexpr int kPatienceMs = 20000;
  int out[2], errors[2];
  Said said;
  if (pipe(out) != 0) return said;
  if (pipe(errors) != 0) return close(out[0]), close(out[1]), said;
  const pid_t child = fork();
  if (child == 0) {
    dup2(out[1], STDOUT_FILENO), dup2(errors[1], STDERR_FILENO);
    for (const int end : {out[0], out[1], errors[0], errors[1]}) close(end);
    CommandLine line = given;
    line.settings.set("report", folder + "/report.json");
    line.settings.remove("off");
    line.settings.set("engine", "always");  // the image is so small that `auto` would not trace it
    if (const std::string why = openDoors(line, Program{}); !why.empty())
      dprintf(STDERR_FILENO, "gluray: not ray traced: %s\n", why.c_str());
    setenv("GLURAY_EXPLAIN", "1000", 1);
    execl(launcherFile().c_str(), "gluray", kProbeWord, api.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  close(out[1]), close(errors[1]);
  pollfd ends[2] = {{out[0], POLLIN, 0}, {errors[0], POLLIN, 0}};
  std::string* texts[2] = {&said.out, &said.errors};
  while (child > 0 && (ends[0].fd >= 0 || ends[1].fd >= 0)) {
    if (poll(ends, 2, kPatienceMs) <= 0) {
      said.late = true;
      break;
    }
    for (int i = 0; i < 2; ++i) {
      if (ends[i].fd < 0 || !ends[i].revents) continue;
      char buffer[4096];
      const ssize_t bytes = read(ends[i].fd, buffer, sizeof buffer);
      if (bytes > 0)
        texts[i]->append(buffer, static_cast<size_t>(bytes));
      else
        ends[i].fd = -1;
    }
  }
  close(out[0]), close(errors[0]);
  if (child <= 0) return said;
  if (said.late) kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && !said.late) said.status = WEXITSTATUS(status);
  return said;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

json readReport(const std::string& folder) {
  std::ifstream file(folder + "/report.json");
  return json::parse(file, nullptr, /*allow_exceptions=*/false);
}

std::string librariesText(const json& files) {
  std::string text;
  for (const json& file : files) text += (text.empty() ? "" : ", ") + file.get<std::string>();
  return text;
}

void reportTracer(const json& report, Diagnosis& diagnosis) {
  const json& machine = report["explain"]["machine"];
  const std::string problem = machine["problem"];
  if (!problem.empty()) return diagnosis.broken("ray tracer", problem);
  diagnosis.ok("ray tracer", "Embree " + machine["embree"].get<std::string>() + " with packets of " +
                                 std::to_string(machine["rayPacket"].get<int>()) + " rays, TBB " +
                                 machine["tbb"].get<std::string>() + ", shading for " +
                                 machine["kernels"].get<std::string>() + ", " +
                                 std::to_string(machine["threads"].get<int>()) + " threads");
  diagnosis.ok("ray tracer", "loaded from " + librariesText(machine["libraries"]));
}

std::string rasterReason(const json& report) {
  std::string reasons;
  for (const auto& [reason, count] : report["draws"]["rasterised"].items())
    reasons += (reasons.empty() ? "" : ", ") + reason;
  return reasons.empty() ? "GLuRay saw no draw" : reasons;
}

void reportImage(const json& report, Diagnosis& diagnosis) {
  if (report["triangles"]["traced"].get<uint64_t>() > 0)
    diagnosis.ok("test image", "traced, through the door " + report["door"].get<std::string>());
  else
    diagnosis.broken("test image", "not traced: " + rasterReason(report));
}

void reportWay(const json& report, Diagnosis& diagnosis) {
  const std::string driver = report.value("walkedPast", std::string());
  if (!driver.empty())
    diagnosis.limited("door",
                      "bypassed: the dynamic linker finds the driver's gl functions first (" + driver +
                          "), so plug-ins call the driver, GLuRay does not see these calls, and images "
                          "may be wrong",
                      "remove the driver from LD_PRELOAD, or try --door preload");
}

/// Says who draws by default (settings: engine).
void reportRenderer(const std::string& topic, const json& report, Diagnosis& diagnosis) {
  const bool software = report["gl"].value("software", true);
  diagnosis.ok(topic, software ? "renders on the CPU: large scenes are ray traced"
                               : "renders in hardware: it draws everything until an effect of light is on "
                                 "(gluray --set ao=on), or frames prove that ray tracing is faster");
}

/// Reports what the probe printed and the engine's report of it; `api` is "glx" or "egl".
void reportProbe(const std::string& api, const Said& said, const std::string& folder, Diagnosis& diagnosis) {
  const std::string topic = api == "glx" ? "OpenGL (GLX)" : "OpenGL (EGL)";
  const std::vector<std::string> complaints = linesOf(said.errors), words = linesOf(said.out);
  if (said.late) return diagnosis.broken(topic, "hangs: no output for 20 seconds");
  if (said.status != 0) {
    const std::string why = complaints.empty() ? "the test program crashed" : complaints.back();
    return diagnosis.broken(topic, why, adviceForOpenGl(api, thisHost()));
  }
  if (words.size() >= 3) diagnosis.ok(topic, words[0] + ", " + words[1] + ", " + words[2]);
  bool explained = false;
  for (const std::string& complaint : complaints)
    if (complaint.starts_with("gluray: ")) diagnosis.broken("engine", complaint.substr(8)), explained = true;
  const json report = readReport(folder);
  if (!report.is_object() || !report.contains("explain")) {
    if (!explained) diagnosis.broken("engine", "OpenGL works, but GLuRay saw no context of the test program");
    return;
  }
  reportRenderer(topic, report, diagnosis);
  reportTracer(report, diagnosis);
  reportImage(report, diagnosis);
  reportWay(report, diagnosis);
}

double gigabytes(const std::string& name) {
  std::ifstream file("/proc/meminfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(name + ":")) return std::atof(line.c_str() + name.size() + 1) / (1024.0 * 1024.0);
  return 0;
}

/// How many threads trace, and what decides it.
std::string threadsText(const Surroundings& here) {
  const int wanted = readLayers(sourcesOfProcess(), [](const std::string&) {}).session.settings.threads;
  const ThreadCount chosen = chosenThreads(wanted, here);
  return std::to_string(chosen.threads) + (chosen.threads == 1 ? " thread traces: " : " threads trace: ") +
         chosen.because;
}

}  // namespace

bool examineInstall(Diagnosis& diagnosis) {
  const std::string directory = libraryDirectory();
  if (directory.empty()) {
    diagnosis.broken("install", "GLuRay's libraries are missing beside " + launcherFile(),
                     "install GLuRay again");
    return false;
  }
  const Host host = thisHost();
  const Installed how = howInstalled(directory);
  const Health before = static_cast<Health>(diagnosis.exitCode());
  for (const InstalledFile& file : kFiles) {
    std::error_code ignored;
    if (!fs::exists(directory + "/" + file.name, ignored))
      diagnosis.add({file.without, "install", directory + "/" + file.name + " is missing: " + file.use,
                     adviceToReinstall(how, host)});
  }
  const std::string engine = directory + "/libgluray-engine.so";
  for (const WalkedLibrary& library : walkLibraries(engine, pathsOf(listLibraries(engine)), readElf))
    if (library.path.empty())
      diagnosis.broken("install",
                       "library " + library.name + " is missing; " + library.neededBy + " needs it",
                       adviceForLibrary(library.name, host));
  if (static_cast<Health>(diagnosis.exitCode()) == before)
    diagnosis.ok("install", "complete: " + described(how, directory));
  return diagnosis.exitCode() < 2;
}

void examineMachine(Diagnosis& diagnosis) {
  const Surroundings here = surroundingsOfThisProcess();
  diagnosis.ok("machine", std::to_string(here.affinity) + " of " + std::to_string(here.hostCores) +
                              " cores usable, " + fixed(gigabytes("MemTotal"), 1) + " GB of memory, " +
                              fixed(gigabytes("MemAvailable"), 1) + " GB of it free");
  diagnosis.ok("threads", threadsText(here));
  const char* display = std::getenv("DISPLAY");
  if (display && *display)
    diagnosis.ok("display", display);
  else
    diagnosis.limited("display", "DISPLAY is not set: only programs that need no screen will work",
                      "xvfb-run -s '-screen 0 1280x1024x24' gluray ...");
}

void examineDrawing(const CommandLine& line, Diagnosis& diagnosis) {
  const char* display = std::getenv("DISPLAY");
  const std::string api = display && *display ? "glx" : "egl";
  const TemporaryFolder folder;
  reportProbe(api, runProbe(line, api, folder.path()), folder.path(), diagnosis);
}

}  // namespace gluray::launcher
