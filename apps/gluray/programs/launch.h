// Becoming the program, or running it and waiting.
#pragma once
#include "command_line.h"
#include "programs/program.h"

#include <sys/types.h>
#include <sys/wait.h>

#include <functional>

namespace gluray::launcher {

constexpr int kNotFound = 127, kNotExecutable = 126;

/// Tells the user why `program` cannot be started; the exit code that says so.
int failToStart(const std::string& program, int error);

/// Opens the doors and replaces this process by the program. Returns only on failure, with the exit code.
int becomeProgram(const CommandLine& line, const Program& program);

/// A program that was started and is not yet waited for: a process group of its own, which has the terminal.
class Child {
 public:
  /// Starts the program as `gluray` with these options would. `prepare` runs in the new process before that.
  Child(const CommandLine& line, const Program& program, const std::function<void()>& prepare);
  ~Child();  // ends it if it still runs
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  pid_t pid() const { return pid_; }
  /// Whether it has ended by itself.
  bool ended();
  /// Asks it to end (SIGTERM); where it has not after some seconds, ends it. Its whole process group.
  void end();
  /// The exit code as a shell has it; 128 + the signal that ended it.
  int exitCode() const;
  /// The signal that ended it; 0: none did.
  int signal() const { return WIFSIGNALED(status_) ? WTERMSIG(status_) : 0; }

 private:
  void takeTerminal(pid_t group) const;
  pid_t pid_ = -1;
  int status_ = 0;
  bool waited_ = false;
};

}  // namespace gluray::launcher
