#include "programs/program.h"

#include "programs/doors.h"
#include "programs/own_osmesa.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

namespace gluray::launcher {
namespace {

enum class Fitness : uint8_t { none, unknown, executable };

/// Whether the file at `path` may be executed. unknown: access() says no or is forbidden, but the file's mode
/// has execute permission. Sets error unless it is executable.
Fitness fitnessOf(const std::string& path, int& error) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    if (errno != ENOENT && errno != ENOTDIR) error = errno;
    return Fitness::none;
  }
  error = EACCES;
  if (!S_ISREG(status.st_mode)) return Fitness::none;
  if (access(path.c_str(), X_OK) == 0) return error = 0, Fitness::executable;
  return status.st_mode & 0111 ? Fitness::unknown : Fitness::none;
}

/// Sets path or error, searching as execvp does.
void search(const std::string& name, Program& program) {
  program.error = ENOENT;
  std::string unknown;
  const auto accept = [&](const std::string& path) {
    const Fitness fitness = fitnessOf(path, program.error);
    if (fitness == Fitness::unknown && unknown.empty()) unknown = path;
    if (fitness == Fitness::executable) program.path = path;
    return fitness == Fitness::executable;
  };
  if (name.find('/') != std::string::npos) {
    accept(name);
  } else {
    const char* path = std::getenv("PATH");
    std::istringstream directories(path ? path : "/bin:/usr/bin");
    for (std::string directory; std::getline(directories, directory, ':');)
      if (accept((directory.empty() ? "." : directory) + "/" + name)) return;
  }
  if (program.path.empty()) program.path = unknown;
  if (!program.path.empty()) program.error = 0;
}

/// The interpreter that a script's first line names; empty for other files.
std::string scriptInterpreter(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  std::getline(file, line);
  if (!line.starts_with("#!")) return "";
  std::string interpreter, argument;
  std::istringstream(line.substr(2)) >> interpreter >> argument;
  return interpreter.ends_with("/env") && !argument.empty() ? argument : interpreter;
}

}  // namespace

std::string listLibraries(const std::string& path) {
  int ends[2];
  if (pipe(ends) != 0) return "";
  const pid_t child = fork();
  if (child == 0) {
    setenv("LD_TRACE_LOADED_OBJECTS", "1", 1);
    unsetenv("LD_PRELOAD");
    dup2(ends[1], STDOUT_FILENO);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDERR_FILENO);
    const std::string loader = readElf(launcherFile()).interpreter;
    // A program names its loader; for a library, the launcher's own loader is used.
    if (readElf(path).interpreter.empty())
      execl(loader.c_str(), loader.c_str(), path.c_str(), static_cast<char*>(nullptr));
    else
      execl(path.c_str(), path.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[1]);
  std::string text;
  char buffer[4096];
  for (ssize_t bytes; child > 0 && (bytes = read(ends[0], buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<size_t>(bytes));
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  return text;
}

void readLibraryList(const std::string& list, Program& program) {
  bool gl = false, glvnd = false;
  std::istringstream lines(list);
  for (std::string line; std::getline(lines, line);) {
    std::string name, arrow, path;
    std::istringstream(line) >> name >> arrow >> path;
    if (name.starts_with("libOSMesa.so") && !isOwnOsMesa(path)) program.osMesa = true;
    if (name.starts_with("libGL.so")) gl = true;
    if (name.starts_with("libGLdispatch.so")) glvnd = true;
    if (name.starts_with("libX11.so") || name.starts_with("libGL.so") || name.starts_with("libGLX.so"))
      program.usesX = true;
  }
  program.bundledGl = gl && !glvnd;
}

std::string privilegeOf(const std::string& path, const struct stat& status) {
  if ((status.st_mode & S_ISUID) && status.st_uid != getuid()) return "is set-uid";
  if ((status.st_mode & S_ISGID) && status.st_gid != getgid()) return "is set-gid";
  if (getuid() != 0 && getxattr(path.c_str(), "security.capability", nullptr, 0) > 0)
    return "has file capabilities";
  return "";
}

Program inspect(const std::string& name) {
  Program program;
  search(name, program);
  if (program.path.empty()) return program;
  struct stat status {};
  if (stat(program.path.c_str(), &status) == 0) program.privilege = privilegeOf(program.path, status);
  program.elf = readElf(program.path);
  // Lists only programs that name a loader: a static one would really run.
  if (program.privilege.empty() && !program.elf.interpreter.empty())
    readLibraryList(program.libraries = listLibraries(program.path), program);
  if (!program.elf.elf) program.interpreter = scriptInterpreter(program.path);
  return program;
}

}  // namespace gluray::launcher
