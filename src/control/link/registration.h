// The file that tells a starting hub about a program that is not connected: programs/PID in the runtime
// directory (docs/control-protocol.md). Any thread.
#pragma once
#include <cstdint>
#include <string>

namespace gluray::control {

struct Registration {
  std::string name;     // of the program
  std::string display;  // of the X server; empty: the program shows no window
  uint64_t window = 0;  // X's name of a window that the program shows; 0: it shows none
};

/// The path of this process's file.
std::string registrationFile(const std::string& directory);

/// Writes it, and creates the runtime directory if there is none. Returns why not; empty: done.
std::string leaveRegistration(const std::string& directory, const Registration& registration);

}  // namespace gluray::control
