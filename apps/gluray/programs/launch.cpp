#include "programs/launch.h"

#include "programs/doors.h"
#include "say.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <thread>
#include <vector>

namespace gluray::launcher {

int failToStart(const std::string& program, int error) {
  say(program + ": " + (error == ENOENT ? "program not found" : std::strerror(error)));
  return error == ENOENT ? kNotFound : kNotExecutable;
}

/// openDoors(); any exception becomes its line, so that the program starts.
static std::string openDoorsOrSay(const CommandLine& line, const Program& program) {
  try {
    return openDoors(line, program);
  } catch (const std::exception& error) { return error.what(); }
}

int becomeProgram(const CommandLine& line, const Program& program) {
  if (program.usesX && !std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY"))
    say("DISPLAY is not set; without a screen, try: xvfb-run -s '-screen 0 1280x1024x24' gluray ...");
  if (const std::string why = openDoorsOrSay(line, program); !why.empty()) say("not ray traced: " + why);

  std::vector<char*> arguments;
  for (const std::string& word : line.program) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  if (program.path.empty()) {  // not found, but the kernel may know better
    execvp(line.program[0].c_str(), arguments.data());
    return failToStart(line.program[0], errno);
  }
  execv(program.path.c_str(), arguments.data());
  if (errno == ENOEXEC) {  // a script without #!: /bin/sh runs it, as in a shell
    arguments.insert(arguments.begin(), const_cast<char*>("/bin/sh"));
    arguments[1] = const_cast<char*>(program.path.c_str());
    execv("/bin/sh", arguments.data());
  }
  return failToStart(line.program[0], errno);
}

void Child::takeTerminal(pid_t group) const {
  if (!isatty(STDIN_FILENO)) return;
  struct sigaction ignore {
  }, before{};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGTTOU, &ignore, &before);  // tcsetpgrp would stop a background process
  tcsetpgrp(STDIN_FILENO, group);
  sigaction(SIGTTOU, &before, nullptr);
}

Child::Child(const CommandLine& line, const Program& program, const std::function<void()>& prepare)
    : pid_(fork()) {
  if (pid_ != 0) {
    if (pid_ > 0) setpgid(pid_, pid_);
    return;
  }
  setpgid(0, 0);
  takeTerminal(getpid());
  prepare();
  _exit(becomeProgram(line, program));
}

Child::~Child() { end(); }

bool Child::ended() {
  if (waited_ || pid_ < 0) return true;
  if (waitpid(pid_, &status_, WNOHANG) != pid_) return false;
  waited_ = true;
  takeTerminal(getpgrp());
  return true;
}

void Child::end() {
  constexpr std::chrono::milliseconds kStep{10};
  constexpr int kPatience = 500;  // steps
  if (ended()) return;
  kill(-pid_, SIGTERM);
  for (int i = 0; i < kPatience && !ended(); ++i) std::this_thread::sleep_for(kStep);
  if (waited_) return;
  kill(-pid_, SIGKILL);
  while (!ended()) std::this_thread::sleep_for(kStep);
}

int Child::exitCode() const {
  if (pid_ < 0) return kNotExecutable;
  return WIFSIGNALED(status_) ? 128 + WTERMSIG(status_) : WEXITSTATUS(status_);
}

}  // namespace gluray::launcher
