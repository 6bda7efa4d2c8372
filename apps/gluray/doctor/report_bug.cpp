#include "doctor/report_bug.h"

#include "base/files.h"
#include "base/printable.h"
#include "explain/watched_run.h"
#include "programs/doors.h"
#include "programs/launch.h"
#include "say.h"

#include <fcntl.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr size_t kMostReported = size_t{1} << 28;  // of files that are read whole

/// Runs a command whose output goes to the file. `logs`: where GLuRay writes its log; empty: nowhere. Returns
/// its exit code.
int run(const Words& words, const std::string& file, const std::string& logs = "") {
  std::cout.flush();
  const pid_t child = fork();
  if (child == 0) {
    const int out = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (out >= 0) dup2(out, STDOUT_FILENO), dup2(out, STDERR_FILENO);
    if (!logs.empty()) setenv("GLURAY_LOG", logs.c_str(), 1), setenv("GLURAY_LOG_LEVEL", "debug", 1);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(kNotFound);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return kNotExecutable;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The system, its libraries of OpenGL, and the variables that matter.
std::string systemText() {
  std::ostringstream text;
  utsname names{};
  uname(&names);
  text << "gluray " GLURAY_VERSION "\n"
       << names.sysname << ' ' << names.release << ' ' << names.machine << "\n\n";
  text << files::read("/etc/os-release", kMostReported).text << "\n";
  for (char** variable = environ; *variable; ++variable) {
    const std::string_view one = *variable;
    for (const char* start : {"GLURAY", "DISPLAY=", "WAYLAND_DISPLAY=", "LD_", "LIBGL", "MESA", "GALLIUM",
                              "__GLX", "__EGL", "VTK", "SLURM_CPUS", "OMP_NUM_THREADS=", "XDG_SESSION_TYPE="})
      if (one.starts_with(start)) text << printable(std::string(one)) << "\n";
  }
  return text.str();
}

/// The files of a report, in a folder.
struct Report {
  std::string folder;
  std::string file(const std::string& name) const { return folder + "/" + name; }

  void collect(const CommandLine& line) const {
    const std::string self = launcherFile();
    files::replace(file("system.txt"), systemText());
    Words doctor{self, "doctor", "--json"};
    if (!line.program.empty()) doctor.push_back(line.program.front());
    run(doctor, file("doctor.json"));
    run({self, "settings", "--changed", "--json"}, file("settings.json"));
    if (line.program.empty()) return;
    std::cout << "gluray: runs " << printable(line.program.front()) << ", for at most "
              << static_cast<int>(line.limitSeconds) << " seconds; use it until it shows the problem"
              << std::endl;
    Words explain{self,
                  "explain",
                  "--json",
                  "--frames",
                  std::to_string(line.frames),
                  "--seconds",
                  std::to_string(line.limitSeconds),
                  "--rest",
                  std::to_string(line.restSeconds)};
    for (const auto& [name, value] : line.settings.all())
      explain.push_back("--set"), explain.push_back(name + "=" + value);
    explain.push_back("--door"), explain.push_back(line.door), explain.push_back("--");
    explain.insert(explain.end(), line.program.begin(), line.program.end());
    const int code = run(explain, file("explain.json"), file("log.txt"));
    std::string command;
    for (const std::string& word : line.program) command += (command.empty() ? "" : " ") + word;
    files::replace(file("command.txt"),
                   command + "\nexit code of gluray explain: " + std::to_string(code) + "\n");
  }
};

void list(const std::string& folder) {
  std::vector<fs::directory_entry> all;
  for (const auto& entry : fs::directory_iterator(folder)) all.push_back(entry);
  std::sort(all.begin(), all.end());
  for (const fs::directory_entry& entry : all)
    std::cout << "  " << entry.path().filename().string() << ", " << entry.file_size() << " bytes\n";
}

}  // namespace

int reportBug(const CommandLine& line) {
  const std::string archive = line.archive.empty() ? "gluray-report.tar.gz" : line.archive;
  if (!archive.ends_with(".tar.gz"))
    return say(printable(archive) + ": use a name that ends in .tar.gz"), kUsageError;
  const auto failed = [&](const std::string& why) {
    return say(printable(archive) + " cannot be written: " + why), 1;
  };
  if (const std::string why = files::obstacle(archive); !why.empty()) return failed(why);
  const fs::path folder = fs::absolute(archive).parent_path();
  if (!fs::is_directory(folder)) return failed("there is no folder " + printable(folder.string()));
  const TemporaryFolder place;
  const Report report{place.path() + "/gluray-report"};
  fs::create_directory(report.folder);
  report.collect(line);
  std::cout << "The archive will hold:\n";
  list(report.folder);
  const std::string made = place.path() + "/report.tar.gz", said = place.path() + "/tar.txt";
  if (run({"tar", "-czf", made, "-C", place.path(), "gluray-report"}, said) != 0)
    return say("tar could not make the archive: " + files::read(said, kMostReported).text), 1;
  if (const std::string why = files::replace(archive, files::read(made, kMostReported).text); !why.empty())
    return failed(why);
  std::cout
      << printable(archive)
      << " is written; nothing was sent. It names your files and your user: look at it before you attach it "
      << "to an issue.\n";
  return 0;
}

}  // namespace gluray::launcher
