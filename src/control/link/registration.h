// The file that tells a hub, when it starts, about a program that is not connected: programs/PID in the
// runtime directory (docs/control-protocol.md). Any thread.
#pragma once
#include <cstdint>
#include <string>

namespace gluray::control {

struct Registration {
  std::string name;     // of the program
  std::string display;  // X display; empty: the program shows no window
  uint64_t window = 0;  // X id of a window that the program shows; 0: none
};

/// The path of this process's file.
std::string registrationFile(const std::string& directory);

/// Writes the file, and creates the runtime directory if it does not exist. Returns an error message; empty
/// on success.
std::string leaveRegistration(const std::string& directory, const Registration& registration);

}  // namespace gluray::control
