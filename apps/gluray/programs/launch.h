// Starts the program: in place of this process, or as a child.
#pragma once
#include "command_line.h"
#include "programs/program.h"

#include <sys/types.h>
#include <sys/wait.h>

#include <functional>

namespace gluray::launcher {

constexpr int kNotFound = 127, kNotExecutable = 126;

/// Prints why `program` cannot be started; returns kNotFound or kNotExecutable.
int failToStart(const std::string& program, int error);

/// Opens the doors and replaces this process by the program. Returns only on failure, with the exit code.
int becomeProgram(const CommandLine& line, const Program& program);

/// A running program, in a process group of its own that has the terminal.
class Child {
 public:
  /// Starts the program as `gluray` with these options would. `prepare` runs first, in the new process.
  Child(const CommandLine& line, const Program& program, const std::function<void()>& prepare);
  ~Child();  // ends it if it still runs
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  pid_t pid() const { return pid_; }
  /// Whether it has ended.
  bool ended();
  /// Sends SIGTERM to its process group, and SIGKILL if it has not ended after five seconds.
  void end();
  /// The exit code as in a shell: 128 + the signal if one ended it.
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
